// Step 2 of Raskar and Cohen 1999: front faces, as paper or shaded. Twin: crates/image_precision/src/front_faces.rs

#import "shared/camera.wgsl"
#import "shared/color.wgsl"
#import "image_precision/style.wgsl"

struct FrontVertex {
    @invariant @builtin(position) position: vec4<f32>,
    @location(0) shaped: vec3<f32>,
}

@vertex
fn front_vertex(@location(0) position: vec3<f32>) -> FrontVertex {
    return FrontVertex(clip_position(position), shaped(position));
}

// For stages without shading: nothing to interpolate.
@vertex
fn paper_vertex(@location(0) position: vec3<f32>) -> @invariant @builtin(position) vec4<f32> {
    return clip_position(position);
}

@fragment
fn paper_fragment() -> @location(0) vec4<f32> {
    return vec4<f32>(1.0);
}

// An opaque sRGB colour on the target.
fn shade(srgb: vec3<f32>) -> vec4<f32> {
    return for_target(srgb, 1.0, style.is_linear);
}

// V.N of the face that this fragment lies on, towards the viewer, 0 to 1.
fn facing(p: vec3<f32>) -> f32 {
    let normal = cross(dpdx(p), dpdy(p));
    let view = towards_viewer(p);
    let scale = length(normal) * length(view);
    return abs(dot(normal, view)) / max(scale, 1e-30);
}

@fragment
fn lit_fragment(in: FrontVertex) -> @location(0) vec4<f32> {
    return shade(vec3<f32>(0.25 + 0.7 * facing(in.shaped)));
}

// Section 4: I = (1 + V.N) / 3.
@fragment
fn grey_fragment(in: FrontVertex) -> @location(0) vec4<f32> {
    return shade(vec3<f32>((1.0 + facing(in.shaped)) / 3.0));
}

// A. Gooch, B. Gooch, Shirley and Cohen, SIGGRAPH 1998: from cool to warm with L.N, the light over the viewer's head.
@fragment
fn gooch_fragment(in: FrontVertex) -> @location(0) vec4<f32> {
    let normal = normalize(cross(dpdx(in.shaped), dpdy(in.shaped)));
    let outward = select(normal, -normal, dot(normal, towards_viewer(in.shaped)) < 0.0);
    let warm = 0.5 + 0.5 * dot(outward, style_light());
    let cool_color = vec3<f32>(0.175, 0.175, 0.575);
    let warm_color = vec3<f32>(0.65, 0.65, 0.35);
    return shade(mix(cool_color, warm_color, warm) + 0.25);
}

// Halfway between the viewing axis and the camera's up direction.
fn style_light() -> vec3<f32> {
    return normalize(style.up.xyz - style.axis.xyz);
}
