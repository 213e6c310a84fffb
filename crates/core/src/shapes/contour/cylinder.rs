//! Capped cylinder: two lines on the side and the arcs of the rims between a facing and an averted surface.
//!
//! With the axis along y, the side at angle a has the normal (cos a, 0, -sin a), so an eye at distance rho from the axis
//! sees it where `cos(a - a_eye) > R / rho`: an interval of half-width `acos(R / rho)` about the eye's own angle, none
//! at all within the radius. A cap is seen from beyond its plane only.

use super::super::{Cylinder, around_y};
use super::{AnalyticContour, ContourCurve, ContourKind, Path};
use crate::view::Viewpoint;
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// What of a cylinder faces the viewer.
struct Seen {
    /// Middle of the facing part of the side, in radians around the axis, and half its width; `None` where no part does.
    side: Option<(f64, f64)>,
    /// Whether the lower and the upper cap do.
    caps: [bool; 2],
}

impl Cylinder {
    fn seen(&self, viewpoint: &Viewpoint) -> Seen {
        // The angle is that of `around_y`, which turns from +x towards -z.
        let angle = |v: DVec3| (-v.z).atan2(v.x);
        match *viewpoint {
            Viewpoint::Perspective { eye } => {
                let eye = eye.as_dvec3();
                let from_axis = eye.x.hypot(eye.z);
                let side = (from_axis > self.radius).then(|| (angle(eye), (self.radius / from_axis).acos()));
                Seen { side, caps: [-eye.y, eye.y].map(|height| height > 0.5 * self.height) }
            }
            Viewpoint::Orthographic { toward_viewer } => {
                let toward = toward_viewer.as_dvec3();
                let side = (toward.x != 0.0 || toward.z != 0.0).then(|| (angle(toward), FRAC_PI_2));
                Seen { side, caps: [toward.y < 0.0, toward.y > 0.0] }
            }
        }
    }

    fn rim(&self, y: f64, start_rad: f64, sweep_rad: f64) -> ContourCurve {
        let (u, v) = (around_y(0.0) * self.radius, around_y(FRAC_PI_2) * self.radius);
        let path = Path::Ellipse { center: DVec3::Y * y, u, v, start_rad, sweep_rad };
        ContourCurve { kind: ContourKind::Crease, path }
    }
}

impl AnalyticContour for Cylinder {
    /// Lines first, then the lower and the upper rim's arc. Lines and arcs meet end to end in one closed loop. From
    /// inside, nothing.
    fn contour(&self, viewpoint: &Viewpoint) -> Vec<ContourCurve> {
        let Seen { side, caps } = self.seen(viewpoint);
        let heights = [-0.5 * self.height, 0.5 * self.height];
        let mut curves = Vec::new();
        if let Some((middle, half_width)) = side {
            for angle in [middle - half_width, middle + half_width] {
                curves.push(ContourCurve::segment(heights.map(|y| around_y(angle) * self.radius + DVec3::Y * y)));
            }
        }
        for (y, cap_is_seen) in heights.into_iter().zip(caps) {
            match (side, cap_is_seen) {
                (Some((middle, half)), true) => curves.push(self.rim(y, middle + half, TAU - 2.0 * half)),
                (Some((middle, half)), false) => curves.push(self.rim(y, middle - half, 2.0 * half)),
                (None, true) => curves.push(self.rim(y, 0.0, TAU)),
                (None, false) => {}
            }
        }
        curves
    }

    fn distance(&self, point: DVec3) -> f64 {
        let beyond = DVec2::new(point.x.hypot(point.z) - self.radius, point.y.abs() - 0.5 * self.height);
        beyond.max(DVec2::ZERO).length() + beyond.max_element().min(0.0)
    }

    fn normal(&self, point: DVec3) -> DVec3 {
        let from_side = (point.x.hypot(point.z) - self.radius).abs();
        let from_cap = (point.y.abs() - 0.5 * self.height).abs();
        // On a rim both are zero but for rounding, which must not decide.
        let on_side = from_side <= from_cap || from_side <= 1e-12 * self.radius;
        if on_side { DVec3::new(point.x, 0.0, point.z).normalize() } else { DVec3::Y * point.y.signum() }
    }
}
