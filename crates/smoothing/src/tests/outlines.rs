//! How close outlines come to those of analytic shapes.

use super::shape;
use crate::perturbation::Perturbation;
use crate::shading_normals::NormalWeights;
use crate::silhouette_segments::SegmentLaw;
use crate::{Eye, Remesher, SmoothingOptions, SmoothingView, ViewMesh};
use silhouette_core::glam::{DVec2, DVec3};
use silhouette_core::view::{Framing, Viewpoint};
use silhouette_core::{ExtractsCurves, SilhouetteCurves, shapes};
use silhouette_testing::directions::spread;
use silhouette_testing::views;

/// Exact at the vertices of a sphere.
fn exact_normals() -> SmoothingOptions {
    SmoothingOptions { normals: NormalWeights::Sphere, ..Default::default() }
}

/// The radius at which a point appears in a picture of the unit sphere, as a share of the radius of the sphere's image. The eye
/// is at `distance` in a direction, or infinitely far.
fn image_radius(point: DVec3, toward: DVec3, distance: Option<f64>) -> f64 {
    let across = (point - point.dot(toward) * toward).length();
    match distance {
        None => across,
        // In the plane through the centre; the sphere's image there is wider than the sphere.
        Some(d) => across * d / (d - point.dot(toward)) * (1.0 - 1.0 / (d * d)).sqrt(),
    }
}

/// The largest error of the radius of a sphere's outline over 60 views, as a share of the radius.
fn sphere_error(name: &str, distance: Option<f64>, options: SmoothingOptions) -> f64 {
    let mut method = shape(name, options);
    let mut curves = SilhouetteCurves::default();
    let mut worst = 0.0_f64;
    for direction in spread(60) {
        let viewpoint = match distance {
            None => Viewpoint::Orthographic { toward_viewer: direction.as_vec3() },
            Some(d) => Viewpoint::Perspective { eye: (d * direction).as_vec3() },
        };
        method.extract_curves(&viewpoint, &mut curves);
        assert!(curves.len() == 1 && curves.get(0).closed, "{name}: {} chains", curves.len());
        let points = curves.pieces().iter().flat_map(|piece| (0..8).map(|i| piece.point(f64::from(i) / 8.0)));
        worst = points.map(|point| (image_radius(point, direction, distance) - 1.0).abs()).fold(worst, f64::max);
    }
    worst
}

#[test]
fn spheres_of_80_and_320_faces_look_round() {
    for (distance, most_80, most_320) in [(None, 5e-4, 5e-5), (Some(2.0), 5e-4, 5e-5), (Some(1.2), 2e-3, 2e-4)] {
        let [coarse, fine] = ["icosphere:1", "icosphere:2"].map(|name| sphere_error(name, distance, exact_normals()));
        assert!(coarse < most_80 && fine < most_320, "{distance:?}: {coarse} and {fine}");
        // Every vertex of the coarser one has neighbours all around, so that any weights are exact.
        let default = sphere_error("icosphere:1", distance, SmoothingOptions::default());
        assert!(default < most_80, "{distance:?}: {default}");
    }
}

/// Weights by angle, as printed, are not exact where the neighbours of a vertex lie at different distances.
#[test]
fn printed_laws_are_less_exact_where_neighbours_differ_and_eyes_are_near() {
    let printed_normals = SmoothingOptions { normals: NormalWeights::Angle, ..exact_normals() };
    assert!(sphere_error("icosphere:2", None, printed_normals) > 5e-4);
    let printed_segments = SmoothingOptions { segments: SegmentLaw::AsPrinted, newton_steps: 0, ..exact_normals() };
    let [printed, ours] =
        [printed_segments, exact_normals()].map(|options| sphere_error("icosphere:1", Some(1.2), options));
    assert!(printed > 5.0 * ours, "{printed} and {ours}");
}

/// The largest kink between pieces of a chain, in degrees of the image.
fn largest_kink_deg(name: &str, viewpoint: Viewpoint, options: SmoothingOptions) -> f64 {
    let mut curves = SilhouetteCurves::default();
    shape(name, options).extract_curves(&viewpoint, &mut curves);
    let eye = Eye::from(viewpoint);
    let mut largest = 0.0_f64;
    for chain in curves.iter() {
        for (piece, next) in chain.pieces.iter().zip(chain.pieces.iter().cycle().skip(1)) {
            let toward = eye.toward(piece.point(1.0)).normalize();
            let flat = |direction: DVec3| (direction - direction.dot(toward) * toward).normalize_or_zero();
            let [a, b] = [piece.tangent(1.0), next.tangent(0.0)].map(|tangent| flat(tangent.unwrap()));
            let kink = a.cross(b).length().atan2(a.dot(b)).to_degrees();
            // Where a curve turns in depth, it has a cusp in the image.
            largest = largest.max(kink.min(180.0 - kink));
        }
    }
    largest
}

/// To 32 bits in parallel projection, and with Newton's method also from a near eye.
#[test]
fn chains_have_no_kink_in_the_image_and_by_the_printed_law_they_do() {
    let parallel = Viewpoint::Orthographic { toward_viewer: DVec3::new(0.3, 0.9, 0.2).as_vec3() };
    for name in ["icosphere:1", "torus:24,12"] {
        let kink = largest_kink_deg(name, parallel, exact_normals());
        assert!(kink < 0.01, "{name}: {kink} degrees");
    }
    let near = Viewpoint::Perspective { eye: DVec3::new(0.5, 0.6, 0.9).as_vec3() };
    let kinks = [8, 0].map(|newton_steps| {
        largest_kink_deg("icosphere:1", near, SmoothingOptions { newton_steps, ..exact_normals() })
    });
    assert!(kinks[0] < 0.1 && kinks[1] > 5.0 * kinks[0], "{kinks:?} degrees");
}

/// The hole and the outer circle of a torus that is seen along its axis: the smallest and the largest radius that some triangle
/// covers, in each of many directions.
fn radii_along_axis(mesh: &ViewMesh) -> [(f64, f64); 2] {
    let axis = DVec2::new;
    let (mut inner, mut outer) = ((f64::INFINITY, 0.0_f64), (f64::INFINITY, 0.0_f64));
    for step in 0..360 {
        let (sine, cosine) = (f64::from(step).to_radians() + 1e-3).sin_cos();
        let ray = axis(cosine, sine);
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        for triangle in &mesh.triangles {
            let points = triangle.map(|vertex| mesh.positions[vertex as usize].as_dvec3());
            let flat = points.map(|p| axis(p.x, p.z));
            for i in 0..3 {
                let (a, b) = (flat[i], flat[(i + 1) % 3]);
                let (side_a, side_b) = (ray.perp_dot(a), ray.perp_dot(b));
                if side_a * side_b <= 0.0 && (side_a - side_b).abs() > 0.0 {
                    let radius = ray.dot(a.lerp(b, side_a / (side_a - side_b)));
                    if radius > 0.0 {
                        (least, most) = (least.min(radius), most.max(radius));
                    }
                }
            }
        }
        inner = (inner.0.min(least), inner.1.max(least));
        outer = (outer.0.min(most), outer.1.max(most));
    }
    [inner, outer]
}

#[test]
fn the_hole_of_a_torus_is_round_only_where_vertices_are_perturbed() {
    let torus = shapes::by_name("torus:24,12").unwrap();
    let camera = views::framed(&torus, DVec3::Y, Framing::Orthographic, [4096; 2]);
    let [lowered, off] = [Perturbation::Lowered, Perturbation::Off].map(|perturbation| {
        let mut out = ViewMesh::default();
        let options = SmoothingOptions { perturbation, tolerance_px: 0.25, ..exact_normals() };
        shape("torus:24,12", options).remesh(&SmoothingView::from_camera(&camera), &mut out);
        let [(hole, hole_most), (_, rim)] = radii_along_axis(&out);
        assert!((rim - 1.4).abs() < 1e-4 && (hole_most - 0.6).abs() < 2e-4, "{rim} and {hole_most}");
        0.6 - hole
    });
    assert!(lowered < 2e-4 && off > 5e-3, "{lowered} with, {off} without");
}
