// The normals of a mesh, beside its depth. Twin: crates/baselines/src/gbuffer_filter/gbuffer.rs

#import "shared/camera.wgsl"

struct SurfaceFrame {
    // Local frame to the mesh's shape.
    shape: mat3x3<f32>,
}

@group(0) @binding(1) var<uniform> surface: SurfaceFrame;

struct SurfaceVertex {
    @builtin(position) position: vec4<f32>,
    @location(0) shaped: vec3<f32>,
}

@vertex
fn surface_vertex(@location(0) position: vec3<f32>) -> SurfaceVertex {
    return SurfaceVertex(clip_position(position), surface.shape * position);
}

// The face's own unit normal, on the viewer's side or always on the other; 1 where there is a face.
@fragment
fn surface_normal(in: SurfaceVertex) -> @location(0) vec4<f32> {
    let normal = cross(dpdx(in.shaped), dpdy(in.shaped));
    return vec4<f32>(normal / max(length(normal), 1e-30), 1.0);
}
