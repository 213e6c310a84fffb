//! Detecting new silhouettes (Hall 2003): in the concave list, then in the boundary list.
//!
//! A face that turns while its neighbours do not is born, or dies, as a silhouette of its own: that happens at a
//! concave edge of the face, or at a boundary edge, as long as the eye does not cross the surface. Parts that split off a
//! silhouette are no births, and tracking has to follow them.

use crate::complete_silhouette::FoundLoops;
use crate::concave_edges::ActiveEdges;
use crate::faces::Faces;
use crate::stats::TrackingStats;
use silhouette_core::HalfEdgeId;

/// Completes the loops that hold a selected concave edge. The faces at those edges must have been evaluated.
pub(crate) fn detect_in_concave_list(
    faces: &mut Faces,
    loops: &mut FoundLoops,
    active: &ActiveEdges,
    stats: &mut TrackingStats,
) {
    stats.edges_tested += active.half_edges.len() as u64;
    for &[one, other] in &active.half_edges {
        let is_front = faces.recall(one.face());
        if is_front != faces.recall(other.face()) {
            complete_new(faces, loops, if is_front { one } else { other });
        }
    }
}

/// Completes the loops that hold a boundary edge of a front face.
pub(crate) fn detect_in_boundary_list(
    faces: &mut Faces,
    loops: &mut FoundLoops,
    boundary: &[HalfEdgeId],
    stats: &mut TrackingStats,
) {
    stats.edges_tested += boundary.len() as u64;
    for &half_edge in boundary {
        if faces.is_front(half_edge.face()) {
            complete_new(faces, loops, half_edge);
        }
    }
}

/// Completes a loop unless it was found before.
pub(crate) fn complete_new(faces: &mut Faces, loops: &mut FoundLoops, half_edge: HalfEdgeId) {
    if !loops.is_found(half_edge) {
        loops.complete(faces, half_edge);
    }
}
