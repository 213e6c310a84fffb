//! How far outlines of coarse spheres are from the circle, in radii of the sphere.

use crate::surfaces::{method, remesher, surface, view};
use silhouette_core::curves::SilhouetteCurves;
use silhouette_core::glam::{DVec2, DVec3, Vec3};
use silhouette_core::method::{ExtractsCurves, Method};
use silhouette_core::view::{Camera, Projection};
use silhouette_smoothing::ViewMesh;
use silhouette_smoothing::{BoundaryCurve, InterpolatedContours};
use silhouette_testing::{builtin, directions, prepare};
use std::f64::consts::TAU;

/// Distances of the eye in radii; in parallel without.
pub const DISTANCES: [Option<f32>; 3] = [None, Some(2.0), Some(1.2)];

/// A point in the image, the centre of the unit sphere in the middle: at distance 1 from the eye.
fn in_image(camera: &Camera, point: DVec3) -> DVec2 {
    let at = camera.view_matrix().transform_point3(point);
    if is_parallel(camera) { at.truncate() } else { at.truncate() / -at.z }
}

fn is_parallel(camera: &Camera) -> bool {
    matches!(camera.projection(), Projection::Orthographic { .. })
}

/// How far a sight line passes the centre of the unit sphere, which is 1 on its outline, from the distance in the image.
fn sight_radius(camera: &Camera, image: f64) -> f64 {
    if is_parallel(camera) { image } else { camera.eye().as_dvec3().length() * image / image.hypot(1.0) }
}

/// Largest difference from 1 of the sight radius of the outline of a surface, over all ways from the middle.
fn outline_error(surface: &ViewMesh, camera: &Camera) -> f64 {
    const WAYS: usize = 1440;
    let mut farthest = [0.0_f64; WAYS];
    let points: Vec<DVec2> = surface.positions.iter().map(|p| in_image(camera, p.as_dvec3())).collect();
    for triangle in &surface.triangles {
        for slot in 0..3 {
            let [a, b] = [slot, (slot + 1) % 3].map(|slot| points[triangle[slot] as usize]);
            // No edge of a coarse sphere's outline passes the middle; each spans less than half a turn.
            let from = a.y.atan2(a.x);
            let span = a.perp_dot(b).atan2(a.dot(b));
            let (low, high) = (from.min(from + span), from.max(from + span));
            let ways = |angle: f64| angle / TAU * WAYS as f64;
            for way in ways(low).ceil() as i64..=ways(high).floor() as i64 {
                let angle = way as f64 / WAYS as f64 * TAU;
                let along = DVec2::new(angle.cos(), angle.sin());
                let denominator = along.perp_dot(b - a);
                if denominator.abs() > 1e-12 {
                    let place = &mut farthest[way.rem_euclid(WAYS as i64) as usize];
                    *place = place.max(a.perp_dot(b - a) / denominator);
                }
            }
        }
    }
    farthest.iter().map(|radius| (sight_radius(camera, *radius) - 1.0).abs()).fold(0.0, f64::max)
}

/// The worst over directions.
fn worst_outline(method: &str, shape: &str, radii: Option<f32>, words: &[&str]) -> f64 {
    let mut remesher = remesher(method, &builtin(shape), words);
    let error = |direction: DVec3| {
        let (camera, view) = view(direction.as_vec3(), radii);
        let mut surface = ViewMesh::default();
        remesher.remesh(&view, &mut surface);
        outline_error(&surface, &camera)
    };
    directions::spread(60).map(error).fold(0.0, f64::max)
}

/// The weights that the expected errors of interpolated contours are known for.
const ANGLE: &str = "normals=angle";

/// Faces as they are: the error of the mesh itself.
const FLAT: [(&str, f64); 2] = [("icosphere:1", 0.0655), ("icosphere:2", 0.0176)];

#[test]
fn uniform_patches_come_closer_to_the_circle_than_the_faces() {
    for (shape, flat) in FLAT {
        for (method, share) in [("pn-triangles", 0.16), ("phong-tessellation", 0.40)] {
            let [faces, patches] =
                ["level=0", "level=3"].map(|level| worst_outline(method, shape, None, &[level, ANGLE]));
            assert!((faces - flat).abs() < 0.01 * flat, "{shape}: {faces}");
            assert!(patches < share * flat && patches > 0.1 * flat, "{method} {shape}: {patches}");
        }
    }
}

/// Largest difference from 1 of the sight radius of curves, over directions.
fn worst_curve<M: Method + ExtractsCurves>(shape: &str, radii: Option<f32>) -> f64 {
    let mut method: M = method(&prepare::prepared(builtin(shape)), &[ANGLE]);
    let mut curves = SilhouetteCurves::default();
    let mut worst = 0.0_f64;
    for direction in directions::spread(60) {
        let (camera, _) = view(direction.as_vec3(), radii);
        method.extract_curves(&camera.viewpoint(), &mut curves);
        assert!(!curves.is_empty());
        for piece in curves.pieces() {
            for step in 0..=40 {
                let image = in_image(&camera, piece.point(f64::from(step) / 40.0)).length();
                worst = worst.max((sight_radius(&camera, image) - 1.0).abs());
            }
        }
    }
    worst
}

#[test]
fn interpolated_contours_are_off_by_the_height_of_chords_and_more_from_close_by() {
    let expected = [("icosphere:1", [0.066, 0.069, 0.094]), ("icosphere:2", [0.018, 0.018, 0.019])];
    for (shape, errors) in expected {
        for (radii, error) in DISTANCES.into_iter().zip(errors) {
            let found = worst_curve::<InterpolatedContours>(shape, radii);
            assert!((found - error).abs() < 0.05 * error, "{shape} {radii:?}: {found}");
        }
    }
}

fn triangles(method: &str, shape: &str) -> usize {
    let view = view(Vec3::new(0.3, 0.2, 0.9), None).1;
    surface(&mut *remesher(method, &builtin(shape), &[]), &view).triangles.len()
}

#[test]
fn patches_near_the_silhouette_alone_give_the_outline_of_patches_everywhere() {
    for radii in DISTANCES {
        let [uniform, adaptive] =
            ["pn-triangles", "adaptive-refinement"].map(|method| worst_outline(method, "icosphere:2", radii, &[]));
        assert!(adaptive < 1.1 * uniform, "{radii:?}: {adaptive} against {uniform}");
    }
    let [uniform, adaptive] = ["pn-triangles", "adaptive-refinement"].map(|method| triangles(method, "icosphere:3"));
    // Faces seen at less than 25 degrees cover 0.42 of a sphere.
    assert!(5 * adaptive < 3 * uniform, "{adaptive} against {uniform}");
}

/// The silhouette edges of a sphere run to and fro about its contour, and a curve through their vertices does too.
#[test]
fn curves_through_the_vertices_of_silhouette_edges_gain_little_on_a_sphere() {
    for (shape, flat) in FLAT {
        for radii in DISTANCES {
            let curves = worst_curve::<BoundaryCurve>(shape, radii);
            let filled = worst_outline("boundary-curve", shape, radii, &[]);
            assert!((0.85 * flat..1.02 * flat).contains(&curves), "{shape} {radii:?}: {curves}");
            assert!(filled <= curves + 1e-3, "{shape} {radii:?}: {filled}");
        }
    }
}
