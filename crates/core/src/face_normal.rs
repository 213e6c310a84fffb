//! The normal of a face.

use glam::{DVec3, Vec3};

/// The unit normal of a triangle, on the side from which its corners run counter-clockwise. `None` without an area.
pub fn face_normal(corners: [Vec3; 3]) -> Option<DVec3> {
    let [a, b, c] = corners.map(Vec3::as_dvec3);
    (b - a).cross(c - a).try_normalize()
}
