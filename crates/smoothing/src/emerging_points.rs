//! Beside section III-D, and not in the paper: silhouette points that move continuously from view to view.
//!
//! Seen from an eye, a bridge may cross the contour twice although both of its ends are invisible; it has no silhouette point then.
//! When one end turns visible, one of the crossings vanishes in that end and the other stays where it is. Eq. 7 puts the new point
//! there, away from the end, and the outline jumps. The same happens with visible and invisible exchanged.
//!
//! Two steps avoid this, in perspective only; parallel projection does not need them.
//!
//! 1. u / (1 - u) stays within a factor [`MOST_UNEVEN`] of the ratio of N . D at both ends ([`evened`]), which is its value in parallel
//!    projection. So a point reaches an end just as that end turns perpendicular to the view, along whichever bridge, and the
//!    segments on both sides of that moment have the same ends.
//! 2. Where this keeps a point away from the crossing, the contour passes beside the bridge, and the point is moved there
//!    ([`beside_bridge`]). All faces at the side have the moved point, so the surface stays closed. On a feature edge, points stay on
//!    its curve.
//!
//! A point for each of the two crossings would be no remedy. As soon as the contour touched a side, two segments through the point of
//! contact would replace one that passes it at some distance, and the outline would jump there.

use crate::eye::Eye;
use crate::silhouette_points::{Bridge, SilhouettePoint};
use silhouette_core::glam::DVec3;

/// How many times u / (1 - u) of a silhouette point may be its value in parallel projection, or the other way around. At least 1;
/// the lower it is, the slower points emerge, and the more of them lie beside their bridges.
pub const MOST_UNEVEN: f64 = 2.0;

/// How far from its bridge a point may lie, as a share of the chord. On a sphere of 80 faces seen from 1.2 radii they need 0.1.
pub const MOST_BESIDE: f64 = 0.25;

/// The parameter closest to `u` at which a silhouette point may lie, given N . D at both ends, of which one is negative; `None` if it
/// may lie at `u`.
#[inline]
pub fn evened(u: f64, signs: [f64; 2]) -> Option<f64> {
    let [from, to] = signs.map(f64::abs);
    if to * u > MOST_UNEVEN * from * (1.0 - u) {
        Some(MOST_UNEVEN * from / (MOST_UNEVEN * from + to))
    } else if from * (1.0 - u) > MOST_UNEVEN * to * u {
        Some(from / (from + MOST_UNEVEN * to))
    } else {
        None
    }
}

/// The point of the contour beside the point of a bridge with a parameter, given the vertices below its ends with their unit normals.
///
/// The surface there is taken for a sphere that turns between these normals along the chord. Where it turns inwards, nothing is known
/// of how it turns towards the viewer; the point stays on the bridge, and so it does on feature edges. O(1).
pub fn beside_bridge<B: Bridge>(
    u: f64,
    positions: [DVec3; 2],
    normals: [DVec3; 2],
    bridge: &B,
    eye: Eye,
) -> SilhouettePoint {
    let mut position = bridge.point(u);
    let normal = normals[0].lerp(normals[1], u).normalize_or_zero();
    let turned = across_view(normal, eye.toward(position));
    let (chord, turn) = (positions[1] - positions[0], normals[1] - normals[0]);
    let bend = chord.dot(turn);
    if !B::IS_SHARP && bend > 0.0 {
        let way = bend / turn.length_squared() * (turned - normal);
        position += way.clamp_length_max(MOST_BESIDE * chord.length());
    }
    SilhouettePoint { u, position, normal: across_view(turned, eye.toward(position)) }
}

/// The unit vector across a view that is closest to a normal; zero where the normal runs along the view.
fn across_view(normal: DVec3, toward: DVec3) -> DVec3 {
    let view = toward.normalize_or_zero();
    (normal - normal.dot(view) * view).normalize_or_zero()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bridges::bridge;
    use crate::silhouette_points::silhouette_point;
    use proptest::prelude::*;

    /// Two points of the unit sphere.
    fn ends() -> [DVec3; 2] {
        [DVec3::X, DVec3::new(0.85, 0.5, 0.0).normalize()]
    }

    /// An eye at 1.2 radii for which N . D has some value at the first end, and the contour runs close to the second.
    fn eye_near([first, second]: [DVec3; 2], value: f64) -> Eye {
        let toward = second.reject_from_normalized(first).normalize();
        let around = toward.cross(first).lerp(toward, 0.12).normalize();
        let height = 1.0 + value;
        Eye::new((height * first + (1.2_f64.powi(2) - height.powi(2)).sqrt() * around).extend(1.0))
    }

    fn point(ends: [DVec3; 2], eye: Eye, newton_steps: u32) -> SilhouettePoint {
        silhouette_point(ends, ends, &bridge(ends, ends), eye, newton_steps)
    }

    #[test]
    fn points_emerge_from_an_end_that_turns_visible_and_by_the_printed_law_they_appear_away_from_it() {
        let ends = ends();
        let turning = |newton_steps| point(ends, eye_near(ends, 1e-9), newton_steps).u;
        assert!(turning(3) < 1e-6 && turning(0) > 0.2, "{} and {}", turning(3), turning(0));
    }

    #[test]
    fn points_beside_a_bridge_are_on_the_contour_of_a_sphere() {
        let ends = ends();
        let mut beside = 0;
        for value in (1..200).map(|i| f64::from(i) * 1e-4) {
            let eye = eye_near(ends, value);
            let point = point(ends, eye, 8);
            assert!(point.normal.dot(eye.toward(point.position).normalize()).abs() < 1e-6);
            // The contour is a circle at this distance from the plane through the middle.
            let (view, height) = (eye.position().unwrap() / 1.2, 1.0 / 1.2);
            assert!((point.position.length() - 1.0).abs() < 1e-4 && (point.position.dot(view) - height).abs() < 1e-3);
            beside += usize::from(point.position.distance(bridge(ends, ends).point(point.u)) > 1e-3);
        }
        assert!(beside > 20, "{beside} beside the bridge");
    }

    #[test]
    fn a_surface_that_turns_inwards_and_a_normal_along_the_view_leave_points_on_the_bridge() {
        let ends = ends();
        let inwards = ends.map(|end| -end);
        let eye = eye_near(ends, 0.01);
        let curve = bridge(ends, inwards);
        assert_eq!(beside_bridge(0.3, ends, inwards, &curve, eye).position, curve.point(0.3));
        let along = Eye::new((9.0 * DVec3::X).extend(1.0));
        let straight = bridge([DVec3::ZERO, DVec3::Y], [DVec3::X; 2]);
        let found = beside_bridge(0.0, [DVec3::ZERO, DVec3::Y], [DVec3::X; 2], &straight, along);
        assert_eq!((found.position, found.normal), (DVec3::ZERO, DVec3::ZERO));
    }

    proptest! {
        /// In parallel projection u / (1 - u) is the ratio at the ends, and stays.
        #[test]
        fn uneven_parameters_move_to_the_limit(from in 0.0..1.0_f64, to in 0.0..1.0_f64, u in 0.0..=1.0_f64) {
            let signs = [from, -to];
            if from + to > 1e-9 {
                prop_assert!(evened(from / (from + to), signs).is_none());
            }
            if let Some(even) = evened(u, signs) {
                let [a, b] = [to * even, from * (1.0 - even)];
                prop_assert!((0.0..=1.0).contains(&even) && (a.max(b) - MOST_UNEVEN * a.min(b)).abs() < 1e-9);
                let backwards = evened(1.0 - u, [-to, from]);
                prop_assert!(backwards.is_some_and(|backwards| (backwards - (1.0 - even)).abs() < 1e-12));
            }
        }
    }
}
