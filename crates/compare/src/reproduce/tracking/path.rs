//! The path of the eye: a level circle, a tenth of a degree a frame.
//!
//! The paper says that the position differs from frame to frame, and no more. Of what was tried, small steps from near and
//! below come closest to its counts: 0.1 degrees, two radii from the middle of the mesh, 40 degrees below the horizon.
//! Steps matter most: what is followed is proportional to them.

use glam::DVec3;
use silhouette_core::Viewpoint;
use silhouette_core::glam::Vec3;
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Camera, Projection, ViewError};

/// From frame to frame.
pub const STEP_DEG: f64 = 0.1;

/// Of the eye from the middle of the mesh, in radii of its bounding sphere.
pub const DISTANCE_RADII: f64 = 2.0;

/// Of the eye above the horizon.
pub const ELEVATION_DEG: f64 = -40.0;

/// Of the first frame.
const AZIMUTH_DEG: f64 = 24.0;

/// Steps of the lead-in, a whole turn.
const LEAD_IN_STEPS: u32 = 360;

/// Part of the picture that stays free around the bounding sphere.
const MARGIN: f64 = 0.05;

/// The path around a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Path {
    bounds: Bounds,
    frames: u32,
}

impl Path {
    /// A path of this many measured frames.
    pub fn new(bounds: Bounds, frames: u32) -> Self {
        Self { bounds, frames }
    }

    /// A whole turn in steps of a degree that ends where the frames begin. What is missed by then is what is missed after
    /// any long flight, and not what brute force has left for tracking to lose.
    pub fn lead_in(&self) -> impl Iterator<Item = Viewpoint> {
        (0..LEAD_IN_STEPS).map(|step| self.view(AZIMUTH_DEG - f64::from(LEAD_IN_STEPS - step)))
    }

    /// The measured frames.
    pub fn frames(&self) -> impl Iterator<Item = Viewpoint> {
        (0..self.frames).map(|frame| self.view(azimuth_deg(frame)))
    }

    /// The camera of a frame: sees the whole bounding sphere.
    ///
    /// # Errors
    /// [`ViewError`] where the mesh is so far from the origin that eye and target round to one point.
    pub fn camera(&self, frame: u32, size: [u32; 2]) -> Result<Camera, ViewError> {
        let fov_y_rad = 2.0 * ((1.0 + MARGIN) / DISTANCE_RADII).asin();
        let projection = Projection::Perspective { fov_y_rad };
        Camera::new(self.eye(azimuth_deg(frame)), self.bounds.center.as_vec3(), Vec3::Y, projection, size)
    }

    fn view(&self, azimuth_deg: f64) -> Viewpoint {
        Viewpoint::Perspective { eye: self.eye(azimuth_deg) }
    }

    fn eye(&self, azimuth_deg: f64) -> Vec3 {
        let (sin, cos) = azimuth_deg.to_radians().sin_cos();
        let (up, level) = ELEVATION_DEG.to_radians().sin_cos();
        let direction = DVec3::new(cos * level, up, sin * level);
        (self.bounds.center + direction * (DISTANCE_RADII * self.bounds.radius)).as_vec3()
    }
}

fn azimuth_deg(frame: u32) -> f64 {
    AZIMUTH_DEG + STEP_DEG * f64::from(frame)
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOUNDS: Bounds = Bounds { min: DVec3::ZERO, max: DVec3::splat(2.0), center: DVec3::ONE, radius: 1.5 };

    fn eye(view: Viewpoint) -> DVec3 {
        match view {
            Viewpoint::Perspective { eye } => eye.as_dvec3() - BOUNDS.center,
            Viewpoint::Orthographic { .. } => panic!("{view:?}"),
        }
    }

    #[test]
    fn frames_follow_each_other_and_the_lead_in() {
        let path = Path::new(BOUNDS, 50);
        let eyes: Vec<DVec3> = path.lead_in().chain(path.frames()).map(eye).collect();
        assert_eq!(eyes.len(), 360 + 50);
        let level = ELEVATION_DEG.to_radians().cos();
        for (index, pair) in eyes.windows(2).enumerate() {
            assert!((pair[0].length() - 3.0).abs() < 1e-5);
            let step_deg = if index < 360 { 1.0 } else { STEP_DEG };
            let angle_deg = (pair[0].distance(pair[1]) / 3.0).to_degrees();
            assert!((angle_deg / (step_deg * level) - 1.0).abs() < 1e-3, "{index}: {angle_deg}");
        }
    }

    #[test]
    fn cameras_stand_where_frames_are_seen_from_and_show_the_mesh() {
        let path = Path::new(BOUNDS, 9);
        for (frame, view) in path.frames().enumerate() {
            let camera = path.camera(frame as u32, [100, 100]).unwrap();
            assert_eq!(camera.viewpoint(), view);
            let side = camera.eye().as_dvec3().cross(DVec3::Y).normalize() * BOUNDS.radius;
            let seen = camera.project(BOUNDS.center + side).unwrap();
            assert!(seen.pixel.cmpgt(glam::DVec2::ZERO).all() && seen.pixel.cmplt(glam::DVec2::splat(100.0)).all());
        }
    }
}
