// Filled triangles. Twin of the uniform: crates/render/src/fill.rs

#import "shared/camera.wgsl"

struct FillUniform {
    color: vec4<f32>,
    // Unit vector towards the light in mesh space; w: share of light that falls everywhere.
    light: vec4<f32>,
}

@group(0) @binding(1) var<uniform> fill: FillUniform;

struct FillVertex {
    @invariant @builtin(position) position: vec4<f32>,
    @location(0) mesh_position: vec3<f32>,
}

@vertex
fn fill_vertex(@location(0) position: vec3<f32>) -> FillVertex {
    return FillVertex(clip_position(position), position);
}

@fragment
fn fill_flat() -> @location(0) vec4<f32> {
    return fill.color;
}

// Lambert's law with the face's own normal, the same from both sides.
@fragment
fn fill_lit(in: FillVertex) -> @location(0) vec4<f32> {
    let normal = cross(dpdx(in.mesh_position), dpdy(in.mesh_position));
    let cosine = abs(dot(normal, fill.light.xyz)) / max(length(normal), 1e-30);
    return vec4<f32>(fill.color.rgb * mix(cosine, 1.0, fill.light.w), fill.color.a);
}
