// Lists fattened triangles as cut triangles, and all other polygons for `fans.wgsl`.
// Twin: crates/image_precision/src/cut_triangles.rs

#import "shared/camera.wgsl"
#import "shared/invocation.wgsl"
#import "image_precision/fattened.wgsl"
#import "image_precision/polygon.wgsl"
#import "image_precision/push.wgsl"
#import "image_precision/cut_triangle.wgsl"

// The plane of a triangle: its origin is the triangle's middle, its x axis runs along the first edge.
struct Plane {
    middle: vec3<f32>,
    x: vec3<f32>,
    y: vec3<f32>,
    normal: vec3<f32>,
}

fn in_plane(plane: Plane, p: vec3<f32>) -> vec2<f32> {
    return vec2<f32>(dot(p - plane.middle, plane.x), dot(p - plane.middle, plane.y));
}

// By how much the edge between two corners is pushed.
fn push_in(plane: Plane, begin: vec2<f32>, end: vec2<f32>) -> vec2<f32> {
    let edge = end - begin;
    let length_edge = length(edge);
    if length_edge == 0.0 {
        return vec2<f32>(0.0);
    }
    let e = edge / length_edge;
    let half = 0.5 * (begin + end);
    let middle = plane.middle + plane.x * half.x + plane.y * half.y;
    return vec2<f32>(e.y, -e.x) * push(middle, plane.x * e.x + plane.y * e.y, length_edge, plane.normal);
}

// `axes`: those of the plane and its origin, in clip space.
fn place_cut(at: u32, axes: mat3x4<f32>, hexagon: Hexagon, corner: vec2<f32>, facing: f32) {
    places[at] = axes * vec3<f32>(corner, 1.0);
    places[at + 1u] = vec4<f32>(inside(hexagon, corner), facing);
}

// Lists a triangle with corners a, b and c as one that is cut, where that is worth it.
fn list_cut(p: Polygon, a: vec3<f32>, b: vec3<f32>, c: vec3<f32>, facing: f32) -> bool {
    let x = unit_or_zero(b - a);
    let plane = Plane(p.middle, x, cross(p.normal, x), p.normal);
    let corners = array<vec2<f32>, 3>(in_plane(plane, a), in_plane(plane, b), in_plane(plane, c));
    let ab = push_in(plane, corners[0], corners[1]);
    let bc = push_in(plane, corners[1], corners[2]);
    let ca = push_in(plane, corners[2], corners[0]);
    let cut = cut_triangle(Hexagon(
        corners[0] + ab,
        corners[1] + ab,
        corners[1] + bc,
        corners[2] + bc,
        corners[2] + ca,
        corners[0] + ca,
    ));
    if !cut.is_found {
        return false;
    }
    let axes = style.shape_to_clip * mat3x4<f32>(vec4<f32>(plane.x, 0.0), vec4<f32>(plane.y, 0.0), vec4<f32>(p.middle, 1.0));
    let at = 2u * atomicAdd(&arguments[CUT_VERTICES], 3u);
    place_cut(at, axes, cut.hexagon, cut.around.bc, facing);
    place_cut(at + 2u, axes, cut.hexagon, cut.around.de, facing);
    place_cut(at + 4u, axes, cut.hexagon, cut.around.fa, facing);
    return true;
}

@compute @workgroup_size(WORKGROUP)
fn cut_triangles(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let index = element(id, groups);
    if index >= style.faces {
        return;
    }
    let range = corner_range(index);
    let is_triangle = range.y - range.x == 3u;
    let a = shaped_corner(range.x);
    let b = shaped_corner(range.x + 1u);
    let c = shaped_corner(range.x + 2u);
    let p = triangle(range.x, a, b, c);
    let facing = polygon_facing(p);
    // Facing of other polygons is that of all of their corners.
    let may_be_fattened = is_fattened(facing) || !is_triangle;
    let may_be_cut = is_triangle && is_fattened(facing) && style.most_around > 0.0;
    let is_cut = may_be_cut && list_cut(p, a, b, c, facing);
    if may_be_fattened && !is_cut {
        rest[atomicAdd(&arguments[REST], 1u)] = index;
    }
}
