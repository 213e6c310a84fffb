// Copies a depth buffer of any format into 32-bit floats. Twin: crates/render/src/depth_readback.rs

#import "shared/full_screen.wgsl"

@group(0) @binding(0) var source: texture_depth_2d;

@fragment
fn depth_readback(@builtin(position) position: vec4<f32>) -> @location(0) f32 {
    return textureLoad(source, vec2<i32>(position.xy), 0);
}
