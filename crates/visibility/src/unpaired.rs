//! [`UnpairedEdges`]: the edges and faces of a mesh that are not part of an ordinary surface.

use rayon::prelude::*;
use silhouette_core::glam::Vec3;
use silhouette_core::orientation::turn;
use silhouette_core::prepared::Artefact;
use silhouette_core::{
    Cancelled, EdgeId, FaceId, HalfEdgeId, PreparedMesh, Progress, Topology, TriangleMesh, Viewpoint,
};

/// Edges that do not join two consistently wound faces with an area: boundary edges, non-manifold edges, edges along which
/// both faces run the same way, edges of a face without area. They may be contours without being silhouette edges, or the
/// other way round. Independent of the view.
#[derive(Debug, Clone, Default)]
pub struct UnpairedEdges {
    /// Ascending.
    edges: Vec<EdgeId>,
    /// Faces without area, ascending.
    flat: Vec<FaceId>,
}

impl UnpairedEdges {
    /// Ascending.
    pub fn as_slice(&self) -> &[EdgeId] {
        &self.edges
    }

    /// Whether an edge is unpaired. O(log U) for U unpaired edges.
    pub fn contains(&self, edge: EdgeId) -> bool {
        self.edges.binary_search(&edge).is_ok()
    }

    /// Whether a face has no area: its corners lie on one line. O(log of their number).
    #[inline]
    pub fn is_flat(&self, face: FaceId) -> bool {
        !self.flat.is_empty() && self.flat.binary_search(&face).is_ok()
    }

    /// Finds them. O(F + E), parallel.
    pub fn new(mesh: &TriangleMesh, topology: &Topology) -> Self {
        let faces = (0..mesh.face_count()).into_par_iter().with_min_len(ELEMENTS_PER_TASK).map(FaceId::from_usize);
        let flat: Vec<FaceId> = faces.filter(|&face| is_on_a_line(mesh.corners(face))).collect();
        let mut made = Self { edges: Vec::new(), flat };
        let edges = (0..topology.edge_count()).into_par_iter().with_min_len(ELEMENTS_PER_TASK).map(EdgeId::from_usize);
        made.edges = edges.filter(|&edge| made.is_unpaired(topology, mesh, edge)).collect();
        made
    }

    fn is_unpaired(&self, topology: &Topology, mesh: &TriangleMesh, edge: EdgeId) -> bool {
        match topology.half_edges(edge) {
            [one, other] => {
                let runs_forward = |half_edge| runs_forward(mesh, topology, edge, half_edge);
                runs_forward(*one) == runs_forward(*other) || self.is_flat(one.face()) || self.is_flat(other.face())
            }
            _ => true,
        }
    }
}

/// Elements that a task looks at: some 0.05 ms of work.
const ELEMENTS_PER_TASK: usize = 8192;

/// Whether three points lie on one line. Exact.
fn is_on_a_line([a, b, c]: [Vec3; 3]) -> bool {
    // In the usual case a product of differences tells so: it errs by less than a thousandth of its terms.
    let (ab, ac) = (b.as_dvec3() - a.as_dvec3(), c.as_dvec3() - a.as_dvec3());
    if (ab.x * ac.y - ab.y * ac.x).abs() > 1e-3 * ((ab.x * ac.y).abs() + (ab.y * ac.x).abs()) {
        return false;
    }
    let along = |axis: Vec3| turn(&Viewpoint::Orthographic { toward_viewer: axis }, a, b, c);
    [Vec3::X, Vec3::Y, Vec3::Z].into_iter().all(|axis| along(axis) == 0.0)
}

/// Whether a half-edge runs from its edge's lower vertex to the higher one.
#[inline]
pub fn runs_forward(mesh: &TriangleMesh, topology: &Topology, edge: EdgeId, half_edge: HalfEdgeId) -> bool {
    mesh.triangles()[half_edge.face().index()][half_edge.slot() as usize] == topology.edges()[edge][0]
}

impl Artefact for UnpairedEdges {
    const NAME: &'static str = "unpaired-edges";

    fn build(mesh: &PreparedMesh, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let topology = mesh.artefact::<Topology>(Self::NAME, progress)?;
        progress.check()?;
        Ok(Self::new(mesh.mesh(), &topology))
    }

    fn bytes(&self) -> usize {
        size_of_val(self.edges.as_slice()) + size_of_val(self.flat.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ordinary_edges_are_paired_and_all_others_are_not() {
        let corners =
            [Vec3::ZERO, Vec3::X, Vec3::new(0.3, 1.0, 0.0), Vec3::new(0.5, -1.0, 0.2), Vec3::new(0.25, 0.0, 0.0)];
        let unpaired = |triangles: &[[u32; 3]]| {
            let mesh = TriangleMesh::new(corners.to_vec(), triangles.to_vec()).unwrap();
            let topology = Topology::new(&mesh);
            let unpaired = UnpairedEdges::new(&mesh, &topology);
            (unpaired.as_slice().len(), topology.edge_count(), unpaired.flat.len())
        };
        assert_eq!(unpaired(&[[0, 1, 2], [1, 0, 3]]), (4, 5, 0), "all but the edge between both");
        assert_eq!(unpaired(&[[0, 1, 2], [0, 1, 3]]), (5, 5, 0), "wound against each other");
        assert_eq!(unpaired(&[[0, 1, 2], [1, 0, 4], [4, 0, 3]]), (7, 7, 1), "next to a face without area");
    }

    #[test]
    fn points_on_a_line_are_told_at_any_scale() {
        for scale in [1.0 / (1_u64 << 60) as f32, 1.0, (1_u64 << 60) as f32] {
            let at = |x: f32, y: f32, z: f32| Vec3::new(x, y, z) * scale;
            assert!(is_on_a_line([at(1.0, 2.0, 3.0), at(2.0, 4.0, 6.0), at(-4.0, -8.0, -12.0)]));
            assert!(is_on_a_line([at(1.0, 2.0, 3.0), at(1.0, 2.0, 3.0), at(5.0, 5.0, 5.0)]));
            assert!(!is_on_a_line([at(1.0, 2.0, 3.0), at(2.0, 4.0, 6.0), at(-4.0, -8.0, -12.000_01)]));
            assert!(!is_on_a_line([at(1.0, 0.0, 3.0), at(1.0, 0.0, 6.0), at(1.0, 1e-6, 4.0)]));
        }
    }
}
