// Averages n x n samples into one pixel. Twin of the uniform: crates/render/src/reference/box_downsample.rs

#import "shared/full_screen.wgsl"

struct BoxUniform {
    samples_per_side: u32,
}

@group(0) @binding(0) var source: texture_2d<f32>;
@group(0) @binding(1) var<uniform> box_filter: BoxUniform;

@fragment
fn box_downsample(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let n = box_filter.samples_per_side;
    let first = vec2<u32>(position.xy) * n;
    var sum = vec4<f32>(0.0);
    for (var y = 0u; y < n; y++) {
        for (var x = 0u; x < n; x++) {
            sum += textureLoad(source, first + vec2<u32>(x, y), 0);
        }
    }
    return sum / f32(n * n);
}
