//! [`ShadingMesh`]: a mesh with its feature edges and shading normals, as all methods of this crate take it.

use crate::shading_normals::{Groups, NormalWeights, shading_normals};
use crate::view_mesh::Origin;
use silhouette_core::feature_edges::feature_edges;
use silhouette_core::glam::Vec3;
use silhouette_core::id::{HalfEdgeId, PerEdge};
use silhouette_core::inside_out::inside_out_faces_with_progress;
use silhouette_core::{Cancelled, FaceId, PreparedMesh, Progress, Topology, TriangleMesh};
use std::ops::Range;
use std::sync::Arc;

/// A mesh whose vertices have been split where feature edges give them several normals: *shading vertices*, one for each vertex
/// and group. Without feature edges they are the vertices, in the same order.
#[derive(Debug, Clone)]
pub struct ShadingMesh {
    mesh: Arc<TriangleMesh>,
    topology: Arc<Topology>,
    features: PerEdge<bool>,
    groups: Groups,
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    origins: Vec<Origin>,
    has_feature: Vec<bool>,
    feature_faces: Vec<FaceId>,
    is_closed: bool,
    is_turned: Vec<bool>,
    /// Shading vertices of vertex v: `first[v]..first[v + 1]`.
    first: Vec<u32>,
}

impl ShadingMesh {
    /// Finds feature edges, those that the mesh was given among them, and shading normals. O(F).
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn new(
        mesh: &PreparedMesh,
        crease_deg: f64,
        weights: NormalWeights,
        asker: &'static str,
        progress: &dyn Progress,
    ) -> Result<Self, Cancelled> {
        let topology = mesh.artefact::<Topology>(asker, progress)?;
        let given = mesh.feature_edges();
        let features = feature_edges(mesh.mesh(), &topology, given, crease_deg);
        let mesh = Arc::clone(mesh.mesh());
        progress.check()?;
        let is_turned = inside_out_faces_with_progress(&mesh, &topology, progress)?;
        progress.check()?;
        let groups = Groups::new(&mesh, &topology, &features, progress)?;
        progress.check()?;
        let normals = shading_normals(&mesh, &groups, weights, &is_turned);
        progress.check()?;
        let mut origins = vec![Origin { face: FaceId::new(0), weights: [0.0; 3] }; groups.vertex.len()];
        for (face, corners) in groups.of_corner.iter().enumerate().rev() {
            for (slot, &corner) in corners.iter().enumerate() {
                origins[corner as usize] =
                    Origin { face: FaceId::from_usize(face), weights: Vec3::AXES[slot].to_array() };
            }
        }
        progress.check()?;
        let feature_on = |face: usize, slot: u32| {
            let half_edge = HalfEdgeId::of(FaceId::from_usize(face), slot);
            features[topology.edge_of(half_edge)]
        };
        let has_feature: Vec<bool> =
            (0..mesh.face_count()).map(|face| (0..3).any(|slot| feature_on(face, slot))).collect();
        let feature_faces = (0..mesh.face_count()).filter(|&face| has_feature[face]).map(FaceId::from_usize).collect();
        let is_closed = topology.edges().iter().all(|(edge, _)| topology.consistent_pair(&mesh, edge).is_some());
        let mut first = vec![0; mesh.vertex_count() + 1];
        groups.vertex.iter().for_each(|&vertex| first[vertex as usize + 1] += 1);
        (0..mesh.vertex_count()).for_each(|vertex| first[vertex + 1] += first[vertex]);
        let positions = groups.vertex.iter().map(|&vertex| mesh.positions()[vertex as usize]).collect();
        Ok(Self {
            mesh,
            topology,
            features,
            groups,
            positions,
            normals,
            origins,
            has_feature,
            feature_faces,
            is_closed,
            is_turned,
            first,
        })
    }

    /// The mesh itself.
    pub fn mesh(&self) -> &Arc<TriangleMesh> {
        &self.mesh
    }

    /// Its edges.
    pub fn topology(&self) -> &Arc<Topology> {
        &self.topology
    }

    /// Whether each edge is a feature edge.
    pub fn features(&self) -> &PerEdge<bool> {
        &self.features
    }

    /// The shading vertices of each face.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.groups.of_corner
    }

    /// Position of each shading vertex.
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// Unit normal of each shading vertex; 0 where no face with an area meets it.
    pub fn normals(&self) -> &[Vec3] {
        &self.normals
    }

    /// The vertex that each shading vertex belongs to, ascending.
    pub fn vertices(&self) -> &[u32] {
        &self.groups.vertex
    }

    /// Where each shading vertex lies: at a corner of its first face; without weights for a vertex of no face.
    pub fn origins(&self) -> &[Origin] {
        &self.origins
    }

    /// Whether a side of a face is a feature edge.
    pub fn has_feature(&self, face: FaceId) -> bool {
        self.has_feature[face.index()]
    }

    /// The faces of which a side is a feature edge, ascending.
    pub fn feature_faces(&self) -> &[FaceId] {
        &self.feature_faces
    }

    /// Whether every edge joins two faces that are wound consistently.
    pub fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// Whether each face is wound inside out, so that shading normals take it as turned.
    pub fn is_turned(&self) -> &[bool] {
        &self.is_turned
    }

    /// The shading vertices of a vertex.
    ///
    /// # Panics
    /// If the mesh has no such vertex.
    pub fn shading_vertices(&self, vertex: u32) -> Range<usize> {
        self.first[vertex as usize] as usize..self.first[vertex as usize + 1] as usize
    }

    /// Bytes held beside the mesh and its topology.
    pub fn bytes(&self) -> usize {
        size_of_val(self.features.as_slice())
            + size_of_val(self.groups.of_corner.as_slice())
            + size_of_val(self.groups.vertex.as_slice())
            + size_of_val(self.positions.as_slice())
            + size_of_val(self.normals.as_slice())
            + size_of_val(self.origins.as_slice())
            + self.has_feature.len()
            + size_of_val(self.feature_faces.as_slice())
            + self.is_turned.len()
            + size_of_val(self.first.as_slice())
    }
}
