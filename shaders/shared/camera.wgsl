// The camera of a view. Twin: crates/gpu/src/camera.rs

struct CameraUniform {
    // Recentred mesh space to clip space.
    to_clip: mat4x4<f32>,
}

@group(0) @binding(0) var<uniform> camera: CameraUniform;

// Every stage that must cover the same pixels computes its position here and nowhere else.
fn clip_position(position: vec3<f32>) -> vec4<f32> {
    return camera.to_clip * vec4<f32>(position, 1.0);
}
