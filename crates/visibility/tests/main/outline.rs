//! The outermost outline against the picture of all faces.

use crate::scenes::{builtin, directions, framing, look, model};
use silhouette_core::glam::{DVec2, DVec3, Vec3};
use silhouette_core::{Camera, NoProgress, PreparedMesh, TriangleMesh};
use silhouette_visibility::{LineFinder, LineOptions, LineScene};
use std::sync::Arc;

fn outline(mesh: &TriangleMesh, camera: &Camera) -> Vec<Vec<DVec2>> {
    let scene = LineScene::new(Arc::new(PreparedMesh::new(mesh.clone())));
    let options = LineOptions { outline: true, ..LineOptions::default() };
    LineFinder::new(scene, &NoProgress).unwrap().find(camera, &options, &NoProgress).unwrap().outline
}

/// Edges of all polygons.
fn edges(polygons: &[Vec<DVec2>]) -> impl Iterator<Item = [DVec2; 2]> + '_ {
    polygons.iter().flat_map(|polygon| (0..polygon.len()).map(|at| [polygon[at], polygon[(at + 1) % polygon.len()]]))
}

/// Whether a point is inside by the even-odd rule; `None` within 0.01 px of an edge.
fn is_inside(polygons: &[Vec<DVec2>], point: DVec2) -> Option<bool> {
    let mut inside = false;
    for [a, b] in edges(polygons) {
        let along = b - a;
        let share = ((point - a).dot(along) / along.length_squared().max(1e-300)).clamp(0.0, 1.0);
        if a.lerp(b, share).distance(point) < 0.01 {
            return None;
        }
        if (a.y > point.y) != (b.y > point.y) && point.x < a.x + (point.y - a.y) / along.y * along.x {
            inside = !inside;
        }
    }
    Some(inside)
}

fn is_covered(triangles: &[[DVec2; 3]], point: DVec2) -> bool {
    triangles.iter().any(|&[a, b, c]| {
        let sides = [(b - a).perp_dot(point - a), (c - b).perp_dot(point - b), (a - c).perp_dot(point - c)];
        sides.iter().all(|&side| side > 0.0) || sides.iter().all(|&side| side < 0.0)
    })
}

/// Compares on a grid of points; yields how many lie inside.
fn check(name: &str, mesh: &TriangleMesh, camera: &Camera) -> usize {
    let polygons = outline(mesh, camera);
    let pixel = |vertex: u32| camera.project(mesh.positions()[vertex as usize].as_dvec3()).unwrap().pixel;
    let triangles: Vec<[DVec2; 3]> = mesh.triangles().iter().map(|corners| corners.map(pixel)).collect();
    let (mut compared, mut inside_count) = (0, 0);
    for row in 0..24 {
        for column in 0..24 {
            let point = DVec2::new(f64::from(column) * 42.7 + 13.1, f64::from(row) * 42.7 + 11.7);
            if let Some(inside) = is_inside(&polygons, point) {
                assert_eq!(inside, is_covered(&triangles, point), "{name} at {point}");
                compared += 1;
                inside_count += usize::from(inside);
            }
        }
    }
    assert!(compared > 500, "{name}: {compared}");
    inside_count
}

#[test]
fn the_outline_bounds_what_is_covered() {
    for name in ["cube", "icosphere:3", "torus:48,24", "knot", "gear", "blob:3000", "moebius", "grid", "cone"] {
        let mesh = builtin(name);
        for (index, direction) in directions(5).enumerate() {
            let inside = check(name, &mesh, &framing(&mesh, direction, index % 2 == 0));
            assert!(inside > 10, "{name} from {direction}: {inside}");
        }
    }
    for name in ["cow.obj", "spot.obj", "teapot.obj", "stanford-bunny.obj"] {
        if let Some(mesh) = model(name) {
            check(name, &mesh, &framing(&mesh, DVec3::new(0.55, 0.35, 1.0), true));
        }
    }
}

#[test]
fn a_torus_seen_along_its_axis_has_a_hole() {
    let mesh = builtin("torus:64,32");
    let [along_axis, across] =
        [DVec3::Y, DVec3::X].map(|direction| outline(&mesh, &framing(&mesh, direction, true)).len());
    let other = outline(&mesh, &framing(&mesh, DVec3::Z, true)).len();
    let mut polygons = [along_axis, across, other];
    polygons.sort_unstable();
    assert_eq!(polygons, [1, 1, 2], "one of three axes looks through the hole");
}

/// The comparison can fail: the outline of another view does not bound what is covered.
#[test]
fn the_outline_of_another_view_is_seen_to_be_wrong() {
    let mesh = builtin("gear");
    let (camera, other) = (framing(&mesh, DVec3::ONE, true), framing(&mesh, DVec3::new(1.0, 0.1, -0.2), true));
    let polygons = outline(&mesh, &other);
    let pixel = |vertex: u32| camera.project(mesh.positions()[vertex as usize].as_dvec3()).unwrap().pixel;
    let triangles: Vec<[DVec2; 3]> = mesh.triangles().iter().map(|corners| corners.map(pixel)).collect();
    let points = (0..400).map(|index| DVec2::new(f64::from(index % 20), f64::from(index / 20)) * 51.2 + 3.3);
    let wrong = points
        .filter(|&point| is_inside(&polygons, point).is_some_and(|inside| inside != is_covered(&triangles, point)));
    assert!(wrong.count() > 20);
}

/// Two faces that share an edge with an end at the eye, one of them without area.
#[test]
fn a_contour_through_the_eye_leaves_the_outline_finite() {
    let eye = Vec3::NEG_Z;
    let corners = vec![Vec3::new(0.0, -2.0, -2.0), Vec3::new(0.0, 2.0, 0.0), eye, Vec3::new(-1.0, -2.0, 0.0)];
    let mesh = TriangleMesh::new(corners, vec![[2, 0, 1], [2, 1, 3]]).unwrap();
    let polygons = outline(&mesh, &look(eye, Vec3::ZERO, 60.0, [640, 480]));
    assert!(polygons.iter().flatten().all(|corner| corner.is_finite()), "{polygons:?}");
}
