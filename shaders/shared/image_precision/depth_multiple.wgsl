// Depth of front faces, several samples a pixel.

@group(1) @binding(0) var front_depth: texture_depth_multisampled_2d;

fn samples() -> u32 {
    return textureNumSamples(front_depth);
}

fn depth_at(pixel: vec2<i32>, sample: u32) -> f32 {
    return textureLoad(front_depth, pixel, i32(sample));
}
