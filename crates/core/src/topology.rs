//! [`Topology`]: the edges of a mesh with all their incident faces, and twin half-edges.
//!
//! # How it is built
//!
//! Half-edges are distributed by their lower vertex (a counting sort whose buckets are contiguous in memory), each bucket
//! is sorted by `(higher vertex, half-edge)`, and runs of equal vertex pairs become edges. Ranges of vertices are
//! independent, so rayon works on them in parallel; each task scans the triangles for its own range, which costs O(F) a
//! task but needs no shared counters. O(F log d) work for vertex degree d; the result does not depend on the number of
//! threads.
//!
//! # Rules for meshes that are no manifold
//!
//! An edge with one incident half-edge is a *boundary edge*, with two an *interior edge*, with more *non-manifold*. Two
//! half-edges that run in the same direction (inconsistent winding) still make an interior edge and are still twins. A
//! degenerate side from a vertex to itself (a face that names a vertex twice) is an edge `(a, a)` like any other.

mod build;

use crate::id::{EdgeId, FaceId, HalfEdgeId, PerEdge, PerHalfEdge, VertexId};
use crate::mesh::TriangleMesh;
use crate::prepared::{Artefact, PreparedMesh};
use crate::progress::{Cancelled, Progress};

/// What lies across a half-edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Twin {
    /// The other half-edge of an interior edge.
    HalfEdge(HalfEdgeId),
    /// Nothing: a boundary edge.
    Boundary,
    /// Two or more other faces: ask [`Topology::half_edges`] of the edge.
    NonManifold,
}

const BOUNDARY: u32 = u32::MAX;
const NON_MANIFOLD: u32 = u32::MAX - 1;

/// Edges with all their incident faces; twin half-edges with the twin's slot.
///
/// Edges are sorted by `(a, b)` with `a <= b`, half-edge ids are `3 * face + slot`. Memory: 8 bytes a half-edge for the
/// twin and the edge, 4 for the incidence lists, 12 an edge; for a closed mesh (E = 1.5 F) 54 bytes a face.
#[derive(Debug, Clone)]
pub struct Topology {
    edges: PerEdge<[u32; 2]>,
    /// Incident half-edges of edge `e` are `incident[first[e]..first[e + 1]]`, ascending.
    first: Vec<u32>,
    incident: Vec<HalfEdgeId>,
    edge_of: PerHalfEdge<EdgeId>,
    twins: PerHalfEdge<u32>,
}

impl Topology {
    /// Builds the topology of `mesh`. See the [module](self) for method and cost.
    pub fn new(mesh: &TriangleMesh) -> Self {
        build::build(mesh)
    }

    /// Number of edges E.
    pub fn edge_count(&self) -> usize {
        self.edges.len()
    }

    /// Number of half-edges, 3 F.
    pub fn half_edge_count(&self) -> usize {
        self.twins.len()
    }

    /// All edges as vertex pairs `(a <= b)`, sorted.
    pub fn edges(&self) -> &PerEdge<[u32; 2]> {
        &self.edges
    }

    /// The end points of an edge, lower vertex first.
    ///
    /// # Panics
    /// If the mesh has no such edge.
    pub fn end_points(&self, edge: EdgeId) -> [VertexId; 2] {
        self.edges[edge].map(VertexId::new)
    }

    /// The edge between two vertices, in either order. O(log E).
    pub fn find_edge(&self, a: VertexId, b: VertexId) -> Option<EdgeId> {
        let key = [a.min(b).get(), a.max(b).get()];
        self.edges.as_slice().binary_search(&key).ok().map(EdgeId::from_usize)
    }

    /// The half-edges of an edge, ascending: one for a boundary edge, two for an interior edge, more for a non-manifold
    /// one.
    ///
    /// # Panics
    /// If the mesh has no such edge.
    #[inline]
    pub fn half_edges(&self, edge: EdgeId) -> &[HalfEdgeId] {
        &self.incident[self.first[edge.index()] as usize..self.first[edge.index() + 1] as usize]
    }

    /// The faces at an edge, in the order of [`half_edges`](Self::half_edges).
    ///
    /// # Panics
    /// If the mesh has no such edge.
    pub fn faces(&self, edge: EdgeId) -> impl ExactSizeIterator<Item = FaceId> + '_ {
        self.half_edges(edge).iter().map(|half_edge| half_edge.face())
    }

    /// The two faces of an edge that joins exactly two, wound consistently: their half-edges run in opposite directions.
    /// `None` for boundary and non-manifold edges, where the winding changes, for sides from a vertex to itself, and for two
    /// sides of one face. `mesh` is the mesh that this was built from.
    ///
    /// # Panics
    /// If the mesh has no such edge.
    pub fn consistent_pair(&self, mesh: &TriangleMesh, edge: EdgeId) -> Option<[FaceId; 2]> {
        let &[a, b] = self.half_edges(edge) else { return None };
        let begins = |at: HalfEdgeId| mesh.triangles()[at.face().index()][at.slot() as usize];
        let [from, to] = self.end_points(edge);
        (from != to && a.face() != b.face() && begins(a) != begins(b)).then(|| [a.face(), b.face()])
    }

    /// A copy in which nothing lies across some edges: each of their half-edges has a border there, whatever it had
    /// before. Ids and the faces at each edge stay as they are, so results name the elements of the original. O(F).
    ///
    /// # Panics
    /// If the mesh has no such edge.
    #[must_use]
    pub fn severed(&self, edges: impl IntoIterator<Item = EdgeId>) -> Self {
        let mut severed = self.clone();
        for &half_edge in edges.into_iter().flat_map(|edge| self.half_edges(edge)) {
            severed.twins[half_edge] = BOUNDARY;
        }
        severed
    }

    /// The edge that a half-edge belongs to.
    ///
    /// # Panics
    /// If the mesh has no such half-edge.
    #[inline]
    pub fn edge_of(&self, half_edge: HalfEdgeId) -> EdgeId {
        self.edge_of[half_edge]
    }

    /// What lies across a half-edge.
    ///
    /// # Panics
    /// If the mesh has no such half-edge.
    #[inline]
    pub fn twin(&self, half_edge: HalfEdgeId) -> Twin {
        match self.twins[half_edge] {
            BOUNDARY => Twin::Boundary,
            NON_MANIFOLD => Twin::NonManifold,
            twin => Twin::HalfEdge(HalfEdgeId::new(twin)),
        }
    }

    /// Number of edges with exactly one incident face. O(E).
    pub fn boundary_edge_count(&self) -> usize {
        self.first.windows(2).filter(|ends| ends[1] - ends[0] == 1).count()
    }

    /// Number of edges with three or more incident half-edges. O(E).
    pub fn non_manifold_edge_count(&self) -> usize {
        self.first.windows(2).filter(|ends| ends[1] - ends[0] > 2).count()
    }
}

impl Artefact for Topology {
    const NAME: &'static str = "topology";

    fn build(mesh: &PreparedMesh, progress: &dyn Progress) -> Result<Self, Cancelled> {
        progress.check()?;
        progress.stage("topology", 1);
        let topology = Self::new(mesh.mesh());
        progress.advance(1);
        Ok(topology)
    }

    fn bytes(&self) -> usize {
        size_of_val(self.edges.as_slice())
            + size_of_val(self.first.as_slice())
            + size_of_val(self.incident.as_slice())
            + size_of_val(self.edge_of.as_slice())
            + size_of_val(self.twins.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    fn soup(vertices: u32, triangles: Vec<[u32; 3]>) -> TriangleMesh {
        let positions = (0..vertices).map(|i| Vec3::new(i as f32, (i * i) as f32, 0.0)).collect();
        TriangleMesh::new(positions, triangles).unwrap()
    }

    /// Every half-edge by its sorted vertex pair, through an ordered map: the oracle.
    fn incidence(mesh: &TriangleMesh) -> BTreeMap<[u32; 2], Vec<HalfEdgeId>> {
        let mut map = BTreeMap::<_, Vec<_>>::new();
        for (face, t) in mesh.triangles().iter().enumerate() {
            for slot in 0..3 {
                let (a, b) = (t[slot], t[(slot + 1) % 3]);
                map.entry([a.min(b), a.max(b)]).or_default().push(HalfEdgeId::from_usize(3 * face + slot));
            }
        }
        map
    }

    fn check(mesh: &TriangleMesh) {
        let topology = Topology::new(mesh);
        let expected = incidence(mesh);
        assert!(topology.edges().as_slice().iter().eq(expected.keys()));
        for (edge, half_edges) in topology.edges().ids().zip(expected.values()) {
            assert_eq!(topology.half_edges(edge), half_edges);
            for &half_edge in half_edges {
                assert_eq!(topology.edge_of(half_edge), edge);
                let others: Vec<_> = half_edges.iter().copied().filter(|&other| other != half_edge).collect();
                let twin = match others[..] {
                    [] => Twin::Boundary,
                    [twin] => Twin::HalfEdge(twin),
                    _ => Twin::NonManifold,
                };
                assert_eq!(topology.twin(half_edge), twin);
            }
        }
    }

    #[test]
    fn faces_that_share_two_edges_keep_their_slots_apart() {
        let mesh = soup(4, vec![[0, 1, 2], [0, 2, 1], [0, 1, 3]]);
        check(&mesh);
        let topology = Topology::new(&mesh);
        let edge = topology.find_edge(VertexId::new(2), VertexId::new(1)).unwrap();
        assert_eq!(topology.half_edges(edge), [HalfEdgeId::new(1), HalfEdgeId::new(4)]);
        assert_eq!((topology.boundary_edge_count(), topology.non_manifold_edge_count()), (2, 1));
        assert_eq!(topology.find_edge(VertexId::new(2), VertexId::new(3)), None);
    }

    #[test]
    fn a_severed_edge_keeps_its_faces_but_has_borders() {
        let mesh = soup(4, vec![[0, 1, 2], [2, 1, 3], [1, 2, 0]]);
        let topology = Topology::new(&mesh);
        let edge = topology.find_edge(VertexId::new(1), VertexId::new(2)).unwrap();
        assert_eq!(topology.twin(HalfEdgeId::new(3)), Twin::NonManifold);
        let severed = topology.severed([edge]);
        assert_eq!(severed.half_edges(edge), topology.half_edges(edge));
        for half_edge in (0..9).map(HalfEdgeId::new) {
            let expected = if topology.edge_of(half_edge) == edge { Twin::Boundary } else { topology.twin(half_edge) };
            assert_eq!(severed.twin(half_edge), expected);
        }
    }

    #[test]
    fn empty_and_single_triangle() {
        check(&soup(0, vec![]));
        check(&soup(5, vec![[4, 2, 0]]));
    }

    proptest! {
        #[test]
        fn any_soup_equals_the_map(triangles in prop::collection::vec(prop::array::uniform3(0_u32..12), 0..60)) {
            check(&soup(12, triangles));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(12))]

        /// Enough faces for the ranges to be balanced, most of them among low ids.
        #[test]
        fn any_number_of_threads_gives_the_same(
            triangles in prop::collection::vec(prop::array::uniform3(0_u32..900), 1100..2000), threads in 1_usize..6,
        ) {
            let mesh = soup(3000, triangles);
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| check(&mesh));
        }
    }
}
