//! What a face changes by turning.

use super::sides::sides_of;
use super::walk::LoopWeaver;
use crate::connectivity_table::ConnectivityTable;
use silhouette_core::{FaceFacings, FaceId, HalfEdgeId};

/// Notes which old half-edges are silhouette no more, which are new, and which lead elsewhere, because `face` turned.
/// `facings` are those of now. O(faces around its corners).
///
/// The way past a vertex changes in three cases. The half-edge that led to it, or away from it, is gone: noted with the
/// edges of the face. Or a face of the front fan between them has turned away, and the loop now bends into the fan: then
/// the half-edge that leads to the vertex is found by turning back through the fan, as it was.
pub(super) fn note_changes(table: &ConnectivityTable, facings: &FaceFacings, face: FaceId, weaver: &mut LoopWeaver) {
    let was_front = !facings.is_front(face);
    for side in [0, 1, 2].map(|slot| HalfEdgeId::of(face, slot)) {
        for (half_edge, is_silhouette) in sides_of(table, facings, side).into_iter().flatten() {
            if is_silhouette {
                weaver.note_new(half_edge);
            } else {
                weaver.note_gone(half_edge);
            }
        }
        if was_front {
            note_bend(table, side, weaver);
        }
    }
}

/// Turns back from a face that was front, about the vertex where its side `start` begins, to the old half-edge that leads
/// to the vertex. There is none where all faces around it were front.
fn note_bend(table: &ConnectivityTable, start: HalfEdgeId, weaver: &mut LoopWeaver) {
    let mut inside = start;
    loop {
        let ending = inside.next_in_face().next_in_face();
        if weaver.note_bent(ending) {
            return;
        }
        match table.twin(ending) {
            Some(across) if across != start => inside = across,
            _ => return,
        }
    }
}
