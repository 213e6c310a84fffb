// The colour of a surface, plain or lit. Twin: crates/gpu/src/surface.rs

#import "shared/color.wgsl"

struct SurfaceUniform {
    // sRGB, straight alpha.
    color: vec4<f32>,
    // Unit vector towards the light in the mesh's shape; w: share of light that falls everywhere.
    light: vec4<f32>,
    // Local frame to the mesh's shape in the world.
    shape: mat3x3<f32>,
    // 1: the target takes linear light.
    is_linear: u32,
}

@group(0) @binding(1) var<uniform> surface: SurfaceUniform;

fn flat_surface() -> vec4<f32> {
    return for_target(surface.color.rgb, surface.color.a, surface.is_linear);
}

// Lambert's law, the same from both sides, for a normal of any length in the mesh's shape. Without a normal it is dark.
fn lit(color: vec4<f32>, normal: vec3<f32>) -> vec4<f32> {
    let cosine = abs(dot(normal, surface.light.xyz)) / max(length(normal), 1e-30);
    return for_target(color.rgb * mix(cosine, 1.0, surface.light.w), color.a, surface.is_linear);
}

fn lit_surface(normal: vec3<f32>) -> vec4<f32> {
    return lit(surface.color, normal);
}
