//! Step 3: the views. Each looks from a direction of its own, drawn uniformly and independently of all others.
//!
//! Evenly spread directions would estimate averages better, but a promise rests on [counting](super::promise) views that were drawn
//! independently. Numbers come from the view's own name, so that they are the same in every run.
//!
//! Some methods keep state from frame to frame, and lose silhouette edges while they do. So the view that is measured ends a *run-up*:
//! frames 2 degrees apart on a great circle, as many as the method asks for.

use crate::registry::Entry;
use crate::scene::Scene;
use glam::{DQuat, DVec3};
use serde::{Deserialize, Serialize};
use silhouette_core::Camera;
use silhouette_core::glam::Vec3;
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Framing, UpAxis, ViewError};
use std::f64::consts::TAU;

/// Angle from frame to frame of a run-up: that of the profile `quick`.
const STEP_RAD: f64 = TAU / 180.0;

/// Frames before the one that is measured, for methods that may miss edges: a sixth of a turn, in which what is lost at first
/// has come and gone.
const LOSSY_RUN_UP: u32 = 30;

/// What a view is measured for. Views of different purposes are different.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Purpose {
    /// Choosing among candidates.
    Choice,
    /// Backing the promise, after the choice.
    Promise,
    /// Checking the promise, after it was made.
    Check,
}

/// One of the views of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ViewId {
    /// What it is measured for.
    pub purpose: Purpose,
    /// Which of them, from 0.
    pub index: u32,
}

/// How views are seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setting {
    /// How each view projects.
    pub framing: Framing,
    /// Viewport in pixels.
    pub size: [u32; 2],
    /// Samples per pixel, 1 or 4.
    pub samples: u32,
    /// Width of the pen in pixels.
    pub pen_width_px: f64,
    /// The axis that points up.
    pub up_axis: UpAxis,
}

impl From<&Scene> for Setting {
    /// Framing, picture, pen and axis of a scene.
    fn from(scene: &Scene) -> Self {
        let Scene { path, picture, pen, .. } = scene;
        Self {
            framing: path.orbit(picture.size()).framing,
            size: picture.size(),
            samples: picture.samples,
            pen_width_px: pen.width_px,
            up_axis: path.up_axis,
        }
    }
}

/// Frames of the run-up that a method is measured after: none where it extracts no edges, as each of its frames stands for itself; one
/// where it is exact, so that its time is that of a frame among others; 30 elsewhere.
pub fn run_up(entry: &Entry) -> u32 {
    match (entry.capabilities().edges, entry.info().exact) {
        (false, _) => 0,
        (true, true) => 1,
        (true, false) => LOSSY_RUN_UP,
    }
}

impl ViewId {
    /// From the mesh towards the viewer: uniform on the sphere.
    pub fn direction(self) -> DVec3 {
        let [height, azimuth, _] = self.numbers();
        let height = 2.0 * height - 1.0;
        let (sin, cos) = (TAU * azimuth).sin_cos();
        let radius = (1.0 - height * height).max(0.0).sqrt();
        DVec3::new(radius * cos, height, radius * sin)
    }

    /// The cameras of the run-up and, last, of the view itself. O(run-up).
    ///
    /// # Errors
    /// [`ViewError`] where setting and bounds do not make a camera.
    pub fn cameras(self, run_up: u32, setting: &Setting, bounds: &Bounds) -> Result<Vec<Camera>, ViewError> {
        let direction = self.direction();
        let [_, _, turn] = self.numbers();
        let axis = DQuat::from_axis_angle(direction, TAU * turn) * direction.any_orthonormal_vector();
        let camera = |before: u32| {
            let turned = DQuat::from_axis_angle(axis, STEP_RAD * f64::from(before)) * direction;
            Camera::framing(bounds, turned, up(turned, setting.up_axis), setting.framing, setting.size)
        };
        (0..=run_up).rev().map(camera).collect()
    }

    /// Three numbers from 0 to below 1.
    fn numbers(self) -> [f64; 3] {
        let stream = match self.purpose {
            Purpose::Choice => 1,
            Purpose::Promise => 2,
            Purpose::Check => 3_u64,
        };
        let first = (stream << 40) + 3 * u64::from(self.index);
        [0, 1, 2].map(|at| (mixed(first + at) >> 11) as f64 / (1_u64 << 53) as f64)
    }
}

/// The direction to the top of a view: that of the axis, or where the view looks along it any other.
fn up(direction: DVec3, axis: UpAxis) -> Vec3 {
    let up = axis.from_y_up(DVec3::Y);
    let up = if direction.cross(up).length_squared() < 1e-12 { axis.from_y_up(DVec3::Z) } else { up };
    up.as_vec3()
}

/// The number of this place in a sequence that looks random, `SplitMix64` (Steele, Lea and Flood, OOPSLA 2014).
fn mixed(place: u64) -> u64 {
    let number = place.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let number = (number ^ (number >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let number = (number ^ (number >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    number ^ (number >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::registry::Registry;
    use crate::scene::Profile;

    const BOUNDS: Bounds = Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE, center: DVec3::ZERO, radius: 1.8 };

    fn views(purpose: Purpose, count: u32) -> impl Iterator<Item = ViewId> {
        (0..count).map(move |index| ViewId { purpose, index })
    }

    /// The share of directions in a cap is its share of the sphere, within what independent draws allow.
    #[test]
    fn directions_are_uniform_on_the_sphere() {
        for purpose in [Purpose::Choice, Purpose::Promise, Purpose::Check] {
            for axis in [DVec3::X, DVec3::Y, DVec3::NEG_Z, DVec3::new(1.0, 2.0, 2.0) / 3.0] {
                for height in [-0.6_f64, 0.0, 0.8] {
                    let inside = views(purpose, 4000).filter(|view| view.direction().dot(axis) > height).count();
                    let expected = (1.0 - height) * 0.5;
                    let deviation = (expected * (1.0 - expected) / 4000.0).sqrt();
                    let share = inside as f64 / 4000.0;
                    assert!((share - expected).abs() < 4.0 * deviation, "{purpose:?} {axis} {height}: {share}");
                }
            }
        }
    }

    #[test]
    fn views_of_different_purposes_differ() {
        let all = [Purpose::Choice, Purpose::Promise, Purpose::Check].map(|purpose| views(purpose, 300));
        let mut seen: Vec<_> = all.into_iter().flatten().map(|view| view.direction().to_array()).collect();
        seen.sort_by(|one, other| one.partial_cmp(other).unwrap());
        assert!(seen.windows(2).all(|pair| pair[0].map(f64::to_bits) != pair[1].map(f64::to_bits)));
    }

    #[test]
    fn a_run_up_leads_to_its_view_in_equal_steps() {
        let mut setting = Setting::from(&Profile::Quick.scene());
        for up_axis in [UpAxis::Y, UpAxis::Z] {
            setting.up_axis = up_axis;
            for view in views(Purpose::Choice, 50) {
                let cameras = view.cameras(30, &setting, &BOUNDS).unwrap();
                let seen: Vec<DVec3> = cameras.iter().map(|camera| camera.eye().as_dvec3().normalize()).collect();
                assert_eq!(seen.len(), 31);
                assert!(seen[30].angle_between(view.direction()) < 1e-6);
                for pair in seen.windows(2) {
                    assert!((pair[0].angle_between(pair[1]) - STEP_RAD).abs() < 1e-5);
                }
                assert!((seen[0].angle_between(seen[30]) - 30.0 * STEP_RAD).abs() < 1e-5, "on a great circle");
            }
        }
    }

    #[test]
    fn a_view_along_the_axis_that_points_up_is_still_one() {
        for axis in [UpAxis::Y, UpAxis::Z] {
            let along = axis.from_y_up(DVec3::Y);
            assert!(up(along, axis).as_dvec3().dot(along).abs() < 1e-6);
        }
    }

    #[test]
    fn methods_that_may_miss_edges_are_led_up_to_their_views() {
        let registry = Registry::builtin();
        let of = |name| run_up(registry.find(name).unwrap());
        assert_eq!(["brute-force", "tracking", "image-precision", "texture"].map(of), [1, LOSSY_RUN_UP, 0, 0]);
    }
}
