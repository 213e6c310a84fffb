// Step 2 of Raskar and Cohen 1999: front faces, white. Twin: crates/image_precision/src/front_faces.rs

struct FrontVertex {
    @invariant @builtin(position) position: vec4<f32>,
}

@vertex
fn front_vertex(@location(0) position: vec3<f32>) -> FrontVertex {
    return FrontVertex(clip_position(position));
}

@fragment
fn front_fragment() -> @location(0) vec4<f32> {
    return vec4<f32>(1.0);
}
