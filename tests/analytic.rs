//! Mesh silhouettes against contours in closed form.

use crate::seen::look;
use glam::DVec3;
use silhouette_core::shapes::{AnalyticContour, Sphere};
use silhouette_core::{TriangleMesh, Viewpoint};
use silhouette_testing::directions::spread;
use silhouette_testing::edges::{edge_ends, longest_edge};
use silhouette_testing::views::seen_from;

/// Farthest distance from the mesh's silhouette vertices to the sphere's contour circle.
fn distance_to_circle(sphere: &Sphere, mesh: &TriangleMesh, viewpoint: &Viewpoint) -> f64 {
    let circle = sphere.contour(viewpoint)[0].polyline(4096);
    let seen = look(mesh, viewpoint);
    let vertices = seen.edges.iter().flat_map(|edge| edge_ends(mesh, &seen.topology, edge));
    let to_circle = |p: DVec3| circle.iter().map(|c| c.distance(p)).fold(f64::INFINITY, f64::min);
    vertices.map(to_circle).fold(0.0, f64::max)
}

/// How far silhouette vertices may stray from the circle, in longest edges.
///
/// A vertex belongs to the silhouette if the contour separates the circumcentres of the faces around it, which on a flat
/// lattice of equilateral triangles lie within `1 / sqrt(3)` edges of it. That much is derived. The allowance for curvature
/// is not: 0.005 and 0.3 were chosen above the largest distances measured on levels 2 to 5, which `docs/ERRATA.md` lists.
fn stray_bound(longest_edge: f64, radius: f64) -> f64 {
    1.0 / 3.0_f64.sqrt() + 0.005 + 0.3 * longest_edge / radius
}

#[test]
fn icospheres_stay_within_an_edge_and_a_fraction_of_the_circle() {
    let sphere = Sphere::default();
    for level in 2..=5 {
        let mesh = sphere.icosphere(level).unwrap();
        let longest = longest_edge(&mesh);
        let bound = stray_bound(longest, sphere.radius) * longest;
        for (index, direction) in spread(24).map(DVec3::as_vec3).enumerate() {
            let eye = direction * [1.3_f32, 3.0, 40.0][index % 3] * sphere.radius as f32;
            for viewpoint in [seen_from(eye), Viewpoint::Orthographic { toward_viewer: direction }] {
                let distance = distance_to_circle(&sphere, &mesh, &viewpoint);
                assert!(distance <= bound, "level {level} from {viewpoint:?}: {distance} > {bound}");
            }
        }
    }
}

/// The comparison notices another circle.
#[test]
fn the_circle_of_a_nearer_eye_is_too_far_away() {
    let sphere = Sphere::default();
    let mesh = sphere.icosphere(4).unwrap();
    let at_radii = |radii: f64| seen_from((DVec3::new(0.3, 0.8, 0.5).normalize() * (radii * sphere.radius)).as_vec3());
    let circle = sphere.contour(&at_radii(1.5))[0].polyline(4096);
    let seen = look(&mesh, &at_radii(30.0));
    let [p, _] = edge_ends(&mesh, &seen.topology, seen.edges.as_slice()[0]);
    let distance = circle.iter().map(|c| c.distance(p)).fold(f64::INFINITY, f64::min);
    let longest = longest_edge(&mesh);
    assert!(distance > 2.0 * stray_bound(longest, sphere.radius) * longest);
}
