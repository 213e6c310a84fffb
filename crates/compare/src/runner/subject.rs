//! [`Subject`]: a mesh to compare on.

use silhouette_core::{PreparedMesh, TriangleMesh};
use std::sync::Arc;

/// A mesh with its name.
#[derive(Debug, Clone)]
pub struct NamedMesh {
    /// Name in results and report, usually the path.
    pub name: String,
    /// The mesh.
    pub mesh: Arc<PreparedMesh>,
}

/// A mesh to compare on, and what it stands for.
#[derive(Debug, Clone)]
pub struct Subject {
    /// What is drawn.
    pub mesh: NamedMesh,
    /// What filled pictures are measured against, in the same coordinates; `None`: the mesh itself.
    pub truth: Option<Arc<TriangleMesh>>,
}

impl From<NamedMesh> for Subject {
    fn from(mesh: NamedMesh) -> Self {
        Self { mesh, truth: None }
    }
}
