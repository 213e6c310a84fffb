// Facing of a triangle by its plane, in the mesh's own space. Twin: `LocalFrame::viewer` in crates/gpu/src/local_frame.rs

#import "shared/mesh.wgsl"

// Normal of a face, twice its area long.
fn face_normal(face: u32) -> vec3<f32> {
    let a = corner_position(3u * face);
    let b = corner_position(3u * face + 1u);
    let c = corner_position(3u * face + 2u);
    return cross(b - a, c - a);
}

// Six times the volume between a face and a viewer (an eye with w = 1, or a direction towards the viewer with w = 0): above 0 where
// the face is front.
fn front_volume_seen_from(face: u32, viewer: vec4<f32>) -> f32 {
    return dot(face_normal(face), viewer.xyz - corner_position(3u * face) * viewer.w);
}
