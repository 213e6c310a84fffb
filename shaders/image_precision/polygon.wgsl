// A convex polygon in the shape of the mesh: its corners' middle and its normal.

#import "shared/mesh.wgsl"
#import "image_precision/style.wgsl"
#import "image_precision/fattened.wgsl"

struct Polygon {
    first: u32,
    size: u32,
    middle: vec3<f32>,
    // Unit, or zero where the polygon has no area that 32 bits can hold.
    normal: vec3<f32>,
}

// Position of a corner in the shape.
fn shaped_corner(corner: u32) -> vec3<f32> {
    return shaped(corner_position(corner));
}

fn unit_or_zero(v: vec3<f32>) -> vec3<f32> {
    let length_v = length(v);
    return select(vec3<f32>(0.0), v / length_v, length_v > 0.0);
}

// First corner of a polygon, and of the one after it. Triangles lie one after another; others have their starts in a table.
fn corner_range(index: u32) -> vec2<u32> {
    if style.polygon_corners != 0u {
        return vec2<u32>(index, index + 1u) * style.polygon_corners;
    }
    return vec2<u32>(starts[index], starts[index + 1u]);
}

fn polygon(range: vec2<u32>) -> Polygon {
    let size = range.y - range.x;
    var sum = vec3<f32>(0.0);
    // Newell's: twice the area long.
    var normal = vec3<f32>(0.0);
    let origin = shaped_corner(range.x);
    var last = shaped_corner(range.y - 1u) - origin;
    for (var corner = range.x; corner < range.y; corner++) {
        let p = shaped_corner(corner) - origin;
        sum += p;
        normal += cross(last, p);
        last = p;
    }
    return Polygon(range.x, size, origin + sum / f32(size), unit_or_zero(normal));
}

// The same for a triangle whose corners are at hand.
fn triangle(first: u32, a: vec3<f32>, b: vec3<f32>, c: vec3<f32>) -> Polygon {
    return Polygon(first, 3u, a + ((b - a) + (c - a)) / 3.0, unit_or_zero(cross(b - a, c - a)));
}

// V.N at its middle, towards the viewer. N is outward, as the mesh has it; a mirror image runs the other way round its corners.
fn polygon_facing(p: Polygon) -> f32 {
    return style.shape_sign * dot(p.normal, unit_or_zero(towards_viewer(p.middle)));
}
