//! How close curves come to the contours of analytic shapes, in the image.

use super::shape;
use crate::SmoothingOptions;
use crate::shading_normals::NormalWeights;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::view::Viewpoint;
use silhouette_core::{ExtractsCurves, SilhouetteCurves};
use silhouette_testing::directions::spread;

/// Distance from the axis of view at which a point of a unit sphere's contour appears, relative to the sphere's own.
fn radius_error(point: DVec3, toward: DVec3, distance: Option<f64>) -> f64 {
    let across = (point - point.dot(toward) * toward).length();
    match distance {
        None => (across - 1.0).abs(),
        Some(d) => {
            // Projected to the plane through the sphere's centre.
            let scale = d / (d - point.dot(toward));
            let expected = 1.0 / (1.0 - 1.0 / (d * d)).sqrt();
            (across * scale - expected).abs() / expected
        }
    }
}

fn worst(name: &str, distance: Option<f64>, newton_steps: u32, normals: NormalWeights) -> f64 {
    let mut method = shape(name, SmoothingOptions { newton_steps, normals, ..Default::default() });
    let mut curves = SilhouetteCurves::default();
    let mut worst = 0.0_f64;
    for toward in spread(60) {
        let viewpoint = match distance {
            None => Viewpoint::Orthographic { toward_viewer: toward.as_vec3() },
            Some(d) => Viewpoint::Perspective { eye: (d * toward).as_vec3() },
        };
        let toward = match viewpoint {
            Viewpoint::Orthographic { toward_viewer: v } | Viewpoint::Perspective { eye: v } => {
                v.as_dvec3().normalize()
            }
        };
        method.extract_curves(&viewpoint, &mut curves);
        assert!(curves.len() == 1 && curves.get(0).closed, "{} chains", curves.len());
        for piece in curves.pieces() {
            for i in 0..=8 {
                worst = worst.max(radius_error(piece.point(f64::from(i) / 8.0), toward, distance));
            }
        }
    }
    worst
}

#[test]
fn spheres() {
    for name in ["icosphere:1", "icosphere:2"] {
        for distance in [None, Some(5.0), Some(2.0), Some(1.2)] {
            for normals in [NormalWeights::Sphere, NormalWeights::Area, NormalWeights::Angle] {
                println!("{name} {distance:?} {normals:?}: {:.6}", worst(name, distance, 3, normals));
            }
        }
    }
    let _ = Vec3::ZERO;
}
