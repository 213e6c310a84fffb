// Where borders are expected, from those of two coarser texels. Twin: `expected` in crates/texture/src/tile.rs

var<private> azimuth_index: u32;
// Slots of the coarser texels, or `NO_SLOT`.
var<private> seeds: vec2<u32>;

fn known_at(slot: u32) -> u32 {
    return MERIDIAN_WORDS * (azimuth_index * settings.known_texels + slot);
}

// The meridian halfway between those of both seeds; where they are unlike each other, the first. Whether it can be followed.
fn expect_borders() -> bool {
    if seeds.x == NO_SLOT {
        return false;
    }
    let before = known_at(seeds.x);
    let kind = known[before];
    if (kind & 1u) != u32(is_shown_first) {
        return false;
    }
    var after = before;
    if seeds.y != NO_SLOT && known[known_at(seeds.y)] == kind {
        after = known_at(seeds.y);
    }
    var spread = 0.0;
    let margin = settings.tolerance * 0.5;
    for (var at = 1u; at <= kind >> 1u; at += 1u) {
        let pair = vec2<f32>(bitcast<f32>(known[before + at]), bitcast<f32>(known[after + at]));
        spread = max(spread, abs(pair.x - pair.y));
        let guess = (pair.x + pair.y) * 0.5;
        if guess > search.first.angle + margin && guess < search.end - margin {
            guesses[guess_count] = guess;
            guess_count += 1u;
        }
    }
    slack = settings.tolerance + spread * 0.25;
    return true;
}
