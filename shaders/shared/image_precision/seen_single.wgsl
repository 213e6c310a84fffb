// Numbers of the first layer, one sample a pixel.

@group(2) @binding(1) var seen: texture_2d<f32>;

fn samples() -> u32 {
    return 1u;
}

fn sample_at(pixel: vec2<i32>, sample: u32) -> vec4<f32> {
    return textureLoad(seen, pixel, i32(sample));
}
