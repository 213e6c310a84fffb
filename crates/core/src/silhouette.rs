//! The silhouette edges that follow from a facing.

use crate::facing::FaceFacings;
use crate::id::{EdgeId, FaceId, VertexId};
use crate::mesh::TriangleMesh;
use crate::topology::Topology;
use crate::view::Viewpoint;
use rayon::prelude::*;

/// Silhouette edges of one view, sorted by id.
///
/// A *silhouette edge* has incident faces of both facings, or is a boundary edge whose face is front. A non-manifold edge
/// is one iff its faces do not all face the same way: the same rule.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct SilhouetteEdges(Vec<EdgeId>);

/// Edges that a task looks at: some 0.02 ms of work.
const EDGES_PER_TASK: usize = 8192;

/// The [silhouette edges](SilhouetteEdges) of a mesh from one viewpoint, as pairs of vertices, the lower id first, ascending. Exact.
///
/// For one view: it builds the topology, O(F), and forgets it. For several keep a [`Topology`] and ask [`SilhouetteEdges::of`], or
/// an extractor of `silhouette-extraction`.
///
/// ```
/// use silhouette_core::{Viewpoint, glam::Vec3, shapes, silhouette_edges};
///
/// let cube = shapes::by_name("cube")?;
/// assert_eq!(silhouette_edges(&cube, &Viewpoint::Orthographic { toward_viewer: Vec3::ONE }).len(), 6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn silhouette_edges(mesh: &TriangleMesh, viewpoint: &Viewpoint) -> Vec<[VertexId; 2]> {
    let topology = Topology::new(mesh);
    let edges = SilhouetteEdges::of(&topology, &FaceFacings::new(mesh, viewpoint));
    edges.iter().map(|edge| topology.end_points(edge)).collect()
}

/// Whether an edge belongs to the silhouette of `facings`. O(faces at the edge).
///
/// # Panics
/// If the topology has no such edge, or `facings` is of another mesh.
pub fn is_silhouette_edge(topology: &Topology, facings: &FaceFacings, edge: EdgeId) -> bool {
    is_silhouette_edge_where(topology, |face| facings.is_front(face), edge)
}

/// [`is_silhouette_edge`] for facings that are looked up, or found, one by one.
///
/// # Panics
/// If the topology has no such edge.
pub fn is_silhouette_edge_where(topology: &Topology, mut is_front: impl FnMut(FaceId) -> bool, edge: EdgeId) -> bool {
    let half_edges = topology.half_edges(edge);
    let first_is_front = is_front(half_edges[0].face());
    if half_edges.len() == 1 {
        return first_is_front;
    }
    half_edges[1..].iter().any(|other| is_front(other.face()) != first_is_front)
}

impl SilhouetteEdges {
    /// The silhouette edges of any facing. O(E), parallel.
    pub fn of(topology: &Topology, facings: &FaceFacings) -> Self {
        let edges = (0..topology.edge_count()).into_par_iter().with_min_len(EDGES_PER_TASK).map(EdgeId::from_usize);
        Self(edges.filter(|&edge| is_silhouette_edge(topology, facings, edge)).collect())
    }

    /// Replaces the edges; `edges` in any order, duplicates allowed. O(S log S), no allocation once grown.
    pub fn refill(&mut self, edges: impl IntoIterator<Item = EdgeId>) {
        self.0.clear();
        self.0.extend(edges);
        self.0.sort_unstable();
        self.0.dedup();
    }

    /// Replaces the edges by ones that ascend without duplicates. O(S), no allocation once grown.
    ///
    /// # Panics
    /// In builds with debug assertions, if they do not ascend.
    pub fn refill_ascending(&mut self, edges: impl IntoIterator<Item = EdgeId>) {
        self.0.clear();
        self.0.extend(edges);
        debug_assert!(self.0.is_sorted_by(|a, b| a < b), "edges must ascend");
    }

    /// The edges, ascending.
    pub fn as_slice(&self) -> &[EdgeId] {
        &self.0
    }

    /// The edges, ascending.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = EdgeId> + '_ {
        self.0.iter().copied()
    }

    /// Those that are boundary edges (of front faces), ascending.
    pub fn boundary<'a>(&'a self, topology: &'a Topology) -> impl Iterator<Item = EdgeId> + 'a {
        self.iter().filter(|&edge| topology.half_edges(edge).len() == 1)
    }

    /// Number of silhouette edges S.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether the silhouette is empty.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether an edge is among them. O(log S).
    pub fn contains(&self, edge: EdgeId) -> bool {
        self.0.binary_search(&edge).is_ok()
    }
}
