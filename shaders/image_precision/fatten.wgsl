// Section 3.3 of Raskar and Cohen 1999: fattened polygons, their corners as `polygons.wgsl` leaves them.
// Twin: crates/image_precision/src/fatten_list.rs

@vertex
fn fat_vertex(@location(0) clip: vec4<f32>) -> @builtin(position) vec4<f32> {
    return clip;
}

struct NotedVertex {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) note: u32,
}

@vertex
fn noted_vertex(@location(0) clip: vec4<f32>, @location(1) note: u32) -> NotedVertex {
    return NotedVertex(clip, note);
}

@fragment
fn textured_fragment(in: NotedVertex) -> @location(0) vec4<f32> {
    if is_blank(in.note, in.position.xy) {
        discard;
    }
    return faded_ink(1.0 / in.position.w);
}

// Section 4, charcoal: the grey of the polygon, I = (1 + V.N) / 3.
@fragment
fn charcoal_fragment(in: NotedVertex) -> @location(0) vec4<f32> {
    return vec4<f32>(vec3<f32>((1.0 + bitcast<f32>(in.note)) / 3.0), 1.0);
}
