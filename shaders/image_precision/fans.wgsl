// Fans of fattened polygons that are not drawn as cut triangles. Twin: crates/image_precision/src/fans.rs
//
// A polygon of n corners has 2 n + 1 vertices, its middle and the ends of each pushed edge. The paper draws 2 n triangles about
// the middle. Where the fattened polygon is convex, 2 n - 2 about its first vertex cover the same; polygons are convex
// themselves, so that it is convex if it turns left at every vertex.

#import "shared/camera.wgsl"
#import "shared/invocation.wgsl"
#import "image_precision/fattened.wgsl"
#import "image_precision/polygon.wgsl"
#import "image_precision/push.wgsl"

#import "shared/camera.wgsl"
#import "shared/invocation.wgsl"
#import "image_precision/fattened.wgsl"
#import "image_precision/polygon.wgsl"
#import "image_precision/push.wgsl"

fn place(vertex: u32, position: vec3<f32>, note: u32) {
    places[vertex] = style.shape_to_clip * vec4<f32>(position, 1.0);
    if style.noted != 0u {
        notes[vertex] = note;
    }
}

// Whether the edge from a to b is nearer to level than to upright in the image.
fn level_of(a: vec3<f32>, b: vec3<f32>) -> u32 {
    let ends = array<vec4<f32>, 2>(style.shape_to_clip * vec4<f32>(a, 1.0), style.shape_to_clip * vec4<f32>(b, 1.0));
    return is_level(0.5 * style.line.shape.viewport_px * (ends[1].xy / ends[1].w - ends[0].xy / ends[0].w));
}

// By how much the edge from a to b of a polygon is pushed, as a vector in its plane.
fn push_edge(a: vec3<f32>, b: vec3<f32>, p: Polygon) -> vec3<f32> {
    let edge = b - a;
    let length_edge = length(edge);
    if length_edge == 0.0 {
        return vec3<f32>(0.0);
    }
    let e = edge / length_edge;
    return cross(e, p.normal) * push(0.5 * (a + b), e, length_edge, p.normal);
}

fn is_left(way: vec3<f32>, next: vec3<f32>, n: vec3<f32>) -> bool {
    return dot(cross(way, next), n) >= 0.0;
}

// Whether two successive pushed edges make a fattened polygon turn left, before the bevel between them and after it.
fn bevels_left(edge: vec3<f32>, pushed: vec3<f32>, next_edge: vec3<f32>, next_pushed: vec3<f32>, n: vec3<f32>) -> bool {
    let bevel = next_pushed - pushed;
    return is_left(edge, bevel, n) && is_left(bevel, next_edge, n);
}

// Places the vertices of a fan, and yields whether what it covers is convex.
fn place_fan(p: Polygon, middle: u32, facing: f32) -> bool {
    var note = bitcast<u32>(facing);
    place(middle, p.middle, note);
    let origin = shaped_corner(p.first);
    var a = origin;
    var first_edge: vec3<f32>;
    var first_pushed: vec3<f32>;
    var last_edge: vec3<f32>;
    var last_pushed: vec3<f32>;
    var is_convex = true;
    for (var corner = 0u; corner < p.size; corner++) {
        var b = origin;
        if corner + 1u < p.size {
            b = shaped_corner(p.first + corner + 1u);
        }
        let edge = b - a;
        let pushed = push_edge(a, b, p);
        if style.noted == NOTED_LEVEL {
            note = level_of(a, b);
        }
        place(middle + 1u + 2u * corner, a + pushed, note);
        place(middle + 2u + 2u * corner, b + pushed, note);
        if corner == 0u {
            first_edge = edge;
            first_pushed = pushed;
        } else {
            is_convex = is_convex && bevels_left(last_edge, last_pushed, edge, pushed, p.normal);
        }
        last_edge = edge;
        last_pushed = pushed;
        a = b;
    }
    return is_convex && bevels_left(last_edge, last_pushed, first_edge, first_pushed, p.normal);
}

fn list_fan(p: Polygon, facing: f32) {
    let sides = 2u * p.size;
    let taken = atomicAdd(&arguments[FAN_PLACES], sides + 1u) + sides + 1u;
    let middle = arrayLength(&places) - taken;
    let rim = middle + 1u;
    let is_convex = place_fan(p, middle, facing);
    // Textures run along edges, so that each keeps its own two triangles; the printed law keeps the printed fan.
    let is_rim = is_convex && style.noted != NOTED_LEVEL && style.law != AS_PRINTED;
    let triangles = select(sides, sides - 2u, is_rim);
    let first = atomicAdd(&arguments[FAN_INDICES], 3u * triangles);
    for (var step = 0u; step < triangles; step++) {
        // A triangle has the note of its first vertex: that of the edge which this vertex begins or ends.
        let begin = step + select(0u, 1u, is_rim);
        let at = first + 3u * step;
        indices[at] = rim + begin;
        indices[at + 1u] = rim + select(begin + 1u, 0u, begin + 1u == sides);
        indices[at + 2u] = select(middle, rim, is_rim);
    }
}

// A stage of its own: in lockstep, all triangles would wait for the few that become fans.
@compute @workgroup_size(WORKGROUP)
fn fan_rest(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let count = atomicLoad(&arguments[REST]);
    for (var at = id.x; at < count; at += row(groups)) {
        let p = polygon(corner_range(rest[at]));
        let facing = polygon_facing(p);
        if is_fattened(facing) {
            list_fan(p, facing);
        }
    }
}
