// Vertices and triangles of the polygons that are fattened.
// Twin: crates/image_precision/src/fatten_list.rs
//
// A polygon of n corners has 2 n + 1 vertices, at a place of its own: its middle, and the ends of each pushed edge. The paper
// draws 2 n triangles about the middle. Where the fattened polygon is convex, 2 n - 2 about its first vertex cover the same;
// polygons are convex themselves, so that turning left at every vertex tells it.

// The polygons: their number, and their own numbers.
@group(2) @binding(0) var<storage, read> faces: array<u32>;
@group(2) @binding(1) var<storage, read_write> arguments: array<atomic<u32>>;
@group(2) @binding(2) var<storage, read> starts: array<u32>;
// Clip space.
@group(2) @binding(3) var<storage, read_write> places: array<vec4<f32>>;
@group(2) @binding(4) var<storage, read_write> notes: array<u32>;
@group(2) @binding(5) var<storage, read_write> indices: array<u32>;

// What `style.noted` says where notes of vertices are levels.
const NOTED_LEVEL: u32 = 1u;

// Whether two successive pushed edges make a fattened polygon turn left, before the bevel between them and after it.
fn bevels_left(edge: vec3<f32>, pushed: vec3<f32>, next_edge: vec3<f32>, next_pushed: vec3<f32>, n: vec3<f32>) -> bool {
    let bevel = next_pushed - pushed;
    return dot(cross(edge, bevel), n) >= 0.0 && dot(cross(bevel, next_edge), n) >= 0.0;
}

// Yields the clip-space position.
fn place(vertex: u32, position: vec3<f32>, note: u32) -> vec4<f32> {
    let clip = clip_position(position);
    places[vertex] = clip;
    if style.noted != 0u {
        notes[vertex] = note;
    }
    return clip;
}

// Whether the edge from a to b is nearer to level than to upright in the image.
fn level_of(a: vec3<f32>, b: vec3<f32>) -> u32 {
    let ends = array<vec4<f32>, 2>(clip_position(a), clip_position(b));
    return is_level(0.5 * style.viewport_px * (ends[1].xy / ends[1].w - ends[0].xy / ends[0].w));
}

struct Placed {
    is_convex: bool,
    box: Box,
}

// Places the vertices of a polygon.
fn place_polygon(p: Polygon, middle: u32, facing: f32) -> Placed {
    var note = bitcast<u32>(facing);
    var box = with_point(EMPTY, place(middle, p.middle, note));
    let origin = corner_position(p.first);
    var a = origin;
    var first_edge: vec3<f32>;
    var first_pushed: vec3<f32>;
    var last_edge: vec3<f32>;
    var last_pushed: vec3<f32>;
    var is_convex = true;
    for (var corner = 0u; corner < p.size; corner++) {
        var b = origin;
        if corner + 1u < p.size {
            b = corner_position(p.first + corner + 1u);
        }
        let edge = b - a;
        let pushed = push(a, b, p);
        if style.noted == NOTED_LEVEL {
            note = level_of(a, b);
        }
        box = with_point(box, place(middle + 1u + 2u * corner, a + pushed, note));
        box = with_point(box, place(middle + 2u + 2u * corner, b + pushed, note));
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
    is_convex = is_convex && bevels_left(last_edge, last_pushed, first_edge, first_pushed, p.normal);
    return Placed(is_convex, box);
}

fn fatten(index: u32) {
    let p = polygon(corner_range(index));
    let middle = 2u * p.first + index;
    let rim = middle + 1u;
    let placed = place_polygon(p, middle, polygon_facing(p));
    if is_hidden(placed.box) {
        return;
    }
    // Textures run along edges, so that each keeps its own two triangles; the printed law keeps the printed fan.
    let is_rim = placed.is_convex && style.noted != NOTED_LEVEL && style.law != 1u;
    let sides = 2u * p.size;
    let triangles = select(sides, sides - 2u, is_rim);
    let first = atomicAdd(&arguments[0], 3u * triangles);
    for (var step = 0u; step < triangles; step++) {
        // The first vertex of a triangle tells its note: that of the edge which it begins or ends.
        let begin = step + select(0u, 1u, is_rim);
        let at = first + 3u * step;
        indices[at] = rim + begin;
        indices[at + 1u] = rim + select(begin + 1u, 0u, begin + 1u == sides);
        indices[at + 2u] = select(middle, rim, is_rim);
    }
}

@compute @workgroup_size(64)
fn fatten_polygons(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    for (var at = id.x; at < faces[0]; at += groups.x * 64u) {
        fatten(faces[at + 1u]);
    }
}
