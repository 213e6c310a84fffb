//! Eq. 7, silhouette points in perspective: how far their normals are off the perpendicular to the view, and what steps of
//! Newton's method leave of that.

use super::outlines::VIEWS;
use crate::directions::spread;
use crate::error::Cause;
use silhouette_core::shapes::Sphere;
use silhouette_core::view::Viewpoint;
use silhouette_core::{Method, PreparedMesh};
use silhouette_smoothing::{Eye, Smoothing, SmoothingOptions};
use std::sync::Arc;

/// Numbers of Newton's steps; 0 is the paper's approximation.
pub const STEPS: [u32; 5] = [0, 1, 2, 3, 4];

/// Distances of the eye from the middle of a sphere, in radii.
pub const DISTANCES: [f64; 4] = [50.0, 5.0, 2.0, 1.2];

/// Largest angle in degrees by which the normal of a silhouette point of an icosphere of 80 faces is off, over all views.
///
/// # Errors
/// [`Cause`]: options out of range, which a test rules out.
pub fn worst_deg(distance: f64, newton_steps: u32) -> Result<f64, Cause> {
    let mesh = Arc::new(PreparedMesh::new(Sphere::default().icosphere(1)?));
    let mut smoothing = Smoothing::new(&mesh, SmoothingOptions { newton_steps, ..SmoothingOptions::default() })?;
    let mut worst = 0.0_f64;
    for toward in spread(VIEWS) {
        let eye = Eye::from(Viewpoint::Perspective { eye: (distance * toward).as_vec3() });
        smoothing.find_silhouette(eye);
        for point in smoothing.silhouette().points() {
            let cosine = eye.toward(point.position).normalize_or_zero().dot(point.normal);
            worst = worst.max(cosine.abs().asin().to_degrees());
        }
    }
    Ok(worst)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_step_leaves_less_and_near_eyes_ask_for_more() {
        let near = STEPS.map(|steps| worst_deg(1.2, steps).unwrap());
        assert!(near.is_sorted_by(|more, less| more > less) && near[0] > 2.0 && near[4] < 1e-3, "{near:?}");
        assert!(DISTANCES.map(|distance| worst_deg(distance, 0).unwrap()).is_sorted());
    }
}
