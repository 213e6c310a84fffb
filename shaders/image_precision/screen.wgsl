// Lines as wide as asked for, expanded in the image plane. Twin: crates/image_precision/src/screen.rs
//
// A listed edge is a convex polygon in the image: around its end, along its far side, around its begin. Where its ink lies on
// one side, the edge itself is the last side of the polygon.

@group(2) @binding(0) var<storage, read> listed: array<u32>;

struct LineVertex {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) level: u32,
}

const NOTHING: LineVertex = LineVertex(vec4<f32>(2.0, 2.0, 0.0, 1.0), 0u);

fn pixel_of(clip: vec4<f32>) -> vec2<f32> {
    return clip.xy / clip.w * 0.5 * style.viewport_px;
}

// The begin of a line moved onto the near plane, where it is before it.
fn clipped(begin: vec4<f32>, end: vec4<f32>) -> vec4<f32> {
    if begin.w >= style.near_w {
        return begin;
    }
    return mix(begin, end, (style.near_w - begin.w) / (end.w - begin.w));
}

fn reach_px(w: f32, outward: vec2<f32>) -> f32 {
    return (style.reach.x + style.reach.y / w) * (1.0 - max(dot(outward, style.light), 0.0));
}

// A vertex of the line between two positions in clip space, whose ink lies to the left of that way.
fn line_vertex(vertex: u32, from_clip: vec4<f32>, to_clip: vec4<f32>) -> LineVertex {
    if max(from_clip.w, to_clip.w) <= style.near_w {
        return NOTHING;
    }
    let a = clipped(from_clip, to_clip);
    let b = clipped(to_clip, from_clip);
    let way = pixel_of(b) - pixel_of(a);
    let length_px = length(way);
    // Ends at one point, or values beyond 32 bits, are no line; the comparison also refuses what is no number.
    if !(length_px > 1e-5 && length_px < 1e30) {
        return NOTHING;
    }
    let direction = way / length_px;
    let left = vec2<f32>(-direction.y, direction.x);
    // Triangles go round the polygon about its first point.
    let point = select(vertex / 3u + vertex % 3u, 0u, vertex % 3u == 0u);
    let of_b = point <= style.end_sides;
    let anchor = select(a, b, of_b);
    let rim = style.rim[select(point - style.end_sides - 1u, style.end_sides - point, of_b)].xy * reach_px(anchor.w, left);
    let beyond = select(-direction, direction, of_b);
    let ndc = anchor.xy / anchor.w + 2.0 * (rim.x * left + rim.y * beyond) / style.viewport_px;
    // The depth of either end around it, and between them from the one to the other.
    let z = clamp(anchor.z / anchor.w + style.lift, 0.0, 1.0);
    return LineVertex(vec4<f32>(ndc, z, 1.0) * anchor.w, is_level(way));
}

@vertex
fn line_of_edge(@builtin(vertex_index) index: u32) -> LineVertex {
    let vertices = vertices_per_line();
    let edge = listed[index / vertices];
    let corner = edge & ~FRONT;
    let a = corner_position(corner);
    let b = corner_position(next_corner(corner));
    // A back face lies to the right of its edges in the image, so that left is outwards.
    let is_front = (edge & FRONT) != 0u;
    let begin = clip_position(select(a, b, is_front));
    return line_vertex(index % vertices, begin, clip_position(select(b, a, is_front)));
}

// Lines given by pairs of vertices, one after another.
@vertex
fn line_of_pair(@builtin(vertex_index) index: u32) -> LineVertex {
    let vertices = vertices_per_line();
    let pair = 2u * (index / vertices);
    let begin = clip_position(vertex_position(listed[pair]));
    return line_vertex(index % vertices, begin, clip_position(vertex_position(listed[pair + 1u])));
}

@fragment
fn textured_fragment(in: LineVertex) -> @location(0) vec4<f32> {
    if is_blank(in.level, in.position.xy) {
        discard;
    }
    return faded_ink(1.0 / in.position.w);
}
