//! How far the outlines of coarse spheres are from the circle in the image. The paper prints no such figure.

use crate::directions::spread;
use crate::error::Cause;
use silhouette_core::glam::DVec3;
use silhouette_core::shapes::Sphere;
use silhouette_core::view::Viewpoint;
use silhouette_core::{
    ExtractsCurves, FaceFacings, Method, MethodOptions, PreparedMesh, Progress, SilhouetteCurves, SilhouetteEdges,
    Topology,
};
use silhouette_smoothing::{BoundaryCurve, InterpolatedContours, Smoothing};
use std::sync::Arc;

/// Number of views.
pub const VIEWS: u32 = 60;

/// Levels of the icospheres: 80 and 320 faces.
pub const LEVELS: [u32; 2] = [1, 2];

/// Distances of the eye from the middle in radii; parallel projection first.
pub const DISTANCES: [Option<f64>; 3] = [None, Some(2.0), Some(1.2)];

/// Points per piece of a curve.
const SAMPLES: u32 = 16;

/// What follows the outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outline {
    /// Smoothing with these options.
    Smoothing(&'static str),
    /// Interpolated contours with these.
    InterpolatedContours(&'static str),
    /// Curves through the vertices of silhouette edges.
    BoundaryCurve,
    /// The silhouette edges.
    Edges,
}

/// All of them with their labels, in the order of the table.
pub const OUTLINES: [(&str, Outline); 7] = [
    ("smoothing, normals=sphere", Outline::Smoothing("normals=sphere")),
    ("smoothing", Outline::Smoothing("")),
    ("smoothing, as printed", Outline::Smoothing("newton=0 segments=as-printed normals=angle")),
    ("interpolated contours, normals=sphere", Outline::InterpolatedContours("normals=sphere")),
    ("interpolated contours", Outline::InterpolatedContours("")),
    ("boundary curve", Outline::BoundaryCurve),
    ("mesh edges", Outline::Edges),
];

/// The largest difference of the radius in the image from the circle's, as a share of the latter, over all views.
///
/// # Errors
/// [`Cause`]: cancelled.
pub fn worst(level: u32, outline: Outline, distance: Option<f64>, progress: &dyn Progress) -> Result<f64, Cause> {
    let mesh = Arc::new(PreparedMesh::new(Sphere::default().icosphere(level)?));
    match outline {
        Outline::Smoothing(words) => worst_curve::<Smoothing>(&mesh, words, distance, progress),
        Outline::InterpolatedContours(words) => worst_curve::<InterpolatedContours>(&mesh, words, distance, progress),
        Outline::BoundaryCurve => worst_curve::<BoundaryCurve>(&mesh, "", distance, progress),
        Outline::Edges => worst_edge(&mesh, distance, progress),
    }
}

fn worst_curve<M: Method + ExtractsCurves>(
    mesh: &Arc<PreparedMesh>,
    words: &str,
    distance: Option<f64>,
    progress: &dyn Progress,
) -> Result<f64, Cause> {
    let mut method = M::new(mesh, M::Options::parse(words.split_whitespace())?)?;
    let mut curves = SilhouetteCurves::default();
    let mut worst = 0.0_f64;
    for toward in spread(VIEWS) {
        progress.check()?;
        let (viewpoint, toward) = viewpoint(toward, distance);
        method.extract_curves(&viewpoint, &mut curves);
        for piece in curves.pieces() {
            for sample in 0..=SAMPLES {
                let point = piece.point(f64::from(sample) / f64::from(SAMPLES));
                worst = worst.max(radius_error(point, toward, distance));
            }
        }
    }
    Ok(worst)
}

fn worst_edge(mesh: &PreparedMesh, distance: Option<f64>, progress: &dyn Progress) -> Result<f64, Cause> {
    let topology = mesh.artefact::<Topology>("outlines of spheres", progress)?;
    let mut worst = 0.0_f64;
    for toward in spread(VIEWS) {
        let (viewpoint, toward) = viewpoint(toward, distance);
        let facings = FaceFacings::new(mesh.mesh(), &viewpoint);
        for edge in SilhouetteEdges::of(&topology, &facings).iter() {
            let [from, to] = topology.end_points(edge).map(|v| mesh.mesh().positions()[v.index()].as_dvec3());
            for sample in 0..=SAMPLES {
                let point = from.lerp(to, f64::from(sample) / f64::from(SAMPLES));
                worst = worst.max(radius_error(point, toward, distance));
            }
        }
    }
    Ok(worst)
}

/// The viewpoint in a direction, and the unit vector towards it as rounded to its 32 bits.
fn viewpoint(toward: DVec3, distance: Option<f64>) -> (Viewpoint, DVec3) {
    let at = (distance.unwrap_or(1.0) * toward).as_vec3();
    let viewpoint = match distance {
        None => Viewpoint::Orthographic { toward_viewer: at },
        Some(_) => Viewpoint::Perspective { eye: at },
    };
    (viewpoint, at.as_dvec3().normalize())
}

/// How far from the axis of view a point near the unit sphere appears, compared with the sphere's outline.
fn radius_error(point: DVec3, toward: DVec3, distance: Option<f64>) -> f64 {
    let depth = point.dot(toward);
    let across = (point - depth * toward).length();
    match distance {
        None => (across - 1.0).abs(),
        // In the plane through the middle, the outline's radius is d / sqrt(d² - 1).
        Some(d) => (across * (d * d - 1.0).sqrt() / (d - depth) - 1.0).abs(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::NoProgress;

    #[test]
    fn points_of_the_contour_have_no_error_and_others_have() {
        for distance in [2.0, 1.2_f64] {
            let height = 1.0 / distance;
            let point = DVec3::new((1.0 - height * height).sqrt(), 0.0, height);
            assert!(radius_error(point, DVec3::Z, Some(distance)) < 1e-12);
            assert!(radius_error(0.99 * point, DVec3::Z, Some(distance)) > 0.005);
        }
        assert!(radius_error(DVec3::new(0.6, 0.8, 9.0), DVec3::Z, None) < 1e-12);
    }

    #[test]
    fn curves_come_far_closer_than_chords() {
        for distance in DISTANCES {
            let of = |outline| worst(1, outline, distance, &NoProgress).unwrap();
            let [smooth, printed, contours, edges] =
                [OUTLINES[0].1, OUTLINES[2].1, OUTLINES[4].1, Outline::Edges].map(of);
            assert!(smooth < 0.002 && smooth <= 1.001 * printed, "{distance:?}: {smooth} {printed}");
            assert!(
                printed < 0.2 * edges && contours > 0.06 && edges > 0.06,
                "{distance:?}: {printed} {contours} {edges}"
            );
        }
    }
}
