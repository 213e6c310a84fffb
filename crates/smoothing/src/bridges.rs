//! Section III-C: over a side of a silhouette triangle, a Hermite curve that lies in the tangent planes at both ends. Silhouette
//! segments are made by the same recipe.

use crate::hermite::Hermite;
use silhouette_core::glam::DVec3;

/// The curve between two points with unit normals, whose tangents are the chord less its part along each normal (Eqs. 2 and 3),
/// as long as Eq. 4 says. Departure: where the normal runs along the chord, the tangent is the chord.
#[inline]
pub fn bridge(ends: [DVec3; 2], normals: [DVec3; 2]) -> Hermite {
    let chord = ends[1] - ends[0];
    let along = |normal: DVec3| chord - chord.dot(normal) * normal;
    Hermite::along(ends, [along(normals[0]), along(normals[1])])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_meets_its_ends_and_lies_in_their_tangent_planes() {
        let ends = [DVec3::new(0.2, -1.0, 3.0), DVec3::new(1.5, 0.4, 2.0)];
        let normals = [DVec3::new(0.3, 0.9, 0.1), DVec3::new(-0.2, 0.8, 0.7)].map(DVec3::normalize);
        let bridge = bridge(ends, normals);
        assert_eq!([bridge.point(0.0), bridge.point(1.0)], ends);
        for (u, normal) in [0.0, 1.0].into_iter().zip(normals) {
            assert!(bridge.derivative(u).dot(normal).abs() < 1e-12);
        }
    }

    #[test]
    fn between_points_of_a_sphere_it_follows_the_great_circle() {
        let ends = [DVec3::new(1.0, 0.2, 0.0).normalize(), DVec3::new(0.7, 0.6, 0.3).normalize()];
        let bridge = bridge(ends, ends);
        for i in 0..=20 {
            assert!((bridge.point(f64::from(i) / 20.0).length() - 1.0).abs() < 1e-4);
        }
    }

    #[test]
    fn a_normal_along_the_chord_leaves_it_straight_there() {
        let bridge = bridge([DVec3::ZERO, DVec3::X], [DVec3::X, DVec3::Y]);
        assert!(bridge.point(0.5).distance(DVec3::new(0.5, 0.0, 0.0)) < 1e-12);
    }
}
