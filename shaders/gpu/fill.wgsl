// Filled triangles. Twin of the uniform: crates/gpu/src/fill.rs

#import "shared/camera.wgsl"
#import "shared/color.wgsl"

struct FillUniform {
    // sRGB, straight alpha.
    color: vec4<f32>,
    // Unit vector towards the light in the mesh's shape; w: share of light that falls everywhere.
    light: vec4<f32>,
    // Local frame to the mesh's shape in the world.
    shape: mat3x3<f32>,
    // 1: the target takes linear light.
    is_linear: u32,
}

@group(0) @binding(1) var<uniform> fill: FillUniform;

struct FillVertex {
    @invariant @builtin(position) position: vec4<f32>,
    @location(0) shaped: vec3<f32>,
}

@vertex
fn fill_vertex(@location(0) position: vec3<f32>) -> FillVertex {
    return FillVertex(clip_position(position), fill.shape * position);
}

// For stages without shading: nothing to interpolate.
@vertex
fn flat_vertex(@location(0) position: vec3<f32>) -> @invariant @builtin(position) vec4<f32> {
    return clip_position(position);
}

@fragment
fn fill_flat() -> @location(0) vec4<f32> {
    return for_target(fill.color.rgb, fill.color.a, fill.is_linear);
}

// Lambert's law with the face's own normal, the same from both sides.
@fragment
fn fill_lit(in: FillVertex) -> @location(0) vec4<f32> {
    let normal = cross(dpdx(in.shaped), dpdy(in.shaped));
    let cosine = abs(dot(normal, fill.light.xyz)) / max(length(normal), 1e-30);
    return for_target(fill.color.rgb * mix(cosine, 1.0, fill.light.w), fill.color.a, fill.is_linear);
}
