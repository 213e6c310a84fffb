// Whether what is in a box is behind front faces wherever it may be seen (hierarchical z-buffer: Greene, Kass and Miller,
// SIGGRAPH 1993, with one level).

@group(3) @binding(0) var front_tiles: texture_2d<f32>;

// Depths closer than this are not told apart: a few steps of 16 bits.
const CLOSE: f32 = 6e-5;
const MOST_TILES: u32 = 16u;

struct Box {
    // In pixels, y up from the middle of the image.
    low: vec2<f32>,
    high: vec2<f32>,
    // The nearest depth, as `distance_of` gives it.
    nearest: f32,
    // Whether all of it lies beyond the near plane; otherwise the box tells nothing.
    is_bounded: bool,
}

const EMPTY: Box = Box(vec2<f32>(1e30), vec2<f32>(-1e30), 1e30, true);

fn with_point(all: Box, clip: vec4<f32>) -> Box {
    let pixel = clip.xy / clip.w * 0.5 * style.viewport_px;
    let nearest = min(all.nearest, distance_of(clip.z / clip.w));
    return Box(min(all.low, pixel), max(all.high, pixel), nearest, all.is_bounded && clip.w > style.near_w);
}

fn is_hidden(all: Box) -> bool {
    // A pixel more on either side; the image's first row of pixels is its top.
    let half = 0.5 * style.viewport_px;
    let low = clamp(vec2<f32>(all.low.x, -all.high.y) + half - 1.0, vec2<f32>(0.0), style.viewport_px - 1.0);
    let high = clamp(vec2<f32>(all.high.x, -all.low.y) + half + 1.0, vec2<f32>(0.0), style.viewport_px - 1.0);
    let first = vec2<u32>(low) / TILE_PX;
    let size = vec2<u32>(high) / TILE_PX - first + 1u;
    if !all.is_bounded || size.x > MOST_TILES || size.y > MOST_TILES || size.x * size.y > MOST_TILES {
        return false;
    }
    var farthest = 0.0;
    for (var at = 0u; at < size.x * size.y; at++) {
        let tile = first + vec2<u32>(at % size.x, at / size.x);
        farthest = max(farthest, textureLoad(front_tiles, vec2<i32>(tile), 0).x);
    }
    return all.nearest > farthest + CLOSE;
}
