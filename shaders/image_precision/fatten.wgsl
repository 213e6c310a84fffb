// Draws fattened polygons, section 3.3 of Raskar and Cohen 1999, as `cut_triangles.wgsl` and `fans.wgsl` leave them.
// Twin: crates/image_precision/src/fatten.rs

#import "shared/color.wgsl"
#import "image_precision/ink.wgsl"

@vertex
fn fat_vertex(@location(0) clip: vec4<f32>) -> @builtin(position) vec4<f32> {
    return clip;
}

struct NotedVertex {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) note: u32,
}

@vertex
fn noted_vertex(@location(0) clip: vec4<f32>, @location(1) note: u32) -> NotedVertex {
    return NotedVertex(clip, note);
}

@fragment
fn textured_fragment(in: NotedVertex) -> @location(0) vec4<f32> {
    if is_blank(in.note, in.position.xy) {
        discard;
    }
    return faded_ink(1.0 / in.position.w);
}

// Section 4, charcoal: the grey of the polygon, I = (1 + V.N) / 3.
fn grey(facing: f32) -> vec4<f32> {
    return for_target(vec3<f32>((1.0 + facing) / 3.0), 1.0, style.is_linear);
}

@fragment
fn charcoal_fragment(in: NotedVertex) -> @location(0) vec4<f32> {
    return grey(bitcast<f32>(in.note));
}

// A triangle whose corners are cut off.
struct CutVertex {
    @builtin(position) position: vec4<f32>,
    // How far inside of each cut.
    @location(0) inside: vec3<f32>,
    @location(1) @interpolate(flat) facing: f32,
}

@vertex
fn cut_vertex(@location(0) clip: vec4<f32>, @location(1) inside: vec4<f32>) -> CutVertex {
    return CutVertex(clip, inside.xyz, inside.w);
}

fn cut_ink(in: CutVertex) -> vec4<f32> {
    if style.noted == NOTED_FACING {
        return grey(in.facing);
    }
    return faded_ink(1.0 / in.position.w);
}

@fragment
fn cut_fragment(in: CutVertex) -> @location(0) vec4<f32> {
    if any(in.inside < vec3<f32>(0.0)) {
        discard;
    }
    return cut_ink(in);
}

struct SampledInk {
    @location(0) ink: vec4<f32>,
    @builtin(sample_mask) samples: u32,
}

// The same for four samples a pixel, at the places which WebGPU has them.
@fragment
fn cut_fragment_4(in: CutVertex) -> SampledInk {
    // Over w it is linear in the image, and its sign the same.
    let inside = in.inside * in.position.w;
    let right = dpdx(inside) / 16.0;
    let down = dpdy(inside) / 16.0;
    var samples = 0u;
    samples |= select(0u, 1u, all(inside - 2.0 * right - 6.0 * down >= vec3<f32>(0.0)));
    samples |= select(0u, 2u, all(inside + 6.0 * right - 2.0 * down >= vec3<f32>(0.0)));
    samples |= select(0u, 4u, all(inside - 6.0 * right + 2.0 * down >= vec3<f32>(0.0)));
    samples |= select(0u, 8u, all(inside + 2.0 * right + 6.0 * down >= vec3<f32>(0.0)));
    return SampledInk(cut_ink(in), samples);
}
