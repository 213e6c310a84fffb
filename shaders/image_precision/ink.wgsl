// Ink without a texture.

#import "image_precision/style.wgsl"

@fragment
fn solid_fragment() -> @location(0) vec4<f32> {
    return style.ink;
}

// Paler with depth.
@fragment
fn faded_fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    return faded_ink(1.0 / position.w);
}
