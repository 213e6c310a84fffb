//! [`Hull`]: the coarse mesh around the object, which is drawn in its place.

use silhouette_core::TriangleMesh;
use std::sync::Arc;

/// A coarse mesh around the object, wound counter-clockwise seen from outside.
#[derive(Debug, Clone)]
pub struct Hull {
    mesh: Arc<TriangleMesh>,
}

impl Hull {
    /// A mesh that the caller vouches for: nothing is checked. Where it does not enclose the object, outlines have holes.
    pub fn trusted(mesh: impl Into<Arc<TriangleMesh>>) -> Self {
        Self { mesh: mesh.into() }
    }

    /// Its triangles, in the object's own space.
    pub fn mesh(&self) -> &Arc<TriangleMesh> {
        &self.mesh
    }
}
