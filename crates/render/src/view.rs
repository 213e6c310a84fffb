//! [`view_of_mesh`]: the view of a camera that holds all of a mesh.

use crate::target::DEFAULT_FORMATS;
use silhouette_core::mesh::Bounds;
use silhouette_core::view::Camera;
use silhouette_gpu::{FrameView, FrameViewError, MeshBuffers};

/// What `camera` shows of `mesh`, with depths tight around it, for [`DEFAULT_FORMATS`]. Without triangles, depths about the
/// camera's target are shown.
///
/// # Errors
/// [`FrameViewError::Depths`] where the mesh is so small or so far that near and far plane are one.
pub fn view_of_mesh(camera: &Camera, mesh: &MeshBuffers) -> Result<FrameView, FrameViewError> {
    let (eye, target) = (camera.eye().as_dvec3(), camera.target().as_dvec3());
    let about_target = Bounds { min: target, max: target, center: target, radius: 0.5 * eye.distance(target) };
    let range = camera.clip_range(&mesh.bounds().unwrap_or(about_target));
    FrameView::from_camera(camera, range, DEFAULT_FORMATS.depth_direction)
}
