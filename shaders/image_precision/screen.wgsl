// Lines as wide as asked for, expanded in the image plane. Twin: crates/image_precision/src/screen.rs
//
// A listed edge is a quad beside the projected edge, its outer corners drawn out a little, and a fan around either end. All
// of it has the depth of the edge.

@group(2) @binding(0) var<storage, read> listed: array<u32>;

struct LineVertex {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) level: u32,
}

const NOTHING: LineVertex = LineVertex(vec4<f32>(2.0, 2.0, 0.0, 1.0), 0u);

// Corners of the two triangles of a quad: x 0 at a, 1 at b; y 0 lowest, 1 highest.
const QUAD: array<vec2<f32>, 6> = array<vec2<f32>, 6>(
    vec2<f32>(0.0, 0.0), vec2<f32>(1.0, 0.0), vec2<f32>(0.0, 1.0),
    vec2<f32>(0.0, 1.0), vec2<f32>(1.0, 0.0), vec2<f32>(1.0, 1.0),
);

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

fn span_px(w: f32, outward: vec2<f32>) -> vec2<f32> {
    return (style.span.xy + style.span.zw / w) * (1.0 - max(dot(outward, style.light), 0.0));
}

// A vertex of the line from a to b, whose ink lies to the left of that way where the span is positive.
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
    let fan_vertices = 3u * style.fan;
    let fan = (vertex - 6u) % max(fan_vertices, 1u);
    let corner = QUAD[min(vertex, 5u)];
    let of_b = select(vertex >= 6u + fan_vertices, corner.x > 0.5, vertex < 6u);
    let anchor = select(a, b, of_b);
    let beyond = select(-direction, direction, of_b);
    let span = span_px(anchor.w, left);
    var offset = vec2<f32>(0.0);
    if vertex < 6u {
        let across = mix(span.x, span.y, corner.y);
        offset = left * across + beyond * (abs(across) * style.corner);
    } else if fan % 3u != 0u {
        // From the outer corner of the quad round to straight ahead, or where ink lies on both sides to the other corner.
        let step = fan / 3u + fan % 3u - 1u;
        let is_centred = span.x < 0.0;
        let at_corner = step == 0u || (is_centred && step == style.fan);
        let first = atan(style.corner);
        let sweep = select(1.5707964 - first, 3.1415927 - 2.0 * first, is_centred);
        let turn = first + sweep * f32(step) / f32(style.fan);
        let radius = span.y * select(1.0, sqrt(1.0 + style.corner * style.corner), at_corner);
        offset = (cos(turn) * left + sin(turn) * beyond) * radius;
    }
    let ndc = anchor.xy / anchor.w + 2.0 * offset / style.viewport_px;
    return LineVertex(vec4<f32>(ndc * anchor.w, anchor.z + style.lift * anchor.w, anchor.w), is_level(way));
}

@vertex
fn line_of_edge(@builtin(vertex_index) index: u32) -> LineVertex {
    let vertices = vertices_per_line();
    let corner = listed[index / vertices];
    let a = corner_position(corner);
    let b = corner_position(next_corner(corner));
    // A back face lies to the right of its edges in the image, so that left is outwards.
    let is_back = front_volume(corner / 3u) <= 0.0;
    return line_vertex(index % vertices, clip_position(select(b, a, is_back)), clip_position(select(a, b, is_back)));
}

// Lines given by pairs of vertices, one after another.
@vertex
fn line_of_pair(@builtin(vertex_index) index: u32) -> LineVertex {
    let vertices = vertices_per_line();
    let pair = 2u * (index / vertices);
    let a = clip_position(vertex_position(listed[pair]));
    return line_vertex(index % vertices, a, clip_position(vertex_position(listed[pair + 1u])));
}

@fragment
fn line_fragment(in: LineVertex) -> @location(0) vec4<f32> {
    if is_blank(in.level, in.position.xy) {
        discard;
    }
    return faded_ink(1.0 / in.position.w);
}
