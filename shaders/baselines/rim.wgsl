// How much of a pixel the ink around a seed covers.

#import "baselines/field.wgsl"

struct Inked {
    @location(0) color: vec4<f32>,
    @builtin(frag_depth) value: f32,
    @builtin(sample_mask) samples: u32,
}

// A pixel's middle as far from a line as its ink reaches is inked on one side of the line alone.
const HALF_OPEN_PX: f32 = 1.0 / 512.0;

// Ink of this depth, within `reach_px` of a seed, on a pixel of the field. No sample where there is none.
fn inked(pixel: vec2<i32>, seed: vec2<f32>, reach_px: f32, depth: f32) -> Inked {
    let corner = vec2<f32>(pixel) - HALF_OPEN_PX;
    var color = field.ink;
    var samples = 0u;
    if field.is_smooth != 0u {
        let share = clamp(reach_px + 0.5 - distance(corner + 0.5, seed), 0.0, 1.0);
        color *= share;
        samples = select(0u, 0xfu, share > 0.0);
    } else if field.samples == 1u {
        samples = u32(distance(corner + 0.5, seed) <= reach_px);
    } else {
        for (var i = 0u; i < 4u; i++) {
            samples |= u32(distance(corner + SAMPLE_PLACES[i], seed) <= reach_px) << i;
        }
    }
    return Inked(color, value_of_depth(depth), samples);
}
