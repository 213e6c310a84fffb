// The hull as it is drawn, and what all stages know of the view.
// Twins: crates/texture/src/gpu/texture_vertices.rs and crates/texture/src/gpu/hull_uniform.rs

#import "shared/camera.wgsl"
#import "shared/surface.wgsl"
#import "texture/frame.wgsl"

struct HullUniform {
    // In the local frame: the eye with w = 1, or a unit vector towards the viewer with w = 0.
    eye: vec4<f32>,
    // sRGB, straight alpha.
    ink: vec4<f32>,
    paper: vec4<f32>,
    // Normals of the object to normals of its shape, up to a factor.
    normal_to_shape: mat3x3<f32>,
    // Azimuth 0 lies this far from the outer corner of the first texel, in turns.
    azimuth_shift: f32,
    // Half of a line, in pixels; as printed, in the unit of `allowance_per_w`.
    half_width: f32,
    // Where clip-space w is 1: length in the local frame of a pixel; angle within which the paper draws ink.
    pixel_per_w: f32,
    allowance_per_w: f32,
    // Length in the local frame of the unit of gaps.
    gap_unit: f32,
}

@group(1) @binding(0) var<uniform> hull: HullUniform;

@group(2) @binding(0) var linear: sampler;
@group(2) @binding(1) var colors: texture_2d<f32>;
@group(2) @binding(2) var normals: texture_2d<f32>;
@group(2) @binding(3) var gaps: texture_2d<f32>;
@group(2) @binding(4) var texel_centers: texture_2d<f32>;

// Whether a texel has a centre of its own.
override HAS_TEXEL_CENTERS: bool = false;

struct HullVertex {
    @invariant @builtin(position) position: vec4<f32>,
    // In the local frame.
    @location(0) point: vec3<f32>,
    @location(1) center: vec3<f32>,
    @location(2) tangent: vec3<f32>,
    // Place on the page, 0 to 1.
    @location(3) place: vec2<f32>,
}

@vertex
fn hull_vertex(
    @location(0) point: vec3<f32>,
    @location(1) center: vec3<f32>,
    @location(2) tangent: vec3<f32>,
    @location(3) place: vec2<f32>,
) -> HullVertex {
    return HullVertex(clip_position(point), point, center, tangent, place);
}

// From the eye into the object, unit.
fn view_direction(in: HullVertex) -> vec3<f32> {
    return normalize(hull.eye.w * in.point - hull.eye.xyz);
}

fn hull_frame(in: HullVertex) -> Frame {
    if HAS_TEXEL_CENTERS {
        return frame_of(textureSampleLevel(texel_centers, linear, in.place, 0.0).xyz, in.tangent);
    }
    return frame_of(in.center, in.tangent);
}
