//! What is tracked: a mesh, or its topology with this frame's positions.

use crate::concave_edges::{ConcaveEdges, TrackedEdges};
use crate::faces::Surface;
use crate::facing_planes::FacingPlanes;
use silhouette_core::glam::Vec3;
use silhouette_core::method::PositionsError;
use silhouette_core::{TriangleMesh, VertexId};
use std::sync::Arc;

/// A mesh with what tracking prepares of it.
#[derive(Debug, Clone)]
pub(crate) struct Scene {
    mesh: Arc<TriangleMesh>,
    edges: Arc<TrackedEdges>,
    planes: Arc<FacingPlanes>,
    moved: Option<Box<Moved>>,
}

/// This frame's positions and what depends on them.
#[derive(Debug, Clone, Default)]
struct Moved {
    positions: Vec<Vec3>,
    planes: FacingPlanes,
    concave: ConcaveEdges,
}

impl Scene {
    pub fn new(mesh: Arc<TriangleMesh>, edges: Arc<TrackedEdges>, planes: Arc<FacingPlanes>) -> Self {
        Self { mesh, edges, planes, moved: None }
    }

    pub fn surface(&self) -> Surface<'_> {
        let (positions, planes) = match &self.moved {
            Some(moved) => (moved.positions.as_slice(), &moved.planes),
            None => (self.mesh.positions(), &*self.planes),
        };
        Surface { topology: self.edges.topology(), positions, triangles: self.mesh.triangles(), planes }
    }

    pub fn edges(&self) -> &TrackedEdges {
        &self.edges
    }

    pub fn concave(&self) -> &ConcaveEdges {
        self.moved.as_ref().map_or(self.edges.concave_edges(), |moved| &moved.concave)
    }

    pub fn face_count(&self) -> usize {
        self.mesh.face_count()
    }

    /// Makes `positions` those of the frames to come.
    pub fn update_positions(&mut self, positions: &[Vec3]) -> Result<(), PositionsError> {
        let vertices = self.mesh.vertex_count();
        if positions.len() != vertices {
            return Err(PositionsError::Count { given: positions.len(), vertices });
        }
        if let Some(vertex) = positions.iter().position(|position| !position.is_finite()) {
            return Err(PositionsError::NotFinite { vertex: VertexId::from_usize(vertex) });
        }
        let topology = self.edges.topology();
        let moved = self.moved.get_or_insert_with(|| {
            let mut moved = Box::<Moved>::default();
            moved.concave.reserve(topology.edge_count());
            moved
        });
        moved.positions.clear();
        moved.positions.extend_from_slice(positions);
        moved.planes.compute(positions, self.mesh.triangles());
        moved.concave.find(positions, self.mesh.triangles(), topology, &moved.planes);
        Ok(())
    }

    /// Bytes held beyond the mesh and its artefacts.
    pub fn bytes(&self) -> usize {
        self.moved.as_ref().map_or(0, |moved| {
            size_of_val(moved.positions.as_slice()) + 16 * self.mesh.face_count() + moved.concave.bytes()
        })
    }
}
