// Surface and outlines from sums of few functions of azimuth. Twin: crates/texture/src/lookup.rs

#import "texture/outline_stages.wgsl"

// Four terms per layer: weights from 0 to 1.
@group(2) @binding(5) var weights: texture_2d_array<f32>;
// A column per azimuth. Row i: what the weights of layer i are multiplied by; x of the last row: what is added.
@group(2) @binding(6) var functions: texture_2d<f32>;

// Whether the hardware filters weights; in 8-bit formats, adapters may do so in 8 bits.
override IS_FILTERED: bool = true;

// The sum is linear in the weights, so that filtering them comes to the same as filtering sums.
fn stored_share(place: vec2<f32>, turn: f32) -> f32 {
    let count = i32(textureDimensions(functions).x);
    let at = fract(turn) * f32(count) - 0.5;
    let low = i32(floor(at));
    let a = select(low, count - 1, low < 0);
    let b = select(low + 1, 0, low + 1 >= count);
    let part = at - floor(at);
    let layers = i32(textureNumLayers(weights));
    var share = mix(textureLoad(functions, vec2<i32>(a, layers), 0).x, textureLoad(functions, vec2<i32>(b, layers), 0).x, part);
    for (var layer = 0; layer < layers; layer++) {
        let before = textureLoad(functions, vec2<i32>(a, layer), 0);
        let after = textureLoad(functions, vec2<i32>(b, layer), 0);
        share += dot(filtered_weights(place, layer), mix(before, after, part));
    }
    return share;
}

fn filtered_weights(place: vec2<f32>, layer: i32) -> vec4<f32> {
    if IS_FILTERED {
        return textureSampleLevel(weights, linear, place, layer, 0.0);
    }
    let size = vec2<i32>(textureDimensions(weights));
    let at = place * vec2<f32>(size) - 0.5;
    let part = at - floor(at);
    let low = clamp(vec2<i32>(floor(at)), vec2<i32>(0), size - 1);
    let high = clamp(vec2<i32>(floor(at)) + 1, vec2<i32>(0), size - 1);
    let above = mix(loaded(low.x, low.y, layer), loaded(high.x, low.y, layer), part.x);
    let below = mix(loaded(low.x, high.y, layer), loaded(high.x, high.y, layer), part.x);
    return mix(above, below, part.y);
}

fn loaded(x: i32, y: i32, layer: i32) -> vec4<f32> {
    return textureLoad(weights, vec2<i32>(x, y), layer, 0);
}
