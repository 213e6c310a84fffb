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

/// Vertices drawn for an edge: a quad and two fans of three triangles. Twin of the constants in `screen.wgsl` and
/// `back_edges.wgsl`.
pub const VERTICES_PER_EDGE: u32 = 24;

/// Share of a line's width that is missing at most where a fan of three triangles rounds a corner: its sagitta,
/// `1 - cos(15 degrees)`.
pub const ROUNDING: f64 = 0.034_1;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fans_round_corners_as_stated() {
        assert!((ROUNDING - (1.0 - 15.0_f64.to_radians().cos())).abs() < 1e-4);
    }
}
