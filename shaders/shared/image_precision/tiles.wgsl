// Squares of the image over which the farthest depth of front faces is known.

const TILE_PX: u32 = 8u;

// A depth as it is with the far plane at 1.
fn distance_of(depth: f32) -> f32 {
    return select(depth, 1.0 - depth, style.reversed != 0u);
}
