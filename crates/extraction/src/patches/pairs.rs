//! Edges as pairs of faces, in a form that one rule tests: *a pair is silhouette iff its two sides face differently*.
//!
//! - An interior edge is one pair.
//! - A boundary edge is a pair of its face and [`OUTSIDE`], a side that is always back.
//! - An edge of k > 2 half-edges is k - 1 pairs, each face with the next: they all agree iff every pair agrees. The edge
//!   may then be found up to k - 1 times.
//! - Two half-edges of one face at the same edge never differ and make no pair.

use silhouette_core::{FaceId, HalfEdgeId, Topology};

/// The other side of a boundary edge.
pub(crate) const OUTSIDE: u32 = u32::MAX;

/// A face's part in one pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Pair {
    pub(crate) edge: u32,
    /// The other face, or [`OUTSIDE`].
    pub(crate) other: u32,
    /// Whether the face that was asked for is the first of the two: true for just one of the two sides of a pair.
    pub(crate) leads: bool,
}

/// The pairs that a face belongs to: at most six.
pub(crate) fn pairs_of(topology: &Topology, face: u32) -> impl Iterator<Item = Pair> {
    (0..3).flat_map(move |slot| {
        let half_edge = HalfEdgeId::of(FaceId::new(face), slot);
        let edge = topology.edge_of(half_edge);
        let around = topology.half_edges(edge);
        let [before, after] = if around.len() == 1 {
            [None, Some(OUTSIDE)]
        } else {
            let index = around.binary_search(&half_edge).expect("half-edges at an edge ascend");
            let face_at = |index: usize| around.get(index).map(|other| other.face().get());
            [index.checked_sub(1).and_then(face_at), face_at(index + 1)]
        };
        let pair = move |other, leads| Pair { edge: edge.get(), other, leads };
        let sides = [before.map(|other| pair(other, false)), after.map(|other| pair(other, true))];
        sides.into_iter().flatten().filter(move |pair| pair.other != face)
    })
}
