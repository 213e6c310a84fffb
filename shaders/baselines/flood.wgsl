// One step of jump flooding: each pixel takes the nearest of the seeds that it and eight pixels around it, a step away, know.
// Twin: crates/baselines/src/distance_field/flood.rs

#import "baselines/field.wgsl"

@group(1) @binding(0) var records: texture_2d<u32>;
@group(1) @binding(1) var nearest: texture_2d<u32>;
@group(1) @binding(2) var flooded: texture_storage_2d<r32uint, write>;
@group(2) @binding(0) var<uniform> step_px: vec4<i32>;

// The seed that a pixel knows: this one, or one of eight around it.
fn known_at(pixel: vec2<i32>, neighbour: i32) -> u32 {
    let from_pixel = pixel + step_px.x * vec2<i32>(neighbour % 3 - 1, neighbour / 3 - 1);
    return select(NONE, textureLoad(nearest, from_pixel, 0).x, is_in_field(from_pixel));
}

// Most pixels are far from all lines. Software adapters run both sides of a condition, and no loop that nobody enters.
fn any_known(pixel: vec2<i32>) -> bool {
    var least = NONE;
    for (var neighbour = 0; neighbour < 9; neighbour++) {
        least = min(least, known_at(pixel, neighbour));
    }
    return least != NONE;
}

@compute @workgroup_size(8, 8)
fn flood(@builtin(global_invocation_id) id: vec3<u32>) {
    let pixel = vec2<i32>(id.xy);
    if !is_in_field(pixel) {
        return;
    }
    let middle = vec2<f32>(pixel) + 0.5;
    var found = NONE;
    var found_px = 1e30;
    let neighbours = select(0, 9, any_known(pixel));
    for (var neighbour = 0; neighbour < neighbours; neighbour++) {
        let known = known_at(pixel, neighbour);
        if known == NONE {
            continue;
        }
        let at = unpacked_pixel(known);
        let record = textureLoad(records, at, 0).xy;
        let away_px = distance(middle, seed_of(at, record));
        if away_px >= found_px {
            continue;
        }
        // A pixel keeps its own seed, so that others learn of it, whether or not its ink may lie there.
        if all(at == pixel) || accepts(textureLoad(records, pixel, 0).xy, record) {
            found = known;
            found_px = away_px;
        }
    }
    textureStore(flooded, pixel, vec4<u32>(found, 0u, 0u, 0u));
}
