//! The half-edges on both sides of an edge, as an edge of the silhouette that is or was.

use crate::connectivity_table::ConnectivityTable;
use silhouette_core::{FaceFacings, HalfEdgeId};

/// The two half-edges at a side of a face that are silhouette or were, and whether each is one now.
pub(super) fn sides_of(
    table: &ConnectivityTable,
    facings: &FaceFacings,
    half_edge: HalfEdgeId,
) -> [Option<(HalfEdgeId, bool)>; 2] {
    let is_front = facings.is_front(half_edge.face());
    match table.twin(half_edge) {
        Some(twin) => {
            let is_front_across = facings.is_front(twin.face());
            [Some((half_edge, is_front && !is_front_across)), Some((twin, is_front_across && !is_front))]
        }
        None => [Some((half_edge, is_front)), None],
    }
}
