//! Torus: the contour generator solved for the angle around the tube.
//!
//! With u around the axis and v around the tube, the normal at (u, v) is `n = cos v e(u) + sin v y`, where e(u) is the
//! outward direction at u, and `n . x = R cos v + r`. So the condition `n . (P - x) = 0` reads
//!
//! ```text
//! a cos v + b sin v = c    with  a = P . e(u) - R,  b = P . y,  c = r    from an eye P
//!                                a = w . e(u),      b = w . y,  c = 0    from a direction w
//! ```
//!
//! and has the two solutions `v = atan2(b, a) +- acos(c / sqrt(a^2 + b^2))` where `a^2 + b^2 >= c^2`. That fails only
//! for an eye closer than r to the plane of the centre line, at those u where the line of sight starts within the tube's
//! reach, an interval about the eye's own u or about its opposite; there the two branches end by meeting.

use super::super::{Torus, around_y};
use super::{AnalyticContour, ContourCurve, ContourKind, Path};
use crate::view::Viewpoint;
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// A closed curve on a torus: one branch of solutions all around the axis, or both over an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TorusCurve {
    torus: Torus,
    condition: Condition,
    course: Course,
}

/// `a cos v + b sin v = c` for each u.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Condition {
    /// The eye, or the direction towards the viewer.
    viewer: DVec3,
    /// What `a` is short of `viewer . e(u)`: the major radius, or 0.
    offset: f64,
    /// The tube's radius, or 0.
    c: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Course {
    /// All u, with the branch `+` or `-`.
    Around {
        /// 1 or -1.
        branch: f64,
    },
    /// There on the branch `-`, back on the branch `+`, for u within `half_width` of `middle`.
    ThereAndBack { middle: f64, half_width: f64 },
    /// All u at one v: seen exactly from the side.
    Parallel { v: f64 },
    /// All v at one u: seen exactly from the side.
    Meridian { u: f64 },
}

impl TorusCurve {
    pub(super) fn point(&self, t: f64) -> DVec3 {
        let (u, v) = match self.course {
            Course::Around { branch } => (TAU * t, self.condition.solve(TAU * t, branch)),
            Course::ThereAndBack { middle, half_width } => {
                // Cosine steps in u: v has the slope of a square root where the branches meet.
                let u = middle - half_width * (TAU * t).cos();
                (u, self.condition.solve(u, if t < 0.5 { -1.0 } else { 1.0 }))
            }
            Course::Parallel { v } => (TAU * t, v),
            Course::Meridian { u } => (u, TAU * t),
        };
        let Torus { major_radius, minor_radius } = self.torus;
        around_y(u) * (major_radius + minor_radius * v.cos()) + DVec3::Y * (minor_radius * v.sin())
    }
}

impl Condition {
    fn solve(&self, u: f64, branch: f64) -> f64 {
        let ab = DVec2::new(self.viewer.dot(around_y(u)) - self.offset, self.viewer.y);
        // Where the branches meet, rounding may leave the quotient just above 1.
        ab.to_angle() + branch * (self.c / ab.length()).min(1.0).acos()
    }
}

impl AnalyticContour for Torus {
    /// From outside two closed curves; the exceptions:
    /// - the eye within the tube: one curve, on the part of the tube beyond the hole;
    /// - an orthographic view exactly from the side: four circles that cross where they touch, top, bottom and the two
    ///   cross-sections of the tube at right angles to the line of sight.
    fn contour(&self, viewpoint: &Viewpoint) -> Vec<ContourCurve> {
        let (condition, courses) = match *viewpoint {
            Viewpoint::Perspective { eye } => {
                let viewer = eye.as_dvec3();
                let condition = Condition { viewer, offset: self.major_radius, c: self.minor_radius };
                (condition, self.courses_from(viewer))
            }
            Viewpoint::Orthographic { toward_viewer } => {
                let Some(viewer) = toward_viewer.as_dvec3().try_normalize() else { return Vec::new() };
                let courses = if viewer.y == 0.0 {
                    let side = angle_of(viewer) + 0.5 * PI;
                    let parallel = |v| Course::Parallel { v };
                    let meridian = |u| Course::Meridian { u };
                    vec![parallel(0.5 * PI), parallel(-0.5 * PI), meridian(side), meridian(side + PI)]
                } else {
                    around().to_vec()
                };
                (Condition { viewer, offset: 0.0, c: 0.0 }, courses)
            }
        };
        let curve = |course| {
            let path = Path::Torus(TorusCurve { torus: *self, condition, course });
            ContourCurve { kind: ContourKind::Smooth, path }
        };
        courses.into_iter().map(curve).collect()
    }

    fn distance(&self, point: DVec3) -> f64 {
        DVec2::new(point.x.hypot(point.z) - self.major_radius, point.y).length() - self.minor_radius
    }

    fn normal(&self, point: DVec3) -> DVec3 {
        (point - around_y(angle_of(point)) * self.major_radius).normalize()
    }
}

impl Torus {
    /// The u at which an eye has solutions: a^2 + b^2 >= r^2 with a = rho cos(u - u_eye) - R.
    fn courses_from(&self, eye: DVec3) -> Vec<Course> {
        let reach = (self.minor_radius - eye.y.abs()) * (self.minor_radius + eye.y.abs());
        let from_axis = eye.x.hypot(eye.z);
        // Solutions are missing for |a| < gap.
        let gap = reach.max(0.0).sqrt();
        if reach <= 0.0 || from_axis <= self.major_radius - gap {
            return around().to_vec();
        }
        let eye_angle = angle_of(eye);
        let beyond = Course::ThereAndBack {
            middle: eye_angle + PI,
            half_width: PI - ((self.major_radius - gap) / from_axis).acos(),
        };
        let outer = (self.major_radius + gap) / from_axis;
        if outer >= 1.0 {
            return vec![beyond];
        }
        vec![Course::ThereAndBack { middle: eye_angle, half_width: outer.acos() }, beyond]
    }
}

fn around() -> [Course; 2] {
    [Course::Around { branch: -1.0 }, Course::Around { branch: 1.0 }]
}

/// The angle of [`around_y`] that points where `v` does.
fn angle_of(v: DVec3) -> f64 {
    (-v.z).atan2(v.x)
}
