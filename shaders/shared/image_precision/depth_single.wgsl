// Depth of front faces, one sample a pixel.

@group(1) @binding(0) var front_depth: texture_depth_2d;

fn samples() -> u32 {
    return 1u;
}

fn depth_at(pixel: vec2<i32>, sample: u32) -> f32 {
    return textureLoad(front_depth, pixel, 0);
}
