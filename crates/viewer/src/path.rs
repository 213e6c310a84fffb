//! [`Path`]: the camera path of a scene, played, stepped and scrubbed.

use crate::view::View;
use silhouette_compare::Profile;
use silhouette_compare::camera_path::Orbit;
use silhouette_compare::scene::{PathSpec, Scene};
use silhouette_core::Camera;
use silhouette_core::view::ViewError;
use std::time::{Duration, Instant};

/// At most this often a frame of a path is followed by the next.
pub const FRAME_TIME: Duration = Duration::from_millis(33);

/// The camera path of a scene.
#[derive(Debug, Clone)]
pub struct Path {
    /// Name of the scene.
    pub name: String,
    /// The path.
    pub spec: PathSpec,
    frame: u32,
    /// When the frame on screen was shown, while frames follow each other by themselves.
    playing_since: Option<Instant>,
    /// The view of the frame shown last.
    shown: Option<Camera>,
}

impl Path {
    /// The path of a scene, at its first frame.
    pub fn of(scene: &Scene) -> Self {
        Self { name: scene.name.clone(), spec: scene.path, frame: 0, playing_since: None, shown: None }
    }

    /// How many frames there are, warm-up frames too.
    pub fn frames(&self) -> u32 {
        self.spec.warm_up.saturating_add(self.spec.frames)
    }

    /// The frame on screen, counted from 0.
    pub fn frame(&self) -> u32 {
        self.frame
    }

    /// Whether frames follow each other by themselves.
    pub fn is_playing(&self) -> bool {
        self.playing_since.is_some()
    }

    /// Begins or ends that.
    pub fn play(&mut self, is_wanted: bool) {
        self.playing_since = is_wanted.then(Instant::now);
    }

    /// Shows a frame; after the last comes the first.
    ///
    /// # Errors
    /// [`ViewError`]: it makes no camera of this mesh.
    pub fn go_to(&mut self, frame: i64, view: &mut View) -> Result<(), ViewError> {
        self.frame = frame.rem_euclid(i64::from(self.frames().max(1))) as u32;
        let orbit = self.spec.orbit(view.camera().size());
        // The one frame, computed as it is among all of them.
        let first_azimuth_rad = orbit.first_azimuth_rad + orbit.step_rad * f64::from(self.frame);
        let camera = Orbit { views: 1, first_azimuth_rad, ..orbit }.cameras(view.bounds())?;
        camera.into_iter().for_each(|camera| view.show(camera, self.spec.fov_deg, self.spec.up_axis));
        self.shown = Some(view.camera());
        Ok(())
    }

    /// Whether a view is that of the frame shown last.
    pub fn is_on(&self, view: &View) -> bool {
        self.shown == Some(view.camera())
    }

    /// Shows the next frame once it is due and the one on screen `is_drawn`. How long until one is due, while they are played.
    ///
    /// # Errors
    /// As [`go_to`](Self::go_to).
    pub fn advance(&mut self, view: &mut View, is_drawn: bool) -> Result<Option<Duration>, ViewError> {
        let Some(since) = self.playing_since else { return Ok(None) };
        let elapsed = since.elapsed();
        if !is_drawn || elapsed < FRAME_TIME {
            return Ok(Some(FRAME_TIME.saturating_sub(elapsed)));
        }
        self.playing_since = Some(Instant::now());
        self.go_to(i64::from(self.frame) + 1, view)?;
        Ok(Some(FRAME_TIME))
    }
}

impl Default for Path {
    /// That of the profile that `compare` takes where none is named.
    fn default() -> Self {
        Self::of(&Profile::Quick.scene())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::shapes;
    use silhouettes::application::CameraArguments;

    /// Every frame is the camera that a comparison draws it with.
    #[test]
    fn frames_are_those_of_a_comparison() {
        let mesh = shapes::by_name("gear").unwrap();
        let arguments = CameraArguments::of_words([]).unwrap();
        for profile in [Profile::Quick, Profile::Full] {
            let scene = profile.scene();
            let bounds = mesh.bounds().unwrap();
            let mut view = View::new(&arguments, bounds, mesh.origin(), scene.picture.size()).unwrap();
            let compared = scene.path.orbit(scene.picture.size()).cameras(&bounds).unwrap();
            let mut path = Path::of(&scene);
            assert_eq!(path.frames() as usize, compared.len());
            for (frame, camera) in compared.iter().enumerate() {
                path.go_to(frame as i64, &mut view).unwrap();
                assert_eq!((path.frame() as usize, &view.camera()), (frame, camera));
            }
            path.go_to(-1, &mut view).unwrap();
            assert_eq!(view.camera(), compared[compared.len() - 1], "before the first comes the last");
        }
    }

    #[test]
    fn frames_are_played_once_they_are_due_and_drawn() {
        let mesh = shapes::by_name("cube").unwrap();
        let arguments = CameraArguments::of_words([]).unwrap();
        let mut view = View::new(&arguments, mesh.bounds().unwrap(), mesh.origin(), [64, 64]).unwrap();
        let mut path = Path::default();
        assert_eq!(path.advance(&mut view, true).unwrap(), None);
        path.play(true);
        std::thread::sleep(FRAME_TIME);
        assert!(path.advance(&mut view, false).unwrap().is_some() && path.frame() == 0, "it waits for the picture");
        path.advance(&mut view, true).unwrap();
        assert_eq!(path.frame(), 1);
        path.advance(&mut view, true).unwrap();
        assert_eq!(path.frame(), 1, "the next is not due");
    }
}
