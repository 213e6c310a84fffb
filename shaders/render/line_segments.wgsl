// Strokes of single segments as quads. Twin of the instance: crates/render/src/lines/line_segments.rs

#import "render/line_visibility.wgsl"

struct SegmentInstance {
    // Ends in target pixels with their depth-buffer values.
    @location(0) a: vec3<f32>,
    @location(1) b: vec3<f32>,
    // Bit 0: round cap at a, bit 1: at b.
    @location(2) caps: u32,
}

struct SegmentVertex {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) a: vec3<f32>,
    @location(1) @interpolate(flat) b: vec3<f32>,
    // Along the segment from a and to its left, in pixels.
    @location(2) @interpolate(linear) local: vec2<f32>,
}

@vertex
fn segment_vertex(@builtin(vertex_index) index: u32, segment: SegmentInstance) -> SegmentVertex {
    let d = segment.b.xy - segment.a.xy;
    let len = length(d);
    let forward = select(vec2<f32>(1.0, 0.0), d / max(len, 1e-12), len > 0.0);
    let left = vec2<f32>(forward.y, -forward.x);
    let radius = (style.span_px.y - style.span_px.x) * 0.5;
    let at_b = (index & 1u) == 1u;
    let cap = select(0.0, radius, (segment.caps & (1u + (index & 1u))) != 0u);
    var out: SegmentVertex;
    out.local.x = select(-cap, len + cap, at_b);
    out.local.y = select(style.span_px.x, style.span_px.y, index >= 2u);
    out.position = pixel_position(segment.a.xy + forward * out.local.x + left * out.local.y);
    out.a = segment.a;
    out.b = segment.b;
    return out;
}

@fragment
fn segment_fragment(in: SegmentVertex) -> @location(0) vec4<f32> {
    // Round off what lies beyond the ends.
    let len = length(in.b.xy - in.a.xy);
    let beyond = max(-in.local.x, in.local.x - len);
    let radius = (style.span_px.y - style.span_px.x) * 0.5;
    let across = in.local.y - (style.span_px.x + style.span_px.y) * 0.5;
    if beyond > 0.0 && beyond * beyond + across * across > radius * radius {
        discard;
    }
    if style.hide != 0u && !visible_at(in.position.xy, in.a, in.b) {
        discard;
    }
    return style.color;
}
