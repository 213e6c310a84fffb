// The id of the face that is nearest, plus one. Twin: crates/render/src/face_ids.rs

#import "shared/camera.wgsl"
#import "shared/mesh.wgsl"

struct FaceVertex {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) id: u32,
}

// Corners are pulled by index, so that a vertex knows its face: three after another are one face's.
@vertex
fn face_vertex(@builtin(vertex_index) corner: u32) -> FaceVertex {
    return FaceVertex(clip_position(corner_position(corner)), corner / 3u + 1u);
}

@fragment
fn face_id(in: FaceVertex) -> @location(0) u32 {
    return in.id;
}
