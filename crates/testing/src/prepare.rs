//! From a mesh to what a test needs of it, in one call.

use silhouette_core::prepared::Artefact;
use silhouette_core::{Method, NoProgress, PreparedMesh, TriangleMesh};
use std::sync::Arc;

/// A mesh of which nothing is prepared yet.
pub fn prepared(mesh: TriangleMesh) -> Arc<PreparedMesh> {
    Arc::new(PreparedMesh::new(mesh))
}

/// An artefact of a mesh, built if nothing has asked for it before.
pub fn artefact<A: Artefact>(mesh: &PreparedMesh) -> Arc<A> {
    mesh.artefact("test", &NoProgress).unwrap()
}

/// A method with its default options.
pub fn method<M: Method>(mesh: &Arc<PreparedMesh>) -> M {
    M::new(mesh, M::Options::default()).unwrap()
}
