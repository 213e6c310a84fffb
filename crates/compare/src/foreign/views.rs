//! [`ScoredView`]: a frame that is scored.

use crate::scene::Scene;
use silhouette_core::Camera;
use silhouette_core::mesh::Bounds;
use silhouette_core::view::ViewError;

/// A frame that is scored.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScoredView {
    /// Which of the timed frames, from 0: the same number as in the results of a comparison.
    pub frame: u32,
    /// Its camera.
    pub camera: Camera,
}

impl ScoredView {
    /// The scored frames of a scene on a mesh with these bounds, ascending. O(frames).
    ///
    /// # Errors
    /// [`ViewError`] where the mesh is too large to be framed.
    pub fn of_scene(scene: &Scene, bounds: &Bounds) -> Result<Vec<Self>, ViewError> {
        let cameras = scene.path.orbit(scene.picture.size()).cameras(bounds)?;
        let first = scene.path.warm_up as usize;
        let view = |frame: u32| Self { frame, camera: cameras[first + frame as usize] };
        Ok(scene.path.scored_frames().into_iter().map(view).collect())
    }
}
