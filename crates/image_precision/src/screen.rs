//! Ours: edges of back faces expanded in the image plane, as wide as asked for everywhere.
//!
//! 1. `back_edges.wgsl` classifies every face once and counts, for each edge of a back face, the back faces that have it.
//!    Edges are known by the positions of their ends, so that a soup without shared vertices is served as well. An edge
//!    counted twice lies between back faces and cannot be a silhouette edge; the others are listed.
//! 2. `screen.wgsl` draws each listed edge as a quad beside the projected edge, outwards of its face, and a fan around
//!    either end that rounds corners. The edge is clipped at the near plane first. Depth is that of the edge, so that front
//!    faces before it hide it and it covers what lies behind.
//!
//! Fattening in the polygon's plane, as the paper does, slides along the edge and makes spikes
//! ([`fatten`](crate::fatten)); moving the edge in the image does not.
//!
//! Counting needs no preparation and no adjacency: it is O(F) on the adapter in every frame. Without it (a full table's
//! neighbourhood) an edge is merely drawn behind front faces that hide it. Of an edge between four faces both back
//! ones cancel, so that objects that share an edge may lack it.

/// Most that a rounded corner may fall short of its arc, in pixels.
const ROUNDING_PX: f64 = 0.2;

/// Most triangles of a fan.
const MAX_FAN: u32 = 16;

/// Triangles of a fan that rounds the end of a line with an arc of `width_px` as its radius and `sweep_rad` as its angle:
/// as few as keep its chords within a fifth of a pixel of the arc, 1 to 16.
pub fn fan_triangles(width_px: f64, sweep_rad: f64) -> u32 {
    let sagitta = |count: u32| width_px * (1.0 - (0.5 * sweep_rad / f64::from(count)).cos());
    (1..MAX_FAN).find(|&count| sagitta(count) <= ROUNDING_PX).unwrap_or(MAX_FAN)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    #[test]
    fn wider_lines_and_wider_angles_take_more_triangles() {
        let counts = [0.5, 2.0, 5.0, 20.0].map(|width_px| fan_triangles(width_px, FRAC_PI_2));
        assert_eq!(counts, [1, 2, 3, 6]);
        assert_eq!(fan_triangles(2.0, PI), 4);
        assert_eq!(fan_triangles(1e9, PI), 16);
    }
}
