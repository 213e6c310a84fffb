//! Whether the eye is inside of a closed mesh, without adjacency.
//!
//! The solid angles that the faces subtend at the eye, signed by facing, add up to 4 pi inside of a closed surface and to
//! 0 outside. Divided by 4 pi this is the winding number (Jacobson, Kavan and Sorkine-Hornung, "Robust inside-outside
//! segmentation using generalized winding numbers", SIGGRAPH 2013), which degrades gracefully on open meshes: half
//! enclosed is half a turn.

use silhouette_core::glam::DVec3;
use silhouette_core::mesh::{Bounds, TriangleMesh};
use silhouette_core::view::Viewpoint;

/// Whether the mesh surrounds the eye of this viewpoint, by more than half a turn. Never for an orthographic one, whose
/// eye is infinitely far. O(1) with the eye outside of `bounds`, O(F) within.
pub fn is_inside(mesh: &TriangleMesh, bounds: &Bounds, viewpoint: &Viewpoint) -> bool {
    let Viewpoint::Perspective { eye } = *viewpoint else { return false };
    let eye = eye.as_dvec3();
    let is_within = eye.cmpge(bounds.min).all() && eye.cmple(bounds.max).all();
    is_within && winding_number(mesh, eye).abs() > 0.5
}

/// Turns of the mesh around `eye`: 1 inside of a closed mesh with outward faces, 0 outside. O(F), summed in face order.
/// Each face's solid angle is A. van Oosterom and J. Strackee's, "The solid angle of a plane triangle", 1983.
pub fn winding_number(mesh: &TriangleMesh, eye: DVec3) -> f64 {
    let corner = |vertex: u32| mesh.positions()[vertex as usize].as_dvec3() - eye;
    let half_angles = mesh.triangles().iter().map(|triangle| {
        let [a, b, c] = triangle.map(corner);
        let [la, lb, lc] = [a.length(), b.length(), c.length()];
        let volume = a.dot(b.cross(c));
        volume.atan2(la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb)
    });
    half_angles.sum::<f64>() / std::f64::consts::TAU
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::Vec3;
    use silhouette_core::shapes::Cuboid;

    #[test]
    fn a_closed_mesh_winds_once_around_what_is_inside() {
        let cube = Cuboid::default().mesh().unwrap();
        for eye in [DVec3::ZERO, DVec3::new(0.9, -0.5, 0.99)] {
            assert!((winding_number(&cube, eye) - 1.0).abs() < 1e-12);
        }
        for eye in [DVec3::splat(1.01), DVec3::new(0.0, 5.0, 0.2)] {
            assert!(winding_number(&cube, eye).abs() < 1e-12);
        }
        let flipped = cube.triangles().iter().map(|&[a, b, c]| [a, c, b]).collect();
        let flipped = TriangleMesh::new(cube.positions().to_vec(), flipped).unwrap();
        assert!((winding_number(&flipped, DVec3::ZERO) + 1.0).abs() < 1e-12);
    }

    #[test]
    fn only_a_surrounded_eye_is_inside() {
        let cube = Cuboid::default().mesh().unwrap();
        let bounds = cube.bounds().unwrap();
        let inside = |mesh: &TriangleMesh, eye| is_inside(mesh, &bounds, &Viewpoint::Perspective { eye });
        assert!(inside(&cube, Vec3::ZERO) && !inside(&cube, Vec3::Z * 1.5));
        // A cube without its lid is still around its centre; one side alone is not.
        let part = |faces| TriangleMesh::new(cube.positions().to_vec(), cube.triangles()[..faces].to_vec()).unwrap();
        assert!(inside(&part(10), Vec3::ZERO) && !inside(&part(2), Vec3::ZERO));
        assert!(!is_inside(&cube, &bounds, &Viewpoint::Orthographic { toward_viewer: Vec3::Z }));
    }
}
