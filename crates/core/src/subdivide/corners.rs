//! The corners at each vertex, in two flat arrays.

use crate::id::{FaceId, HalfEdgeId};
use crate::mesh::TriangleMesh;

/// For each vertex the half-edges that leave it, ascending.
pub(super) struct Corners {
    /// Those of vertex v are `leaving[first[v]..first[v + 1]]`.
    first: Vec<u32>,
    leaving: Vec<HalfEdgeId>,
}

impl Corners {
    /// A counting sort of the corners by vertex. O(V + F), on one thread: the scattered writes are bound by memory.
    pub fn of(mesh: &TriangleMesh) -> Self {
        let mut first = vec![0_u32; mesh.vertex_count() + 1];
        for &vertex in mesh.triangles().iter().flatten() {
            first[vertex as usize] += 1;
        }
        let mut end = 0;
        for first in &mut first {
            end += *first;
            *first = end;
        }
        // Filled from behind, so that each `first` walks down from where its vertex ends to where it begins.
        let mut leaving = vec![HalfEdgeId::new(0); end as usize];
        for (corner, &vertex) in mesh.triangles().as_flattened().iter().enumerate().rev() {
            let first = &mut first[vertex as usize];
            *first -= 1;
            leaving[*first as usize] = HalfEdgeId::new(corner as u32);
        }
        Self { first, leaving }
    }

    /// The half-edges that leave `vertex`, one a corner.
    pub fn leaving(&self, vertex: usize) -> &[HalfEdgeId] {
        &self.leaving[self.first[vertex] as usize..self.first[vertex + 1] as usize]
    }
}

/// The half-edges of a face, by slot.
pub(super) fn sides(face: usize) -> [HalfEdgeId; 3] {
    [0, 1, 2].map(|slot| HalfEdgeId::of(FaceId::new(face as u32), slot))
}

/// The half-edge that arrives at the corner which `leaving` leaves.
pub(super) fn arriving(leaving: HalfEdgeId) -> HalfEdgeId {
    leaving.next_in_face().next_in_face()
}

/// The vertex that a half-edge leaves.
pub(super) fn origin(mesh: &TriangleMesh, half_edge: HalfEdgeId) -> u32 {
    mesh.triangles()[half_edge.face().index()][half_edge.slot() as usize]
}
