// Pixels of a G-buffer, and what is compared of them. Twins: crates/baselines/src/gbuffer_filter/gbuffer.rs, discontinuities.rs

#import "baselines/field.wgsl"

struct Thresholds {
    // Least step in depth, in units of view space.
    depth: f32,
    // Cosine of the least angle between normals, and the square of the chord of that angle.
    cosine: f32,
    chord_squared: f32,
    // Depth of the mesh's middle, or as much as its radius if that is more, from the viewer.
    middle: f32,
    // The same beyond the near plane.
    middle_beyond_near: f32,
    // What the depth buffer holds where there is no mesh.
    ground: f32,
    is_perspective: u32,
    // 1: normals are compared.
    finds_turns: u32,
}

@group(1) @binding(0) var normals: texture_2d<f32>;
@group(1) @binding(1) var depths: texture_depth_2d;
@group(1) @binding(2) var<uniform> thresholds: Thresholds;
const NOWHERE: f32 = 3e38;

struct Texel {
    is_mesh: bool,
    depth: f32,
    // What a plane is linear in over the image: minus the depth, or in a perspective its inverse, in units of the middle's and counted
    // from there.
    flat_depth: f32,
}

fn texel(pixel: vec2<i32>) -> Texel {
    let at = clamp(pixel, vec2<i32>(0), field.size_px - 1);
    let value = textureLoad(depths, at, 0);
    let depth = depth_of_value(value);
    let is_mesh = value != thresholds.ground;
    let inverse = (thresholds.middle_beyond_near - depth) / (depth + field.near);
    let flat_depth = select(-depth, inverse, thresholds.is_perspective != 0u);
    return Texel(is_mesh, select(NOWHERE, depth, is_mesh), flat_depth);
}

fn normal(pixel: vec2<i32>) -> vec3<f32> {
    return textureLoad(normals, clamp(pixel, vec2<i32>(0), field.size_px - 1), 0).xyz;
}

// A difference of flat depths at a depth, as a step in depth.
fn step_of(difference: f32, depth: f32) -> f32 {
    let from_viewer = depth + field.near;
    return difference * select(1.0, from_viewer * (from_viewer / thresholds.middle), thresholds.is_perspective != 0u);
}
