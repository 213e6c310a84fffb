//! Step 5: where a stroke passes through a face.

use crate::crossing::{Event, root};
use crate::layers::Layers;
use silhouette_core::glam::Vec3;
use silhouette_core::orientation::{orientation, turn};
use silhouette_core::{Facing, Viewpoint};

/// Where a segment passes through a face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Passage {
    /// Parameter along the segment.
    pub t: f64,
    /// Bound of its rounding error.
    pub doubt: f64,
    /// Whether the segment leaves towards the face's outer side.
    pub outward: bool,
    /// Whether it passes exactly through the face's rim.
    pub through_rim: bool,
}

/// Where a segment passes through a face on which neither of its ends lies, if it does. Exact. O(1).
pub fn passage([a, b]: [Vec3; 2], [u, v, w]: [Vec3; 3]) -> Option<Passage> {
    let (above_a, above_b) = (orientation(u, v, w, a), orientation(u, v, w, b));
    if !(above_a < 0.0 && above_b > 0.0 || above_a > 0.0 && above_b < 0.0) {
        return None;
    }
    let around = [orientation(a, b, u, v), orientation(a, b, v, w), orientation(a, b, w, u)];
    let passes_inside = |sign: f64| around.iter().all(|&value| value * sign >= 0.0);
    if !passes_inside(1.0) && !passes_inside(-1.0) {
        return None;
    }
    let (t, doubt) = root([above_a, above_b]);
    Some(Passage { t, doubt, outward: above_b > 0.0, through_rim: around.contains(&0.0) })
}

/// What changes in front of a stroke where it passes through a face of this facing. Through its rim, that depends on the
/// face's neighbours and is not known. O(1).
pub fn piercing(passage: Passage, facing: Facing) -> Event {
    let Passage { t, doubt, outward, through_rim } = passage;
    // The viewer is on the outer side of a front face and on the inner side of a back face.
    let away_from_viewer = outward != (facing == Facing::Front);
    let change = Layers::of(facing).times(if away_from_viewer { 1 } else { -1 });
    Event { t, doubt, change: (!through_rim).then_some(change) }
}

/// Whether a point lies in the plane of a face and not certainly outside of it. A superset: a point in the plane beside a
/// corner may count.
pub fn touches(point: Vec3, corners: [Vec3; 3]) -> bool {
    let [u, v, w] = corners;
    let (low, high) = (u.min(v).min(w), u.max(v).max(w));
    point.cmpge(low).all() && point.cmple(high).all() && orientation(u, v, w, point) == 0.0
}

/// Whether a point lies on a face that has an area: in its plane, and seen along some axis, not beyond any side. Exact.
pub fn holds([a, b, c]: [Vec3; 3], point: Vec3) -> bool {
    orientation(a, b, c, point) == 0.0
        && [Vec3::X, Vec3::Y, Vec3::Z].into_iter().any(|axis| {
            let along = |p, q, r| turn(&Viewpoint::Orthographic { toward_viewer: axis }, p, q, r);
            let area = along(a, b, c);
            area != 0.0
                && [along(a, b, point), along(b, c, point), along(c, a, point)].iter().all(|side| side * area >= 0.0)
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_face_is_pierced_towards_its_far_side() {
        let [u, v, w] = [Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, -1.0, 0.0), Vec3::new(0.0, 1.0, 0.0)];
        let pierce = |ends: [Vec3; 2], corners, facing| passage(ends, corners).map(|at| piercing(at, facing));
        let inward = [Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.0, 0.0, -3.0)];
        let event = pierce(inward, [u, v, w], Facing::Front).unwrap();
        assert!((event.t - 0.25).abs() <= event.doubt);
        assert_eq!(event.change, Some(Layers { front: 1, back: 0 }));
        assert_eq!(pierce(inward, [u, w, v], Facing::Back).unwrap().change, Some(Layers { front: 0, back: 1 }));
        let outward = [inward[1], inward[0]];
        assert_eq!(pierce(outward, [u, v, w], Facing::Front).unwrap().change, Some(Layers { front: -1, back: 0 }));
        assert_eq!(pierce(inward.map(|end| end + 2.0 * Vec3::X), [u, v, w], Facing::Front), None, "beside it");
        let through_rim = pierce(inward.map(|end| end - Vec3::Y), [u, v, w], Facing::Front).unwrap();
        assert_eq!(through_rim.change, None, "through the rim");
        assert_eq!(pierce([Vec3::Z, Vec3::ZERO], [u, v, w], Facing::Front), None, "it only touches");
    }

    #[test]
    fn a_point_on_a_face_is_held_and_one_beside_it_is_not() {
        let face = [Vec3::ZERO, Vec3::X, Vec3::new(0.3, 1.0, 0.0)];
        for on in [face[0], face[1], Vec3::new(0.5, 0.0, 0.0), Vec3::new(0.4, 0.3, 0.0)] {
            assert!(holds(face, on), "{on}");
        }
        for beside in [Vec3::new(0.4, 0.3, 1e-30), Vec3::new(1.0, 1.0, 0.0), Vec3::new(0.0, 1e-30, 0.0), Vec3::NEG_X] {
            assert!(!holds(face, beside), "{beside}");
        }
        assert!(!holds([face[0], face[1], face[1]], Vec3::new(0.5, 0.0, 0.0)), "without area");
    }
}
