// Section 3.3 of Raskar and Cohen 1999: polygons fattened in their plane, drawn as a fan of 2 n triangles about their
// middle. Twin: crates/image_precision/src/fatten.rs

@group(2) @binding(0) var<storage, read> listed: array<vec2<u32>>;
@group(2) @binding(1) var<storage, read> starts: array<u32>;

struct FatVertex {
    @builtin(position) position: vec4<f32>,
    @location(0) along_px: f32,
    @location(1) @interpolate(flat) facing: f32,
}

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
    let width = max(style.span.y + style.span.w / depth, 0.0);
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

@vertex
fn fat_vertex(@builtin(vertex_index) index: u32) -> FatVertex {
    let record = listed[index / 6u];
    let p = polygon(corner_range(record.y));
    let at = record.x - p.first;
    let a = corner_position(record.x);
    let b = corner_position(p.first + (at + 1u) % p.size);
    let c = corner_position(p.first + (at + 2u) % p.size);
    // Two triangles: about the middle over this edge, and over the gap between this edge and the next.
    var position = p.middle;
    var along = 0.0;
    switch index % 6u {
        case 1u: {
            position = a + push(a, b, p);
        }
        case 2u, 4u: {
            position = b + push(a, b, p);
            along = 1.0;
        }
        case 5u: {
            position = b + push(b, c, p);
            along = 1.0;
        }
        default: {}
    }
    let clip_a = clip_position(a);
    let clip_b = clip_position(b);
    let way = 0.5 * style.viewport_px * (clip_b.xy / clip_b.w - clip_a.xy / clip_a.w);
    let view = towards_viewer(p.middle);
    let facing = dot(p.normal, view) / max(length(p.normal) * length(view), 1e-30);
    return FatVertex(clip_position(position), along * length(way), facing);
}

@fragment
fn fat_fragment(in: FatVertex) -> @location(0) vec4<f32> {
    if is_blank(in.along_px, in.position.xy) {
        discard;
    }
    return faded_ink(1.0 / in.position.w);
}

// Section 4, charcoal: the grey of the polygon, I = (1 + V.N) / 3.
@fragment
fn charcoal_fragment(in: FatVertex) -> @location(0) vec4<f32> {
    return vec4<f32>(vec3<f32>((1.0 + in.facing) / 3.0), 1.0);
}
