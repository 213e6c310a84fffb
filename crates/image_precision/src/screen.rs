//! Ours: edges of back faces expanded in the image plane, as wide as asked for everywhere.
//!
//! 1. `face_list.wgsl` classifies every face once and lists back faces.
//! 2. `back_edges.wgsl` counts, for each edge of a listed face, the listed faces that have it. Edges are known by the positions
//!    of their ends, so that a soup without shared vertices is served as well. An edge counted twice lies between back faces
//!    and cannot be a silhouette edge; the others are listed.
//! 3. `screen.wgsl` draws each listed edge as a convex polygon beside the projected edge, outwards of its face and around either
//!    end, which rounds corners: two triangles for lines of 2 px. The edge is clipped at the near plane first. Depth is that of
//!    the edge, so that front faces before it hide it and it covers what lies behind.
//!
//! Fattening in the polygon's plane, as the paper does, slides along the edge and makes spikes
//! ([`fatten`](crate::fatten)); moving the edge in the image does not.
//!
//! Counting needs no preparation and no adjacency: it is O(F) on the adapter in every frame. An edge that finds no place in
//! the table within the longest probe is drawn, hidden or not. Of an edge between four faces both back
//! ones cancel, so that objects that share an edge may lack it.

use std::f64::consts::FRAC_PI_2;

/// Most that a rounded corner may fall short of its arc or reach beyond it, in pixels.
const ROUNDING_PX: f64 = 0.2;

/// Most sides around the end of a line.
const MAX_END_SIDES: u32 = 16;

/// How the end of a line is rounded: a polygon around an arc whose radius is how far the line reaches beside its edge.
///
/// The outer corners reach beyond the end, so that lines which turn a little meet without a gap; the sides go on from there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rounding {
    /// How far outer corners reach beyond the end of the line, over its reach beside it.
    pub corner: f64,
    /// Sides around the end, 1 to 16.
    pub end_sides: u32,
    /// Whether ink lies on both sides of the edge, so that the arc is half a turn; otherwise a quarter.
    pub is_centred: bool,
}

impl Rounding {
    /// No rounding: a centred line ends where its edge does.
    pub const BLUNT: Self = Self { corner: 0.0, end_sides: 1, is_centred: true };

    /// Points of the polygon, from the outer corner to straight ahead, or to the other corner: how far beside the edge and how
    /// far beyond its end, in reaches. Those beyond the last repeat nothing and are zero.
    #[cfg(feature = "gpu")]
    pub(crate) fn rim(&self) -> [[f32; 4]; MAX_END_SIDES as usize + 1] {
        let first = self.corner.atan();
        let sweep = if self.is_centred { 2.0 } else { 1.0 } * (FRAC_PI_2 - first);
        let mut rim = [[0.0; 4]; MAX_END_SIDES as usize + 1];
        for (step, point) in (0..=self.end_sides).zip(&mut rim) {
            let is_corner = step == 0 || (self.is_centred && step == self.end_sides);
            let radius = if is_corner { self.corner.hypot(1.0) } else { 1.0 };
            let (sine, cosine) = (first + sweep * f64::from(step) / f64::from(self.end_sides)).sin_cos();
            *point = [(radius * cosine) as f32, (radius * sine) as f32, 0.0, 0.0];
        }
        rim
    }
}

/// The rounding of a line whose ends are arcs of `width_px` as their radius: as few triangles as keep it within a fifth of
/// a pixel of the arcs. One-sided lines are rounded by a quarter of a turn, centred ones by half a turn.
pub fn rounding(width_px: f64, is_centred: bool) -> Rounding {
    let reach = (width_px / (width_px + ROUNDING_PX)).acos();
    let corners = if is_centred { 2.0 } else { 1.0 };
    let sweep = corners * (FRAC_PI_2 - reach);
    // The chord next to a corner begins as far outside of the arc as it may end inside.
    let sagitta = |count: u32| width_px * (1.0 - (0.5 * sweep / f64::from(count)).cos());
    let end_sides = (1..MAX_END_SIDES).find(|&count| sagitta(count) <= 2.0 * ROUNDING_PX).unwrap_or(MAX_END_SIDES);
    Rounding { corner: reach.tan(), end_sides, is_centred }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wider_lines_take_more_triangles_and_reach_less() {
        let counts = [0.5, 2.0, 5.0, 20.0].map(|width_px| rounding(width_px, false).end_sides);
        assert_eq!(counts, [1, 1, 2, 4]);
        assert!(rounding(2.0, true).end_sides > 1 && rounding(1e9, true).end_sides == 16);
        for width_px in [0.5, 2.0, 20.0, 1000.0] {
            let Rounding { corner, .. } = rounding(width_px, false);
            let beyond = width_px * corner.hypot(1.0) - width_px;
            assert!((beyond - ROUNDING_PX).abs() < 1e-6, "{width_px}: {beyond}");
        }
        assert!(rounding(0.0, false).corner.is_finite());
    }
}
