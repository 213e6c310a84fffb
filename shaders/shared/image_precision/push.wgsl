// How far section 3.3 of Raskar and Cohen 1999 pushes the edges of a polygon. Twin: crates/image_precision/src/fatten.rs

// Never move an edge by more than this many times its depth: nearly edge-on polygons would have it without bound.
const FARTHEST: f32 = 4.0;

// By how much the edge from a to b of a polygon is pushed outwards, as a vector in its plane.
fn push(a: vec3<f32>, b: vec3<f32>, p: Polygon) -> vec3<f32> {
    let edge = b - a;
    let length_edge = length(edge);
    let length_normal = length(p.normal);
    if length_edge == 0.0 || length_normal == 0.0 {
        return vec3<f32>(0.0);
    }
    let e = edge / length_edge;
    let n = p.normal / length_normal;
    let outward = cross(e, n);
    let middle = 0.5 * (a + b);
    let ray = -towards_viewer(middle);
    let v = normalize(ray);
    let is_perspective = style.eye.w != 0.0;
    let depth = select(1.0, dot(ray, style.axis.xyz), is_perspective);
    let width = max(style.reach.x + style.reach.y / depth, 0.0);
    let v_n = abs(dot(v, n));
    let sine = length(cross(v, e));
    var delta = 0.0;
    if style.law == 0u {
        // The exact law: m leans towards the axis as the edge is seen aslant of the image plane.
        let m = dot(normalize(cross(v, e)), style.axis.xyz);
        let s = sine * sqrt(max(1.0 - m * m, 0.0));
        let recedes = select(0.0, dot(outward, style.axis.xyz), is_perspective);
        let room = style.axis.w * v_n - width * recedes * s;
        delta = select(FARTHEST * depth, width * depth * s / room, room > 0.0);
    } else {
        // As printed: z is the distance from the camera.
        let z = select(1.0, length(ray), is_perspective);
        delta = width / style.axis.w * z * select(1.0, sine, style.law == 1u) / max(v_n, 1e-12);
    }
    delta = min(delta, FARTHEST * depth);
    if style.clamp_edges > 0.0 {
        delta = min(delta, style.clamp_edges * length_edge);
    }
    return outward * delta;
}
