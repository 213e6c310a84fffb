//! [`visible_lines`]: the lines of one view of one mesh, in one call.

use crate::finder::LineFinder;
use crate::line_error::LineError;
use crate::lines::Lines;
use crate::options::LineOptions;
use crate::scene::LineScene;
use silhouette_core::{Camera, NoProgress, PreparedMesh, TriangleMesh};
use std::sync::Arc;

/// The visible silhouette and boundary edges of a mesh as the camera sees it.
///
/// For one view: it copies the mesh, prepares it, O(F log F), and forgets it. For several views or meshes, creases, hidden lines or
/// the outline keep a [`LineFinder`].
///
/// # Errors
/// [`LineError`] where the view is too crowded.
pub fn visible_lines(mesh: &TriangleMesh, camera: &Camera) -> Result<Lines, LineError> {
    let scene = LineScene::new(Arc::new(PreparedMesh::new(mesh.clone())));
    LineFinder::new(scene, &NoProgress)?.find(camera, &LineOptions::default(), &NoProgress)
}
