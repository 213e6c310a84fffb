// Marks the faces of the first layer, one sample per pixel, and lists the others: polygons without orientation, section 4
// of Raskar and Cohen 1999. Twin: crates/image_precision/src/mark_seen.rs

#import "image_precision/marking.wgsl"

@group(2) @binding(1) var seen: texture_2d<f32>;

fn samples() -> u32 {
    return 1u;
}

fn sample_at(pixel: vec2<i32>, sample: u32) -> vec4<f32> {
    return textureLoad(seen, pixel, i32(sample));
}
