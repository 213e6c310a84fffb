// Step 3 of Raskar and Cohen 1999: back faces, black, scaled about the eye. Twin: crates/image_precision/src/back_faces.rs

struct BackFacesUniform {
    // What the scaling adds to clip-space z; x, y and w stay, so that the same pixels are covered.
    clip_z_offset: f32,
}

@group(0) @binding(1) var<uniform> back_faces: BackFacesUniform;

struct BackVertex {
    @invariant @builtin(position) position: vec4<f32>,
}

@vertex
fn back_vertex(@location(0) position: vec3<f32>) -> BackVertex {
    var clip = clip_position(position);
    clip.z += back_faces.clip_z_offset;
    return BackVertex(clip);
}

@fragment
fn back_fragment() -> @location(0) vec4<f32> {
    return vec4<f32>(0.0, 0.0, 0.0, 1.0);
}
