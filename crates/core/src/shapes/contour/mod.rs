//! Contour generators in closed form.
//!
//! The contour generator of a smooth surface is where its normal n is perpendicular to the line of sight:
//! `n . (P - x) = 0` for an eye P, `n . w = 0` for a direction w towards the viewer. It is the truth that silhouettes of
//! a mesh approximate. All of it is yielded, whether the surface hides it from the viewer or not, as curves in object
//! space and 64-bit floats.

mod cylinder;
mod ellipsoid;
mod torus;

use crate::view::Viewpoint;
use glam::DVec3;
use torus::TorusCurve;

/// A surface whose contour generator is known.
///
/// Shapes: [`Sphere`](super::Sphere), [`Ellipsoid`](super::Ellipsoid), [`Cylinder`](super::Cylinder),
/// [`Torus`](super::Torus), each with the dimensions of its struct, which must be such that it can be
/// meshed.
pub trait AnalyticContour: Send + Sync {
    /// The curves of the contour generator. Empty where there is none: for a convex shape exactly when the eye is not
    /// outside of it (a torus has a contour even from within its tube). Curves may share end points; their direction has
    /// no meaning. O(1).
    fn contour(&self, viewpoint: &Viewpoint) -> Vec<ContourCurve>;

    /// How far `point` is from the surface, in object units: negative inside, 0 on the surface. Exact for sphere,
    /// cylinder and torus; for the ellipsoid exact to first order near the surface.
    fn distance(&self, point: DVec3) -> f64;

    /// The unit outward normal at a point of the surface; at a crease, that of the curved side.
    fn normal(&self, point: DVec3) -> DVec3;

    /// `n . (P - x)` or `n . w` with unit n and w at a point x of the surface: above 0 where it faces the viewer, 0 on
    /// the contour generator. In object units for a perspective, a cosine for an orthographic view; NaN for an
    /// orthographic view without direction.
    fn facing(&self, point: DVec3, viewpoint: &Viewpoint) -> f64 {
        let toward_viewer = match *viewpoint {
            Viewpoint::Perspective { eye } => eye.as_dvec3() - point,
            Viewpoint::Orthographic { toward_viewer } => toward_viewer.as_dvec3().normalize(),
        };
        self.normal(point).dot(toward_viewer)
    }
}

/// Why a curve belongs to the contour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ContourKind {
    /// The normal is perpendicular to the line of sight.
    Smooth,
    /// A crease between a side that faces the viewer and one that does not.
    Crease,
}

/// One smooth curve of a contour generator, in object space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContourCurve {
    kind: ContourKind,
    path: Path,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Path {
    /// From one point to the other.
    Segment([DVec3; 2]),
    /// `center + cos(a) u + sin(a) v` for `a` from `start_rad` on over `sweep_rad`.
    Ellipse { center: DVec3, u: DVec3, v: DVec3, start_rad: f64, sweep_rad: f64 },
    /// A closed curve on a torus.
    Torus(TorusCurve),
}

impl ContourCurve {
    fn segment(ends: [DVec3; 2]) -> Self {
        Self { kind: ContourKind::Smooth, path: Path::Segment(ends) }
    }

    /// The whole ellipse with conjugate radii `u` and `v`.
    fn ellipse(center: DVec3, u: DVec3, v: DVec3) -> Self {
        let path = Path::Ellipse { center, u, v, start_rad: 0.0, sweep_rad: std::f64::consts::TAU };
        Self { kind: ContourKind::Smooth, path }
    }

    /// Why the curve belongs to the contour.
    pub fn kind(&self) -> ContourKind {
        self.kind
    }

    /// Whether `point(0)` and `point(1)` are the same point.
    pub fn is_closed(&self) -> bool {
        match self.path {
            Path::Segment(_) => false,
            Path::Ellipse { sweep_rad, .. } => sweep_rad >= std::f64::consts::TAU,
            Path::Torus(_) => true,
        }
    }

    /// The point at `t` in 0..=1. Continuous in `t`, but of no particular speed.
    pub fn point(&self, t: f64) -> DVec3 {
        match self.path {
            Path::Segment([from, to]) => from.lerp(to, t),
            Path::Ellipse { center, u, v, start_rad, sweep_rad } => {
                let (sin, cos) = (start_rad + sweep_rad * t).sin_cos();
                center + u * cos + v * sin
            }
            Path::Torus(curve) => curve.point(t),
        }
    }

    /// The polyline through `segments + 1` points at equal steps of `t` (`segments` points if the curve is closed, whose
    /// last segment returns to the first point). At least one segment is made.
    pub fn polyline(&self, segments: u32) -> Vec<DVec3> {
        let segments = segments.max(1);
        let points = segments + u32::from(!self.is_closed());
        (0..points).map(|i| self.point(f64::from(i) / f64::from(segments))).collect()
    }
}

#[cfg(test)]
mod tests;
