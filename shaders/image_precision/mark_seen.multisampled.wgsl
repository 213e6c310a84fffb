// Marks the faces of the first layer where the target has several samples per pixel, and lists the others.
// Twin: crates/image_precision/src/mark_seen.rs

#import "image_precision/marking.wgsl"

@group(2) @binding(1) var seen: texture_multisampled_2d<f32>;

fn samples() -> u32 {
    return textureNumSamples(seen);
}

fn sample_at(pixel: vec2<i32>, sample: u32) -> vec4<f32> {
    return textureLoad(seen, pixel, i32(sample));
}
