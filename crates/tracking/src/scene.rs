//! What is tracked: a mesh, or its topology with this frame's positions.

use crate::concave_edges::{ConcaveEdges, TrackedEdges};
use crate::connectivity_table::ConnectivityTable;
use crate::faces::Surface;
use silhouette_core::glam::Vec3;
use silhouette_core::method::PositionsError;
use silhouette_core::{TriangleMesh, VertexId};
use std::sync::Arc;

/// A mesh with what tracking prepares of it.
#[derive(Debug, Clone)]
pub(crate) struct Scene {
    mesh: Arc<TriangleMesh>,
    edges: Arc<TrackedEdges>,
    table: Arc<ConnectivityTable>,
    moved: Option<Box<Moved>>,
}

/// This frame's positions and what depends on them.
#[derive(Debug, Clone)]
struct Moved {
    positions: Vec<Vec3>,
    table: ConnectivityTable,
    concave: ConcaveEdges,
}

impl Scene {
    /// # Panics
    /// If the table is of another mesh.
    pub fn new(mesh: Arc<TriangleMesh>, table: Arc<ConnectivityTable>, edges: Arc<TrackedEdges>) -> Self {
        assert_eq!(table.face_count(), mesh.face_count(), "table of another mesh");
        Self { mesh, table, edges, moved: None }
    }

    pub fn surface(&self) -> Surface<'_> {
        let (positions, table) = match &self.moved {
            Some(moved) => (moved.positions.as_slice(), &moved.table),
            None => (self.mesh.positions(), &*self.table),
        };
        Surface { positions, triangles: self.mesh.triangles(), table }
    }

    pub fn table(&self) -> &ConnectivityTable {
        &self.table
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

    /// Makes `positions` those of the frames to come, and finds their concave edges if any are to be searched.
    pub fn update_positions(&mut self, positions: &[Vec3], searches: bool) -> Result<(), PositionsError> {
        let vertices = self.mesh.vertex_count();
        if positions.len() != vertices {
            return Err(PositionsError::Count { given: positions.len(), vertices });
        }
        if let Some(vertex) = positions.iter().position(|position| !position.is_finite()) {
            return Err(PositionsError::NotFinite { vertex: VertexId::from_usize(vertex) });
        }
        let moved = self.moved.get_or_insert_with(|| {
            let mut concave = ConcaveEdges::default();
            concave.reserve(if searches { self.table.topology().edge_count() } else { 0 });
            Box::new(Moved { positions: Vec::new(), table: (*self.table).clone(), concave })
        });
        moved.positions.clear();
        moved.positions.extend_from_slice(positions);
        moved.table.place(positions, self.mesh.triangles());
        if searches {
            moved.concave.find(positions, self.mesh.triangles(), &moved.table);
        }
        Ok(())
    }

    /// Bytes held beyond the mesh and its artefacts.
    pub fn bytes(&self) -> usize {
        self.moved.as_ref().map_or(0, |moved| {
            size_of_val(moved.positions.as_slice()) + 32 * self.mesh.face_count() + moved.concave.bytes()
        })
    }
}
