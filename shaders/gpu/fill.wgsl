// Filled triangles. Twin: crates/gpu/src/fill.rs

#import "shared/camera.wgsl"
#import "shared/surface.wgsl"

struct FillVertex {
    @invariant @builtin(position) position: vec4<f32>,
    @location(0) shaped: vec3<f32>,
}

@vertex
fn fill_vertex(@location(0) position: vec3<f32>) -> FillVertex {
    return FillVertex(clip_position(position), surface.shape * position);
}

// For stages without shading: nothing to interpolate.
@vertex
fn flat_vertex(@location(0) position: vec3<f32>) -> @invariant @builtin(position) vec4<f32> {
    return clip_position(position);
}

@fragment
fn fill_flat() -> @location(0) vec4<f32> {
    return flat_surface();
}

// Lit with the face's own normal.
@fragment
fn fill_lit(in: FillVertex) -> @location(0) vec4<f32> {
    return lit_surface(cross(dpdx(in.shaped), dpdy(in.shaped)));
}
