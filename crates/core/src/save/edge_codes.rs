//! When a viewer draws each side of each triangle, and by which normals it decides that for silhouettes.

use crate::edge_visibility::EdgeCode;
use crate::face_normal::face_normal;
use crate::id::{EdgeId, FaceId, HalfEdgeId, PerEdge, PerHalfEdge};
use crate::mesh::TriangleMesh;
use crate::orientation::orientation;
use crate::topology::Topology;
use glam::DVec3;

/// What stands for a component of 1. 16 bits, since both normals of an edge would often be equal in 8 bits where faces bend by
/// less than half a degree, so that finer meshes would have no silhouette.
const ONE: f64 = i16::MAX as f64;

/// A code for each half-edge, and two normals for each that is a silhouette, in the same order.
pub(super) struct EdgeCodes {
    pub(super) codes: PerHalfEdge<EdgeCode>,
    pub(super) normals: Vec<[i16; 3]>,
}

impl EdgeCodes {
    /// Of a hard edge the first half-edge is hard and all others repeat it. Of another edge that can be a silhouette the first
    /// half-edge is one. A side from a vertex to itself is hidden. O(F).
    pub(super) fn new(mesh: &TriangleMesh, topology: &Topology, is_hard: &PerEdge<bool>) -> Self {
        let mut normals = Vec::new();
        let code = |half_edge: HalfEdgeId| {
            let edge = topology.edge_of(half_edge);
            let [from, to] = topology.end_points(edge);
            let is_first = topology.half_edges(edge).first() == Some(&half_edge);
            match (from != to && is_hard[edge], is_first) {
                (true, true) => EdgeCode::Hard,
                (true, false) => EdgeCode::RepeatedHard,
                (false, false) => EdgeCode::Hidden,
                (false, true) => match silhouette_normals(mesh, topology, edge) {
                    Some(pair) => {
                        normals.extend(pair);
                        EdgeCode::Silhouette
                    }
                    None => EdgeCode::Hidden,
                },
            }
        };
        let codes: Vec<_> = (0..topology.half_edge_count()).map(HalfEdgeId::from_usize).map(code).collect();
        Self { codes: codes.into(), normals }
    }

    /// Whether any viewer draws any edge.
    pub(super) fn draw_anything(&self) -> bool {
        self.codes.as_slice().iter().any(|&code| code != EdgeCode::Hidden)
    }
}

/// The normals of the two faces of an edge that can be a silhouette, of its first half-edge's face first.
///
/// `None` where no viewpoint sees one face and not the other: the faces go on in one plane. `None`, too, where no viewer could
/// tell: the edge does not join two consistently wound faces that have an area, or their normals are equal as they are
/// stored.
fn silhouette_normals(mesh: &TriangleMesh, topology: &Topology, edge: EdgeId) -> Option<[[i16; 3]; 2]> {
    let faces = topology.consistent_pair(mesh, edge)?;
    let [Some(one), Some(other)] = faces.map(|face| face_normal(mesh.corners(face))) else { return None };
    if one.dot(other) > 0.0 && lie_in_one_plane(mesh, faces) {
        return None;
    }
    let stored = [one, other].map(|normal: DVec3| (normal * ONE).round().to_array().map(|component| component as i16));
    (stored[0] != stored[1]).then_some(stored)
}

/// Whether all corners of two faces lie in one plane, exactly.
fn lie_in_one_plane(mesh: &TriangleMesh, [one, other]: [FaceId; 2]) -> bool {
    let [a, b, c] = mesh.corners(one);
    mesh.corners(other).into_iter().all(|corner| orientation(a, b, c, corner) == 0.0)
}
