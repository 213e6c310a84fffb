// How far section 3.3 of Raskar and Cohen 1999 pushes the edges of a polygon. Twin: crates/image_precision/src/fatten.rs

#import "image_precision/style.wgsl"

// Never move an edge by more than this many times its depth: nearly edge-on polygons would have it without bound.
const FARTHEST: f32 = 4.0;

// How far an edge of a polygon with unit normal n is pushed outwards, its middle, unit direction and length given.
fn push(middle: vec3<f32>, e: vec3<f32>, length_edge: f32, n: vec3<f32>) -> f32 {
    let ray = -towards_viewer(middle);
    let is_perspective = style.eye.w != 0.0;
    // What lies before the near plane is pushed as if it were on it.
    let depth = select(1.0, max(dot(ray, style.axis.xyz), style.line.shape.near_w), is_perspective);
    let reach = style.line.shape.reach;
    let width = max(reach.x + reach.y / depth, 0.0);
    // All of these are |ray| times as long as in the paper, which drops out.
    let across = cross(ray, e);
    let v_n = abs(dot(ray, n));
    var delta = 0.0;
    if style.law != AS_PRINTED && style.law != WITHOUT_SINE {
        // The exact law: across leans towards the axis as the edge is seen aslant of the image plane.
        let leaning = dot(across, style.axis.xyz);
        let s = sqrt(max(dot(across, across) - leaning * leaning, 0.0));
        let recedes = select(0.0, dot(cross(e, n), style.axis.xyz), is_perspective);
        let room = style.axis.w * v_n - width * recedes * s;
        delta = select(FARTHEST * depth, width * depth * s / room, room > 0.0);
    } else {
        // As printed: z is the distance from the camera.
        let z = select(1.0, length(ray), is_perspective);
        let sine = select(length(across), length(ray), style.law == WITHOUT_SINE);
        delta = width / style.axis.w * z * sine / max(v_n, 1e-12 * length(ray));
    }
    delta = min(delta, FARTHEST * depth);
    if style.clamp_edges > 0.0 {
        delta = min(delta, style.clamp_edges * length_edge);
    }
    return delta;
}
