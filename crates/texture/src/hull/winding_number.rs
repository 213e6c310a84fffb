//! How often a closed surface winds around a point: an exact count of its crossings by a ray.

use silhouette_core::FaceId;
use silhouette_core::TriangleMesh;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::orientation::orientation;
use silhouette_rays::MeshHierarchy;

/// Rays tried until one meets no edge.
const RAYS: u32 = 64;

/// How often the faces of `mesh` that `counts` names wind around a point that lies on none of them: 0 outside, 1 inside of a
/// surface wound counter-clockwise seen from outside. The faces must form closed surfaces. `None` if every ray tried meets an
/// edge, which takes a contrived mesh.
///
/// Exact. Expected O(log F + faces met).
pub fn winding_number(
    mesh: &TriangleMesh,
    hierarchy: &MeshHierarchy,
    point: Vec3,
    counts: impl Fn(FaceId) -> bool,
) -> Option<i64> {
    let Some(bounds) = mesh.bounds() else { return Some(0) };
    (0..RAYS).find_map(|ray| {
        // Beyond the box, in directions that fill the sphere evenly (a Fibonacci lattice).
        let height = 1.0 - (2.0 * f64::from(ray) + 1.0) / f64::from(RAYS);
        let (sin, cos) = (f64::from(ray) * 2.399_963_229_728_653 + 0.7).sin_cos();
        let across = (1.0 - height * height).sqrt();
        let far = bounds.center + DVec3::new(across * cos, across * sin, height) * (4.0 * bounds.radius);
        let limit = Vec3::splat(f32::MAX);
        let far = far.as_vec3().clamp(-limit, limit);
        along(hierarchy, point, far, &counts)
    })
}

/// The sum of crossings, outward ones counted 1; `None` if an edge or a plane is met.
fn along(hierarchy: &MeshHierarchy, point: Vec3, far: Vec3, counts: &impl Fn(FaceId) -> bool) -> Option<i64> {
    let mut sum = Some(0);
    hierarchy.near_segment([point, far], |face, [u, v, w]| {
        if !counts(face) {
            return;
        }
        let heights = [orientation(u, v, w, point), orientation(u, v, w, far)];
        if heights[0] > 0.0 && heights[1] > 0.0 || heights[0] < 0.0 && heights[1] < 0.0 {
            return;
        }
        let around = [orientation(point, far, u, v), orientation(point, far, v, w), orientation(point, far, w, u)];
        let is_beside = around.iter().any(|&side| side > 0.0) && around.iter().any(|&side| side < 0.0);
        let is_doubtful = heights.contains(&0.0) || around.contains(&0.0);
        if is_doubtful && !is_beside {
            sum = None;
        } else if !is_beside {
            let outward = if heights[0] < 0.0 { 1 } else { -1 };
            sum = sum.map(|sum| sum + outward);
        }
    });
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::shapes;
    use silhouette_testing::{edits, zoo};

    fn around(mesh: &TriangleMesh, point: Vec3) -> i64 {
        winding_number(mesh, &MeshHierarchy::new(mesh), point, |_| true).unwrap()
    }

    #[test]
    fn a_point_is_inside_once_twice_or_turned_around() {
        let ball = shapes::by_name("icosphere:2").unwrap();
        let small = edits::mapped(&ball, |position| position * 0.5);
        let nested = edits::joined(&[&ball, &small]);
        let hollow = edits::joined(&[&ball, &edits::inside_out(&small)]);
        for (mesh, at_center, between) in
            [(&ball, 1, 1), (&nested, 2, 1), (&hollow, 0, 1), (&edits::inside_out(&ball), -1, -1)]
        {
            assert_eq!(around(mesh, Vec3::ZERO), at_center);
            assert_eq!(around(mesh, Vec3::X * 0.7), between);
            assert_eq!(around(mesh, Vec3::X * 1.7), 0);
            assert_eq!(around(mesh, Vec3::splat(0.9)), 0);
        }
        assert_eq!(around(&zoo::empty(), Vec3::ZERO), 0);
    }

    /// Points on the axes of a lattice, which rays along axes would leave through edges.
    #[test]
    fn a_point_in_line_with_edges_is_inside() {
        let cube = shapes::by_name("cube").unwrap();
        for scale in [1e-9, 1.0, 1e9] {
            let far = edits::transformed(&cube, scale, DVec3::splat(1e5 * scale));
            let center = far.bounds().unwrap().center.as_vec3();
            assert_eq!(around(&far, center), 1);
            assert_eq!(around(&far, center + Vec3::X * 3.0 * scale as f32), 0);
        }
    }

    #[test]
    fn faces_that_do_not_count_are_left_out() {
        let ball = shapes::by_name("icosphere:2").unwrap();
        let nested = edits::joined(&[&ball, &edits::mapped(&ball, |position| position * 0.5)]);
        let of_first = |face: FaceId| face.index() < ball.face_count();
        assert_eq!(winding_number(&nested, &MeshHierarchy::new(&nested), Vec3::ZERO, of_first), Some(1));
    }
}
