//! Views around a mesh: the same for every method and every run.

use glam::DVec3;
use silhouette_core::Camera;
use silhouette_core::glam::Vec3;
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Framing, UpAxis, ViewError};
use std::f64::consts::TAU;

/// An inclined orbit around a mesh, whose whole bounding sphere every view shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orbit {
    /// How each view projects.
    pub framing: Framing,
    /// Viewport in pixels.
    pub size: [u32; 2],
    /// Number of views.
    pub views: u32,
    /// The axis that the orbit is around, which points up in every view.
    pub up_axis: UpAxis,
    /// Azimuth of the first view, from the front towards the right: with y up from the z axis towards the x axis.
    pub first_azimuth_rad: f64,
    /// Middle of the elevations, above the horizon.
    pub elevation_rad: f64,
    /// How far the elevation swings to both sides in a turn.
    pub swing_rad: f64,
    /// Azimuth from view to view.
    pub step_rad: f64,
}

impl Orbit {
    /// `views` views spread over a whole turn. No view of a usual number looks along an axis or a diagonal of a model, where
    /// many faces would be seen edge-on at once.
    pub fn turn(framing: Framing, size: [u32; 2], views: u32) -> Self {
        let step_rad = TAU / f64::from(views.max(1));
        let (up_axis, first_azimuth_rad, elevation_rad, swing_rad) = (UpAxis::Y, 0.417, 0.31, 0.23);
        Self { framing, size, views, up_axis, first_azimuth_rad, elevation_rad, swing_rad, step_rad }
    }

    /// The cameras in order. O(views).
    ///
    /// # Errors
    /// [`ViewError`] where field of view or viewport do not make a camera.
    pub fn cameras(&self, bounds: &Bounds) -> Result<Vec<Camera>, ViewError> {
        let up = self.up_axis.from_y_up(DVec3::Y).as_vec3();
        (0..self.views).map(|view| Camera::framing(bounds, self.direction(view), up, self.framing, self.size)).collect()
    }

    /// Eyes of `views` views spread over a whole turn, `distance_radii` radii of the bounding sphere from its centre: for
    /// timing extraction, which knows no viewport. O(views).
    pub fn eyes(bounds: &Bounds, views: u32, distance_radii: f64) -> Vec<Vec3> {
        let orbit = Self::turn(Framing::Orthographic, [1, 1], views);
        let eye = |view| bounds.center + orbit.direction(view) * (distance_radii * bounds.radius);
        (0..views).map(|view| eye(view).as_vec3()).collect()
    }

    /// From the mesh towards the viewer.
    fn direction(&self, view: u32) -> DVec3 {
        let azimuth = self.first_azimuth_rad + self.step_rad * f64::from(view);
        let elevation = self.elevation_rad + self.swing_rad * (azimuth + 1.0).sin();
        let direction = DVec3::new(azimuth.sin() * elevation.cos(), elevation.sin(), azimuth.cos() * elevation.cos());
        self.up_axis.from_y_up(direction)
    }
}

/// Which of `frames` timed frames are scored, ascending: the middle one of each of `scored` equal stretches. No more than
/// there are frames. O(scored).
pub fn scored_frames(frames: u32, scored: u32) -> Vec<u32> {
    let scored = scored.min(frames);
    (0..u64::from(scored)).map(|at| ((2 * at + 1) * u64::from(frames) / (2 * u64::from(scored))) as u32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOUNDS: Bounds = Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE, center: DVec3::ZERO, radius: 1.8 };

    #[test]
    fn no_view_looks_along_an_axis_or_a_diagonal() {
        for views in [1, 2, 4, 6, 8, 24] {
            for framing in [Framing::Perspective { fov_y_rad: 0.8 }, Framing::Orthographic] {
                let cameras = Orbit::turn(framing, [64, 64], views).cameras(&BOUNDS).unwrap();
                assert_eq!(cameras.len(), views as usize);
                for camera in cameras {
                    let [x, y, z] = camera.eye().as_dvec3().normalize().abs().to_array();
                    for (one, other) in [(x, y), (y, z), (z, x)] {
                        assert!((one - other).abs() > 1e-3, "{camera:?}");
                    }
                    assert!(x.min(y).min(z) > 1e-3, "{camera:?}");
                }
            }
        }
    }

    #[test]
    fn eyes_keep_their_distance_and_the_direction_of_cameras() {
        let bounds = Bounds { center: DVec3::new(1.0, 2.0, 3.0), ..BOUNDS };
        let eyes = Orbit::eyes(&bounds, 8, 3.0);
        let cameras = Orbit::turn(Framing::Orthographic, [64, 64], 8).cameras(&bounds).unwrap();
        assert_eq!(eyes.len(), 8);
        for (eye, camera) in eyes.iter().zip(cameras) {
            let [offset, seen] = [*eye, camera.eye()].map(|eye| eye.as_dvec3() - bounds.center);
            assert!((offset.length() - 3.0 * bounds.radius).abs() < 1e-5 && offset.angle_between(seen) < 1e-5);
        }
    }

    /// A mesh turned so that its z points up is seen as the mesh itself with y up: cameras differ by that turn alone.
    #[test]
    fn an_orbit_about_z_is_that_about_y_turned() {
        let about_y = Orbit::turn(Framing::Orthographic, [64, 64], 6);
        let about_z = Orbit { up_axis: UpAxis::Z, ..about_y };
        let [of_y, of_z] = [about_y, about_z].map(|orbit| orbit.cameras(&BOUNDS).unwrap());
        for (y, z) in of_y.iter().zip(&of_z) {
            let turned = UpAxis::Z.from_y_up(y.eye().as_dvec3());
            assert!(z.eye().as_dvec3().distance(turned) < 1e-5 && z.up() == Vec3::Z, "{z:?}");
        }
    }

    #[test]
    fn impossible_views_are_refused() {
        let orbit = Orbit::turn(Framing::Perspective { fov_y_rad: 4.0 }, [64, 64], 2);
        assert_eq!(orbit.cameras(&BOUNDS), Err(ViewError::Projection));
    }

    #[test]
    fn scored_frames_are_spread_evenly_over_the_timed_ones() {
        assert_eq!(scored_frames(60, 6), [5, 15, 25, 35, 45, 55]);
        assert_eq!(scored_frames(7, 2), [1, 5]);
        assert_eq!(scored_frames(3, 9), [0, 1, 2]);
        assert_eq!(scored_frames(u32::MAX, 1), [u32::MAX / 2]);
        assert!(scored_frames(60, 0).is_empty() && scored_frames(0, 6).is_empty());
    }
}
