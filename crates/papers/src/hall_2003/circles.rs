//! Where the eye flies: level circles, a tenth of a degree per frame where it is measured.
//!
//! The paper says that the position differs from frame to frame, and no more. Its figures at high levels follow the length
//! of the silhouette, which the path decides. So no path is preferred: counts are ranges over twenty circles
//! ([`circles`]), near and far, from below and above. Times, and what is missed, are measured on [`CIRCLE`], which is the
//! one in the middle of the distances and level with the mesh, whatever its figures are.
//!
//! Counts are those of one flight ([`Circle::flight`]) whose first frame is found by brute force, as the paper begins. For
//! all else twelve arcs of small steps, evenly around the mesh, are measured. Between them, and for a whole turn before the
//! first, the eye flies on in steps of a degree: trackers keep their past, so that what they miss is what is missed after
//! any long flight, and not what brute force has left them to lose.

use glam::DVec3;
use silhouette_core::Viewpoint;
use silhouette_core::glam::Vec3;
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Camera, Projection, ViewError};

/// From frame to frame.
pub const STEP_DEG: f64 = 0.1;

/// A level circle around a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    /// Of the eye from the middle of the mesh, in radii of its bounding sphere.
    pub distance_radii: f64,
    /// Of the eye above the horizon.
    pub elevation_deg: f64,
}

/// The circle for times and for what is missed, by rule: the middle one of the distances of [`circles`], level with the
/// middle of the mesh.
pub const CIRCLE: Circle = Circle { distance_radii: 3.0, elevation_deg: 0.0 };

/// Twenty circles, near and far, from below and above; [`CIRCLE`] is among them.
pub fn circles() -> impl Iterator<Item = Circle> {
    let elevations =
        |distance_radii| [-40.0, 0.0, 40.0, 80.0].map(|elevation_deg| Circle { distance_radii, elevation_deg });
    [1.5, 2.0, 3.0, 6.0, 20.0].into_iter().flat_map(elevations)
}

impl Circle {
    fn eye(self, bounds: Bounds, azimuth_deg: f64) -> Vec3 {
        let (sin, cos) = azimuth_deg.to_radians().sin_cos();
        let (up, level) = self.elevation_deg.to_radians().sin_cos();
        let direction = DVec3::new(cos * level, up, sin * level);
        (bounds.center + direction * (self.distance_radii * bounds.radius)).as_vec3()
    }

    /// One frame and then this many more, each [`STEP_DEG`] on.
    pub fn flight(self, bounds: Bounds, frames: u32) -> impl Iterator<Item = Viewpoint> {
        let azimuth_deg = |frame| FIRST_ARC_DEG + STEP_DEG * f64::from(frame);
        (0..=frames).map(move |frame| Viewpoint::Perspective { eye: self.eye(bounds, azimuth_deg(frame)) })
    }
}

/// Where the first arc begins.
const FIRST_ARC_DEG: f64 = 24.0;

/// Number of arcs that are measured.
const ARCS: u32 = 12;

/// Part of the picture that stays free around the bounding sphere.
const MARGIN: f64 = 0.05;

/// A frame of the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Where it is seen from.
    pub view: Viewpoint,
    /// Whether it is measured, or only leads to the next arc.
    pub is_measured: bool,
}

/// The path around a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Path {
    bounds: Bounds,
    /// Measured frames per arc.
    per_arc: u32,
}

impl Path {
    /// A path of this many measured frames, rounded up to a multiple of the number of arcs.
    pub fn new(bounds: Bounds, measured: u32) -> Self {
        Self { bounds, per_arc: measured.div_ceil(ARCS) }
    }

    /// A whole turn in steps of a degree that ends a step before the frames begin.
    pub fn lead_in(&self) -> impl Iterator<Item = Viewpoint> {
        (1..=360_u32).rev().map(|back| self.view(FIRST_ARC_DEG - f64::from(back)))
    }

    /// The frames: along each arc, and on to the next.
    pub fn frames(&self) -> Vec<Frame> {
        let between_deg = 360.0 / f64::from(ARCS);
        let arc_deg = STEP_DEG * f64::from(self.per_arc);
        let steps = (between_deg - arc_deg).ceil().max(1.0);
        let mut frames = Vec::new();
        for arc in 0..ARCS {
            let begin_deg = FIRST_ARC_DEG + between_deg * f64::from(arc);
            let mut push = |azimuth_deg, is_measured| frames.push(Frame { view: self.view(azimuth_deg), is_measured });
            push(begin_deg, false);
            (1..=self.per_arc).for_each(|frame| push(begin_deg + STEP_DEG * f64::from(frame), true));
            for step in 1..steps as u32 {
                push(begin_deg + arc_deg + (between_deg - arc_deg) * f64::from(step) / steps, false);
            }
        }
        frames
    }

    /// The camera of a frame: sees the whole bounding sphere.
    ///
    /// # Errors
    /// [`ViewError`] where the mesh is so far from the origin that eye and target round to one point, or so large that 32 bits hold
    /// no eye.
    pub fn camera(&self, frame: &Frame, size: [u32; 2]) -> Result<Camera, ViewError> {
        let eye = match frame.view {
            Viewpoint::Perspective { eye } | Viewpoint::Orthographic { toward_viewer: eye } => eye,
        };
        if !eye.is_finite() {
            return Err(ViewError::TooLarge);
        }
        let fov_y_rad = 2.0 * ((1.0 + MARGIN) / CIRCLE.distance_radii).asin();
        Camera::new(eye, self.bounds.center.as_vec3(), Vec3::Y, Projection::Perspective { fov_y_rad }, size)
    }

    fn view(&self, azimuth_deg: f64) -> Viewpoint {
        Viewpoint::Perspective { eye: CIRCLE.eye(self.bounds, azimuth_deg) }
    }
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
    fn frames_follow_each_other_and_the_lead_in_in_small_steps() {
        let path = Path::new(BOUNDS, 50);
        let frames = path.frames();
        let views = path.lead_in().map(|view| (view, false));
        let all: Vec<_> = views.chain(frames.iter().map(|frame| (frame.view, frame.is_measured))).collect();
        assert_eq!(frames.iter().filter(|frame| frame.is_measured).count(), 60);
        let level = CIRCLE.elevation_deg.to_radians().cos();
        let radius = CIRCLE.distance_radii * BOUNDS.radius;
        for pair in all.windows(2) {
            let [(before, _), (now, is_measured)] = [pair[0], pair[1]];
            assert!((eye(now).length() - radius).abs() < 1e-5);
            let angle_deg = (eye(before).distance(eye(now)) / radius).to_degrees() / level;
            let right = if is_measured { (angle_deg / STEP_DEG - 1.0).abs() < 1e-3 } else { angle_deg < 1.001 };
            assert!(right, "{angle_deg}");
        }
        let middle: DVec3 = frames.iter().filter(|frame| frame.is_measured).map(|frame| eye(frame.view)).sum();
        assert!(middle.with_y(0.0).length() < 1e-3, "arcs lie evenly around the mesh");
    }

    #[test]
    fn a_mesh_that_no_eye_sees_whole_is_bad_input() {
        let largest = f64::from(f32::MAX);
        let bounds =
            Bounds { min: DVec3::splat(-largest), max: DVec3::splat(largest), center: DVec3::ZERO, radius: largest };
        let path = Path::new(bounds, 1);
        let error = path.camera(&path.frames()[0], [100, 100]).unwrap_err();
        assert_eq!(error, ViewError::TooLarge);
        assert!(crate::PaperError::of("large")(error).is_of_input());
    }

    #[test]
    fn the_circle_is_the_middle_one_by_rule() {
        let sorted = |value: fn(Circle) -> f64| {
            let mut values: Vec<f64> = circles().map(value).collect();
            values.sort_by(f64::total_cmp);
            values
        };
        let distances = sorted(|circle| circle.distance_radii);
        assert_eq!((distances[9], distances[10]), (CIRCLE.distance_radii, CIRCLE.distance_radii));
        assert!(CIRCLE.elevation_deg.abs() < 1e-12);
        assert_eq!((circles().count(), circles().filter(|&circle| circle == CIRCLE).count()), (20, 1));
    }

    #[test]
    fn a_flight_of_3600_frames_is_a_turn_and_begins_with_one_more() {
        let views: Vec<_> = CIRCLE.flight(BOUNDS, 3600).map(eye).collect();
        assert_eq!(views.len(), 3601);
        assert!(views[0].distance(views[3600]) < 1e-5 && views[0].distance(views[1800]) > 4.0);
    }

    #[test]
    fn cameras_stand_where_frames_are_seen_from_and_show_the_mesh() {
        let path = Path::new(BOUNDS, 12);
        for frame in path.frames() {
            let camera = path.camera(&frame, [100, 100]).unwrap();
            assert_eq!(camera.viewpoint(), frame.view);
            let side = camera.eye().as_dvec3().cross(DVec3::Y).normalize() * BOUNDS.radius;
            let seen = camera.project(BOUNDS.center + side).unwrap();
            assert!(seen.pixel.cmpgt(glam::DVec2::ZERO).all() && seen.pixel.cmplt(glam::DVec2::splat(100.0)).all());
        }
    }
}
