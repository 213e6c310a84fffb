//! [`ClearEdges`]: mesh edges that pass through no face, so that no view need ask whether they do.
//!
//! On most meshes almost no edge meets a face that it does not share a vertex with, and whether it does is the same from
//! everywhere. Each edge that a view has asked about is remembered; for many views, all are asked beforehand.

use crate::candidate::Candidate;
use crate::face_tree::FaceTree;
use crate::piercing::{Passage, passage, touches};
use rayon::prelude::*;
use silhouette_core::glam::Vec3;
use silhouette_core::{Cancelled, EdgeId, FaceId, Progress, Topology, TriangleMesh};
use std::sync::atomic::{AtomicU64, Ordering};

/// Edges that one word of the set tells of.
const EDGES_PER_WORD: usize = u64::BITS as usize;

/// Words that a task fills: some ms of work.
const WORDS_PER_TASK: usize = 32;

/// Faces that are looked at for an edge, on the mean, before the rest is given up. On a surface it is about a dozen.
const MOST_FACES_AN_EDGE: u64 = 256;

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

/// A segment that may meet faces.
#[derive(Debug, Clone, Copy)]
pub struct Segment {
    /// Its ends.
    pub ends: [Vec3; 2],
    /// The mesh's vertices at its ends, or numbers that no vertex of the mesh has.
    pub vertices: [u32; 2],
}

impl Segment {
    /// How this segment meets a face that may lie along it. Exact but for `touched`, which may tell of a point beside a corner
    /// in the face's plane. O(1).
    #[inline]
    pub fn meeting(&self, mesh: &TriangleMesh, candidate: &Candidate) -> Option<Meeting> {
        let &Candidate { face, vertices, may_hold } = candidate;
        let shared = self.vertices.map(|vertex| vertices.contains(&vertex));
        let may_touch = [0, 1].map(|end: usize| may_hold[end] && !shared[end]);
        let may_pass = shared == [false; 2];
        if !may_pass && may_touch == [false; 2] {
            return None;
        }
        let corners = mesh.corners(face);
        let touched = [0, 1].map(|end: usize| may_touch[end] && touches(self.ends[end], corners));
        let passage = if may_pass { passage(self.ends, corners) } else { None };
        (touched != [false; 2] || passage.is_some()).then_some(Meeting { face, touched, passage })
    }
}

/// Mesh edges that are known to meet no face but those at their vertices: a bit an edge.
#[derive(Debug, Default)]
pub struct ClearEdges(Vec<AtomicU64>);

impl ClearEdges {
    /// Nothing is known of any edge.
    pub fn new(edges: usize) -> Self {
        Self((0..edges.div_ceil(EDGES_PER_WORD)).map(|_| AtomicU64::new(0)).collect())
    }

    /// All clear edges of a mesh, unless very many faces lie in one place: then what is not known soon is left to the views
    /// that need it. O(E log F), parallel.
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
        let most = MOST_FACES_AN_EDGE * edges as u64;
        let looked_at = AtomicU64::new(0);
        progress.stage("clear edges", known.0.len() as u64);
        let words = (0..known.0.len()).into_par_iter().with_min_len(WORDS_PER_TASK);
        words.try_for_each(|word| {
            progress.check()?;
            if looked_at.load(Ordering::Relaxed) > most {
                return Ok(());
            }
            let of_word = word * EDGES_PER_WORD..edges.min((word + 1) * EDGES_PER_WORD);
            let segment = |edge: usize| {
                let vertices = topology.edges()[EdgeId::from_usize(edge)];
                (vertices.map(|vertex| mesh.positions()[vertex as usize]), vertices)
            };
            let segments: Vec<_> = of_word.clone().map(segment).collect();
            let (mut is_clear, mut faces) = (vec![true; segments.len()], 0);
            tree.faces_at_each(&segments, |index, candidate| {
                faces += 1;
                let (ends, vertices) = segments[index];
                let is_own =
                    || topology.faces(EdgeId::from_usize(of_word.start + index)).any(|own| own == candidate.face);
                let meets = || Segment { ends, vertices }.meeting(mesh, &candidate).is_some();
                is_clear[index] &= !meets() || is_own();
            });
            looked_at.fetch_add(faces, Ordering::Relaxed);
            of_word
                .zip(is_clear)
                .filter(|(_, clear)| *clear)
                .for_each(|(edge, _)| known.insert(EdgeId::from_usize(edge)));
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

    /// Very many faces in one place, and one elsewhere: all pairs are not looked at, and what is not known is not told.
    #[test]
    fn a_crowd_is_left_to_the_views() {
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y];
        let is_last_known = |crowd: u32| {
            let positions =
                (0..=crowd).flat_map(|face| corners.map(|corner| corner + Vec3::Z * f32::from(face == crowd)));
            let triangles = (0..=crowd).map(|face| [0, 1, 2].map(|slot| 3 * face + slot));
            let mesh = TriangleMesh::new(positions.collect(), triangles.collect()).unwrap();
            let topology = Topology::new(&mesh);
            let known = ClearEdges::of(&mesh, &topology, &FaceTree::new(&mesh), &NoProgress).unwrap();
            assert!(!known.contains(EdgeId::new(0)));
            known.contains(EdgeId::from_usize(topology.edge_count() - 1))
        };
        assert!(is_last_known(2) && !is_last_known(MOST_FACES_AN_EDGE as u32 * 2));
    }
}
