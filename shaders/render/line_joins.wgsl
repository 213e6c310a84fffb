// The wedge on the outer side of a turn between two segments. Twin of the instance: crates/render/src/lines/line_joins.rs

#import "render/line_visibility.wgsl"

struct JoinInstance {
    // The corner in target pixels with its depth-buffer value.
    @location(0) corner: vec3<f32>,
    // The segments' other ends: where the stroke comes from, where it goes to.
    @location(1) before: vec3<f32>,
    @location(2) after: vec3<f32>,
}

struct JoinVertex {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) corner: vec3<f32>,
    @location(1) @interpolate(flat) before: vec3<f32>,
    @location(2) @interpolate(flat) after: vec3<f32>,
    // From the corner: along the incoming direction, against the outgoing one.
    @location(3) @interpolate(linear) beyond: vec2<f32>,
    // From the corner: outwards from the incoming stroke, from the outgoing one.
    @location(4) @interpolate(linear) across: vec2<f32>,
    // From the corner: along the wedge's axis, across it.
    @location(5) @interpolate(linear) local: vec2<f32>,
    // Radius of the wedge, cosine of half the turn.
    @location(6) @interpolate(flat) wedge: vec2<f32>,
}

// Wedges reach this far into the strokes, so that rounding leaves no pixel between them.
const OVERLAP_PX: f32 = 0.05;

@vertex
fn join_vertex(@builtin(vertex_index) index: u32, join: JoinInstance) -> JoinVertex {
    let incoming = normalize(join.corner.xy - join.before.xy);
    let outgoing = normalize(join.after.xy - join.corner.xy);
    // A turn to the left (y is down) leaves its gap on the right and the other way round.
    let turn = incoming.y * outgoing.x - incoming.x * outgoing.y;
    let radius = select(max(style.span_px.y, 0.0), max(-style.span_px.x, 0.0), turn > 0.0);
    let side = select(1.0, -1.0, turn > 0.0);
    let outward_in = side * vec2<f32>(incoming.y, -incoming.x);
    let outward_out = side * vec2<f32>(outgoing.y, -outgoing.x);
    let axis = normalize(incoming - outgoing);
    let half_cos = dot(axis, outward_in);

    // Cover the wedge: along its axis up to the miter's tip or the round's radius, across by the radius.
    let miters = style.join == 1u && half_cos * style.miter_limit >= 1.0;
    let reach = select(radius, radius / max(half_cos, 1e-6), miters);
    let sideways = vec2<f32>(-axis.y, axis.x) * (radius + OVERLAP_PX) * select(-1.0, 1.0, (index & 1u) == 1u);
    let p = sideways + axis * select(-OVERLAP_PX, reach, index >= 2u);

    var out: JoinVertex;
    out.position = pixel_position(join.corner.xy + p);
    out.corner = join.corner;
    out.before = join.before;
    out.after = join.after;
    out.beyond = vec2<f32>(dot(p, incoming), -dot(p, outgoing));
    out.across = vec2<f32>(dot(p, outward_in), dot(p, outward_out));
    out.local = vec2<f32>(dot(p, axis), dot(p, vec2<f32>(-axis.y, axis.x)));
    out.wedge = vec2<f32>(radius, half_cos);
    return out;
}

@fragment
fn join_fragment(in: JoinVertex) -> @location(0) vec4<f32> {
    let radius = in.wedge.x;
    let half_cos = in.wedge.y;
    var inside = all(in.beyond >= vec2<f32>(-OVERLAP_PX)) && radius > 0.0;
    if style.join == 0u {
        inside = inside && dot(in.local, in.local) <= radius * radius;
    } else if style.join == 1u && half_cos * style.miter_limit >= 1.0 {
        inside = inside && all(in.across <= vec2<f32>(radius));
    } else {
        inside = inside && in.local.x <= radius * half_cos;
    }
    if !inside {
        discard;
    }
    if style.hide != 0u && !visible_at(in.corner.xy, in.before, in.corner) && !visible_at(in.corner.xy, in.corner, in.after) {
        discard;
    }
    return style.color;
}
