//! [`Motion`]: what moves from frame to frame. Everything is the same for every method and every run.

use crate::camera_path::Orbit;
use serde::{Deserialize, Serialize};
use silhouette_core::Camera;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Projection, ViewError};
use std::f64::consts::TAU;

/// By how much a dolly shortens the way to the target from frame to frame.
pub const DOLLY_STEP: f64 = 0.01;

/// How far a jittering camera is turned about its target at most, in degrees.
pub const JITTER_DEG: f64 = 0.01;

/// Height of the wave that runs through a moving mesh, in radii of its bounding sphere.
pub const WAVE_HEIGHT: f64 = 0.02;

/// Length of the wave in radii.
pub const WAVE_LENGTH: f64 = 1.0;

/// Frames in which the wave runs on by its length.
pub const WAVE_FRAMES: f64 = 60.0;

/// What moves from frame to frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Motion {
    /// The camera follows the scene's path.
    Orbit,
    /// The camera approaches: in each frame it is 1 % nearer to the target than in the last, or sees 1 % less from top to bottom.
    Dolly,
    /// The camera is turned about its target by up to 0.01 degree to and fro: as good as at rest.
    Jitter,
    /// The camera rests, and a wave runs through the mesh.
    Wave,
}

impl Motion {
    /// All of them; the mesh moves last, as methods may not find back from that.
    pub const ALL: [Self; 4] = [Self::Orbit, Self::Dolly, Self::Jitter, Self::Wave];

    /// Name in scenes and results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Orbit => "orbit",
            Self::Dolly => "dolly",
            Self::Jitter => "jitter",
            Self::Wave => "wave",
        }
    }

    /// Whether the mesh moves and not the camera.
    pub fn moves_mesh(self) -> bool {
        self == Self::Wave
    }

    /// The cameras of `frames` frames. The first is that of the path's first view. O(frames).
    ///
    /// # Errors
    /// [`ViewError`] where field of view or viewport do not make a camera.
    pub fn cameras(self, orbit: &Orbit, bounds: &Bounds, frames: u32) -> Result<Vec<Camera>, ViewError> {
        let path = Orbit { views: if self == Self::Orbit { frames } else { 1 }, ..*orbit }.cameras(bounds)?;
        let first = path.first().copied();
        let of_frame = |frame: u32| match (self, first) {
            (Self::Orbit, _) | (_, None) => Ok(path[frame as usize]),
            (Self::Dolly, Some(first)) => nearer(&first, (1.0 - DOLLY_STEP).powi(frame as i32)),
            (Self::Jitter, Some(first)) => turned(&first, frame),
            (Self::Wave, Some(first)) => Ok(first),
        };
        (0..frames).map(of_frame).collect()
    }

    /// Where the vertices of a mesh within `bounds` are in a frame; `None` where they rest. O(V).
    pub fn positions(self, rest: &[Vec3], bounds: &Bounds, frame: u32) -> Option<Vec<Vec3>> {
        let radius = bounds.radius;
        let moved = |position: &Vec3| {
            let at = position.as_dvec3();
            let phase = (at - bounds.center).dot(DVec3::new(0.48, 0.64, 0.6)) / (WAVE_LENGTH * radius);
            let height = WAVE_HEIGHT * radius * (TAU * (phase - f64::from(frame) / WAVE_FRAMES)).sin();
            // Across the direction in which it runs.
            let most = DVec3::splat(f32::MAX.into());
            (at + height * DVec3::new(0.8, -0.6, 0.0)).clamp(-most, most).as_vec3()
        };
        self.moves_mesh().then(|| rest.iter().map(moved).collect())
    }
}

fn nearer(camera: &Camera, share: f64) -> Result<Camera, ViewError> {
    let (eye, target) = (camera.eye().as_dvec3(), camera.target().as_dvec3());
    let (eye, projection) = match camera.projection() {
        Projection::Perspective { .. } => (target + (eye - target) * share, camera.projection()),
        Projection::Orthographic { height } => (eye, Projection::Orthographic { height: height * share }),
    };
    Camera::new(eye.as_vec3(), camera.target(), camera.up(), projection, camera.size())
}

/// The camera turned about its target in two directions, by angles that no two frames share and that have no period.
fn turned(camera: &Camera, frame: u32) -> Result<Camera, ViewError> {
    let (eye, target) = (camera.eye().as_dvec3(), camera.target().as_dvec3());
    let back = eye - target;
    let right = camera.up().as_dvec3().cross(back).normalize_or_zero();
    let up = back.cross(right).normalize_or_zero();
    // Additive sequences of the plastic number: evenly spread over the square, whatever their length.
    let spread = |factor: f64| 2.0 * (f64::from(frame) * factor).fract() - 1.0;
    let angle = JITTER_DEG.to_radians() / std::f64::consts::SQRT_2;
    let aside = right * spread(0.754_877_666_246_693) + up * spread(0.569_840_290_998_053);
    let eye = target + (back.normalize_or_zero() + aside * angle).normalize_or_zero() * back.length();
    Camera::new(eye.as_vec3(), camera.target(), camera.up(), camera.projection(), camera.size())
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::view::Framing;

    const BOUNDS: Bounds = Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE, center: DVec3::ZERO, radius: 1.8 };

    fn cameras(motion: Motion, framing: Framing) -> Vec<Camera> {
        let orbit = Orbit { step_rad: 0.02, ..Orbit::turn(framing, [64, 64], 1) };
        motion.cameras(&orbit, &BOUNDS, 12).unwrap()
    }

    #[test]
    fn all_begin_with_the_first_view_of_the_path() {
        for framing in [Framing::Perspective { fov_y_rad: 0.8 }, Framing::Orthographic] {
            let first = cameras(Motion::Orbit, framing)[0];
            for motion in Motion::ALL {
                let all = cameras(motion, framing);
                let off = all[0].eye().distance(first.eye()) / first.eye().length();
                assert!(all.len() == 12 && off < 2e-4, "{motion:?}: {off}");
            }
        }
    }

    #[test]
    fn a_dolly_approaches_and_a_jitter_hardly_turns() {
        for framing in [Framing::Perspective { fov_y_rad: 0.8 }, Framing::Orthographic] {
            let dolly = cameras(Motion::Dolly, framing);
            let scale = |camera: &Camera| camera.pixels_per_unit(camera.eye().distance(camera.target()).into());
            for pair in dolly.windows(2) {
                assert!((scale(&pair[1]) / scale(&pair[0]) - 1.0 / 0.99).abs() < 1e-5);
            }
            let jitter = cameras(Motion::Jitter, framing);
            let first = cameras(Motion::Orbit, framing)[0].eye().as_dvec3();
            let angles: Vec<f64> =
                jitter.iter().map(|camera| camera.eye().as_dvec3().angle_between(first).to_degrees()).collect();
            assert!(angles.iter().all(|&angle| angle < JITTER_DEG * 1.05), "{angles:?}");
            assert!(angles.iter().filter(|&&angle| angle > JITTER_DEG * 0.2).count() > 6, "{angles:?}");
            assert!(jitter.windows(2).all(|pair| pair[0].eye() != pair[1].eye()));
        }
    }

    #[test]
    fn a_wave_moves_vertices_and_nothing_else_does() {
        let rest = [Vec3::new(0.3, -0.2, 0.5), Vec3::ZERO];
        for motion in Motion::ALL {
            assert_eq!(motion.positions(&rest, &BOUNDS, 3).is_some(), motion.moves_mesh());
        }
        let moved = |frame| Motion::Wave.positions(&rest, &BOUNDS, frame).unwrap();
        let reach = moved(7).iter().zip(&rest).map(|(at, rest)| at.distance(*rest)).fold(0.0, f32::max);
        assert!(reach > 0.0 && f64::from(reach) <= WAVE_HEIGHT * BOUNDS.radius * 1.000_01, "{reach}");
        assert!(moved(0)[0].distance(moved(WAVE_FRAMES as u32)[0]) < 1e-6, "it repeats");
        assert_ne!(moved(0), moved(1));
    }
}
