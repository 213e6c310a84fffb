// Colours as targets store them. Twin: crates/gpu/src/color.rs

// The linear light of sRGB-encoded values, IEC 61966-2-1.
fn linear_light(srgb: vec3<f32>) -> vec3<f32> {
    let low = srgb / 12.92;
    let high = pow((max(srgb, vec3<f32>(0.0)) + 0.055) / 1.055, vec3<f32>(2.4));
    return select(high, low, srgb <= vec3<f32>(0.04045));
}

// An sRGB colour as the target takes it, premultiplied: `is_linear` where it takes linear light.
fn for_target(srgb: vec3<f32>, alpha: f32, is_linear: u32) -> vec4<f32> {
    return vec4<f32>(select(srgb, linear_light(srgb), is_linear != 0u) * alpha, alpha);
}
