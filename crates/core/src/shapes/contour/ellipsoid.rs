//! Sphere and ellipsoid: the contour generator is one planar ellipse.
//!
//! A sphere of radius R seen from distance d shows the circle of radius `R sqrt(1 - (R/d)^2)` in the plane perpendicular
//! to the line of sight at `R^2 / d` from the centre. An ellipsoid is an affine image of the unit sphere, and affine
//! maps keep tangency: map the eye to the unit sphere's space, take its circle, map that back.

use super::super::{Ellipsoid, Sphere};
use super::{AnalyticContour, ContourCurve};
use crate::view::Viewpoint;
use glam::DVec3;

impl AnalyticContour for Sphere {
    fn contour(&self, viewpoint: &Viewpoint) -> Vec<ContourCurve> {
        Ellipsoid { semi_axes: [self.radius; 3] }.contour(viewpoint)
    }

    fn distance(&self, point: DVec3) -> f64 {
        point.length() - self.radius
    }

    fn normal(&self, point: DVec3) -> DVec3 {
        point.normalize()
    }
}

impl AnalyticContour for Ellipsoid {
    fn contour(&self, viewpoint: &Viewpoint) -> Vec<ContourCurve> {
        let semi_axes = DVec3::from_array(self.semi_axes);
        // Height and radius of the unit sphere's circle, in the direction of the viewer.
        let (toward, height) = match *viewpoint {
            Viewpoint::Perspective { eye } => {
                let eye = eye.as_dvec3() / semi_axes;
                (eye, 1.0 / eye.length())
            }
            Viewpoint::Orthographic { toward_viewer } => (toward_viewer.as_dvec3() / semi_axes, 0.0),
        };
        let Some(toward) = toward.try_normalize().filter(|_| height < 1.0) else { return Vec::new() };
        let radius = ((1.0 - height) * (1.0 + height)).sqrt();
        let (u, v) = toward.any_orthonormal_pair();
        vec![ContourCurve::ellipse(toward * height * semi_axes, u * radius * semi_axes, v * radius * semi_axes)]
    }

    fn distance(&self, point: DVec3) -> f64 {
        let semi_axes = DVec3::from_array(self.semi_axes);
        let level = (point / semi_axes).length();
        let slope = (point / (semi_axes * semi_axes)).length();
        // At the centre, where the first-order form is 0/0, the surface is one shortest semi-axis away.
        if slope > 0.0 { level * (level - 1.0) / slope } else { -semi_axes.min_element() }
    }

    fn normal(&self, point: DVec3) -> DVec3 {
        let semi_axes = DVec3::from_array(self.semi_axes);
        (point / (semi_axes * semi_axes)).normalize()
    }
}
