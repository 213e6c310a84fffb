// Surface and outlines from stored angles. Twin: crates/texture/src/lookup.rs

#import "texture/outline_stages.wgsl"

@group(2) @binding(5) var angles: texture_3d<f32>;

// Whether the hardware filters; in 8-bit formats, adapters may do so in 8 bits.
override IS_FILTERED: bool = true;

fn stored_share(place: vec2<f32>, turn: f32) -> f32 {
    if IS_FILTERED {
        return textureSampleLevel(angles, linear, vec3<f32>(place, turn), 0.0).x;
    }
    let size = vec3<i32>(textureDimensions(angles));
    let at = vec3<f32>(place, fract(turn)) * vec3<f32>(size) - 0.5;
    let low = vec3<i32>(floor(at));
    let part = at - floor(at);
    let x = clamp(vec2<i32>(low.x, low.x + 1), vec2<i32>(0), vec2<i32>(size.x - 1));
    let y = clamp(vec2<i32>(low.y, low.y + 1), vec2<i32>(0), vec2<i32>(size.y - 1));
    let z = vec2<i32>(select(low.z, size.z - 1, low.z < 0), select(low.z + 1, 0, low.z + 1 >= size.z));
    return mix(filtered_slice(x, y, z.x, part.xy), filtered_slice(x, y, z.y, part.xy), part.z);
}

fn filtered_slice(x: vec2<i32>, y: vec2<i32>, z: i32, part: vec2<f32>) -> f32 {
    let above = mix(loaded(x.x, y.x, z), loaded(x.y, y.x, z), part.x);
    let below = mix(loaded(x.x, y.y, z), loaded(x.y, y.y, z), part.x);
    return mix(above, below, part.y);
}

fn loaded(x: i32, y: i32, z: i32) -> f32 {
    return textureLoad(angles, vec3<i32>(x, y, z), 0).x;
}
