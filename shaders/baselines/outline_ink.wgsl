// Ink around objects, as far as it reaches from the nearest seed. Twin: crates/baselines/src/jump_flood/outline_ink.rs

#import "shared/full_screen.wgsl"
#import "baselines/field.wgsl"
#import "baselines/rim.wgsl"

@group(1) @binding(0) var records: texture_2d<u32>;
@group(1) @binding(1) var nearest: texture_2d<u32>;

// The nearest seed around a border pixel whose ink lies over the pixel's object.
fn seed_over(pixel: vec2<i32>, own: vec2<u32>) -> u32 {
    var found = NONE;
    var found_px = 1e30;
    let neighbours = select(0, 9, (own.y & SEED) != 0u);
    for (var neighbour = 0; neighbour < neighbours; neighbour++) {
        let from_pixel = pixel + vec2<i32>(neighbour % 3 - 1, neighbour / 3 - 1);
        let known = select(NONE, textureLoad(nearest, from_pixel, 0).x, is_in_field(from_pixel));
        if known == NONE {
            continue;
        }
        let at = unpacked_pixel(known);
        let record = textureLoad(records, at, 0).xy;
        let away_px = distance(vec2<f32>(pixel) + 0.5, seed_of(at, record));
        if away_px < found_px && lies_over(record, own) {
            found = known;
            found_px = away_px;
        }
    }
    return found;
}

fn reach_px_of(seed: vec2<u32>) -> f32 {
    return reach_px_at(depth_of(seed));
}

@fragment
fn outline_ink(@builtin(position) position: vec4<f32>) -> Inked {
    let pixel = vec2<i32>(position.xy) + field.to_field;
    let own = textureLoad(records, pixel, 0).xy;
    var known = textureLoad(nearest, pixel, 0).x;
    var is_over = (own.y & COVERED) != 0u;
    if (own.y & SEED) != 0u {
        // A border knows a seed of its own object, whose ink lies beside it; the pixels around it know whose ink lies over it.
        let over = seed_over(pixel, own);
        let at = unpacked_pixel(select(over, 0u, over == NONE));
        let record = textureLoad(records, at, 0).xy;
        let reaches = over != NONE && distance(vec2<f32>(pixel) + 0.5, seed_of(at, record)) < reach_px_of(record) + 0.5;
        known = select(select(known, NONE, is_over), over, reaches);
        is_over = reaches;
    }
    if known == NONE {
        discard;
    }
    let at = unpacked_pixel(known);
    let record = textureLoad(records, at, 0).xy;
    let depth = depth_of(record);
    let reach_px = reach_px_of(record);
    // Before an object that the seed's own stands before; otherwise behind the seed's own, which hides it sample by sample.
    let before = min(depth, depth_of(own)) - lift_at(depth);
    let ink = inked(pixel, seed_of(at, record), reach_px, select(depth + lift_at(depth), before, is_over));
    if ink.samples == 0u || !(reach_px > 0.0) {
        discard;
    }
    return ink;
}
