//! Cameras and drawings that several tests look at.

use silhouette_core::glam::DVec3;
use silhouette_core::view::Framing;
use silhouette_core::{Camera, NoProgress, PreparedMesh, TriangleMesh};
use silhouette_testing::prepare::prepared;
use silhouette_testing::views::{PERSPECTIVE, framed};
use silhouette_visibility::{LineFinder, LineOptions, LineScene, Lines};
use std::sync::Arc;

/// A camera of 1024 x 1024 pixels that shows all of a mesh from a direction.
pub fn framing(mesh: &TriangleMesh, direction: DVec3, perspective: bool) -> Camera {
    framed(mesh, direction, if perspective { PERSPECTIVE } else { Framing::Orthographic }, [1024; 2])
}

/// A finder for a scene of one mesh, with no line found yet.
pub fn finder(mesh: TriangleMesh) -> LineFinder {
    finder_of(&prepared(mesh))
}

/// The same for a mesh of which something may be prepared already.
pub fn finder_of(mesh: &Arc<PreparedMesh>) -> LineFinder {
    LineFinder::new(LineScene::new(Arc::clone(mesh)), &NoProgress).unwrap()
}

/// The lines of one view, hidden ones included.
pub fn all_lines(mesh: &TriangleMesh, camera: &Camera, options: &LineOptions) -> Lines {
    let options = LineOptions { max_invisibility: u32::MAX, ..options.clone() };
    finder(mesh.clone()).find(camera, &options, &NoProgress).unwrap()
}
