// Step 3 of Raskar and Cohen 1999, section 3.2: back faces, black, pulled. Twin: crates/image_precision/src/back_faces.rs

struct BackVertex {
    @invariant @builtin(position) position: vec4<f32>,
}

@vertex
fn back_vertex(@location(0) position: vec3<f32>) -> BackVertex {
    return BackVertex(style.back_to_clip * vec4<f32>(position, 1.0));
}

@fragment
fn back_fragment(in: BackVertex) -> @location(0) vec4<f32> {
    return faded_ink(1.0 / in.position.w);
}
