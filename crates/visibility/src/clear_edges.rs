//! [`ClearEdges`]: mesh edges that pass through no face, so that no view need ask whether they do.
//!
//! On most meshes almost no edge meets a face that it does not share a vertex with, and whether it does is the same from
//! everywhere. Each edge that a view has asked about is remembered; for many views, all are asked beforehand.

use crate::events::{Passage, passage, touches};
use crate::face_tree::FaceTree;
use rayon::prelude::*;
use silhouette_core::glam::Vec3;
use silhouette_core::{Cancelled, EdgeId, FaceId, Progress, Topology, TriangleMesh};
use std::sync::atomic::{AtomicU64, Ordering};

/// Edges that one word of the set tells of.
const EDGES_PER_WORD: usize = u64::BITS as usize;

/// Words that a task fills: some ms of work.
const WORDS_PER_TASK: usize = 32;

/// How a segment meets a face.
#[derive(Debug, Clone, Copy)]
pub struct Meeting {
    /// The face.
    pub face: FaceId,
    /// Which ends of the segment may lie on it, not being its vertices.
    pub touched: [bool; 2],
    /// Where the segment passes through it. `None` for a face with which it shares a vertex: they meet there and nowhere
    /// else.
    pub passage: Option<Passage>,
}

/// Visits the meetings of a segment with faces, those left out for which `is_own` holds. `vertices` are the segment's, or
/// numbers that no vertex of the mesh has. Exact but for `touched`, which may tell of a point beside a corner in the face's
/// plane. O(log F + faces around it).
pub fn meetings(
    mesh: &TriangleMesh,
    tree: &FaceTree,
    ends: [Vec3; 2],
    vertices: [u32; 2],
    is_own: impl Fn(FaceId) -> bool,
    mut visit: impl FnMut(Meeting),
) {
    tree.faces_at(ends[0], ends[1], |face| {
        if is_own(face) {
            return;
        }
        let (of_face, corners) = (mesh.triangles()[face.index()], mesh.corners(face));
        let shared = vertices.map(|vertex| of_face.contains(&vertex));
        let touched = [0, 1].map(|end: usize| !shared[end] && touches(ends[end], corners));
        let passage = if shared == [false; 2] { passage(ends, corners) } else { None };
        if touched != [false; 2] || passage.is_some() {
            visit(Meeting { face, touched, passage });
        }
    });
}

/// Mesh edges that are known to meet no face but those at their vertices: a bit an edge.
#[derive(Debug, Default)]
pub struct ClearEdges(Vec<AtomicU64>);

impl ClearEdges {
    /// Nothing is known of any edge.
    pub fn new(edges: usize) -> Self {
        Self((0..edges.div_ceil(EDGES_PER_WORD)).map(|_| AtomicU64::new(0)).collect())
    }

    /// All clear edges of a mesh. O(E log F), parallel.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn of(
        mesh: &TriangleMesh,
        topology: &Topology,
        tree: &FaceTree,
        progress: &dyn Progress,
    ) -> Result<Self, Cancelled> {
        let edges = topology.edge_count();
        let known = Self::new(edges);
        progress.stage("clear edges", known.0.len() as u64);
        let words = (0..known.0.len()).into_par_iter().with_min_len(WORDS_PER_TASK);
        words.try_for_each(|word| {
            progress.check()?;
            let of_word = word * EDGES_PER_WORD..edges.min((word + 1) * EDGES_PER_WORD);
            for edge in of_word.map(EdgeId::from_usize) {
                let vertices = topology.edges()[edge];
                let ends = vertices.map(|vertex| mesh.positions()[vertex as usize]);
                let mut is_clear = true;
                let is_own = |face| topology.faces(edge).any(|own| own == face);
                meetings(mesh, tree, ends, vertices, is_own, |_| is_clear = false);
                if is_clear {
                    known.insert(edge);
                }
            }
            progress.advance(1);
            Ok(())
        })?;
        Ok(known)
    }

    /// Whether an edge is known to be clear.
    pub fn contains(&self, edge: EdgeId) -> bool {
        self.0[edge.index() / EDGES_PER_WORD].load(Ordering::Relaxed) >> (edge.index() % EDGES_PER_WORD) & 1 == 1
    }

    /// Notes that an edge is clear.
    pub fn insert(&self, edge: EdgeId) {
        self.0[edge.index() / EDGES_PER_WORD].fetch_or(1 << (edge.index() % EDGES_PER_WORD), Ordering::Relaxed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::{NoProgress, PreparedMesh};

    /// A face in the xy plane and another that hangs above it but for its `apex`: the edges that are clear, and the others.
    fn clear_edges(apex: Vec3) -> (Vec<[u32; 2]>, Vec<[u32; 2]>) {
        let floor = [Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, -1.0, 0.0), Vec3::new(0.0, 1.0, 0.0)];
        let fin = [Vec3::new(0.0, 0.0, 1.0), Vec3::new(5.0, 0.0, 1.0), apex];
        let positions = [floor, fin].concat();
        let prepared = PreparedMesh::new(TriangleMesh::new(positions, vec![[0, 1, 2], [3, 4, 5]]).unwrap());
        let topology = prepared.artefact::<Topology>("test", &NoProgress).unwrap();
        let tree = FaceTree::new(prepared.mesh());
        let known = ClearEdges::of(prepared.mesh(), &topology, &tree, &NoProgress).unwrap();
        let ends = |wanted: bool| {
            let of_kind = topology.edges().ids().filter(|&edge| known.contains(edge) == wanted);
            of_kind.map(|edge| topology.edges()[edge]).collect::<Vec<_>>()
        };
        (ends(true), ends(false))
    }

    #[test]
    fn an_edge_that_pierces_or_touches_a_face_is_not_clear() {
        let (clear, others) = clear_edges(Vec3::new(0.0, 0.0, 0.5));
        assert_eq!((clear.len(), others), (6, vec![]));
        let (_, others) = clear_edges(Vec3::new(0.0, 0.0, -1.0));
        assert_eq!(others, [[1, 2], [3, 5]], "one of either passes through the other");
        let (_, others) = clear_edges(Vec3::ZERO);
        assert_eq!(others, [[3, 5], [4, 5]], "both end on the face");
    }
}
