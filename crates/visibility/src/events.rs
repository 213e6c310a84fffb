//! Steps 4 and 5: where along a stroke the number of layers in front of it changes.
//!
//! A *sight line* runs from the viewer to a point of the stroke. Between two events no face starts or stops to cut it in
//! front of that point. There are two sorts: [crossings](crossing), where the projection of the stroke crosses that of a
//! contour that is nearer to the viewer, and [piercings](piercing), where the stroke passes through a face.
//!
//! # Ties
//!
//! The stroke is taken to be moved in the picture, by less than any number, towards its
//! [surface side](crate::stroke::Stroke::side). A contour vertex on the stroke's line then lies on the other side, and a
//! contour that covers the stroke is not crossed. What remains undecided is where the stroke touches a contour or the rim of a
//! face in space; such an event says that nothing is known of its far side.

use crate::contours::{Contour, Layers};
use crate::stroke::Stroke;
use silhouette_core::facing::judge;
use silhouette_core::glam::Vec3;
use silhouette_core::orientation::{RELATIVE_ERROR, orientation, turn};
use silhouette_core::{Facing, Viewpoint};

/// A place along a stroke where the layers in front of it may change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// Parameter along the stroke, strictly between 0 and 1 before rounding.
    pub t: f64,
    /// Bound of the rounding error of `t`.
    pub doubt: f64,
    /// What is added beyond it, going from the first end to the second; `None` where that is not known.
    pub change: Option<Layers>,
    /// The contour that is crossed, by its index; `None` for a piercing.
    pub contour: Option<u32>,
}

/// Where an affine function vanishes that is `at_a` at parameter 0 and `at_b` at 1, these being of opposite signs and
/// within [`RELATIVE_ERROR`] of the truth. Nothing cancels in the difference, so the result is as good, relatively.
fn root(at_a: f64, at_b: f64) -> (f64, f64) {
    let t = at_a / (at_a - at_b);
    (t, 4.0 * RELATIVE_ERROR * t * (1.0 - t) + f64::EPSILON)
}

/// The side of a stroke on which a contour's vertex lies, no vertex lying on the stroke itself: 1 or -1.
fn side_of(stroke: &Stroke, viewpoint: &Viewpoint, vertex: Vec3) -> i32 {
    let turn = turn(viewpoint, stroke.ends[0], stroke.ends[1], vertex);
    if turn > 0.0 {
        1
    } else if turn < 0.0 {
        -1
    } else {
        -i32::from(stroke.side)
    }
}

/// Which contours count as crossed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Depth {
    /// Those nearer to the viewer than the stroke.
    Nearer,
    /// All, whatever their depth.
    Any,
}

/// Where the projection of a stroke crosses that of a contour, if it does. Exact. O(1).
///
/// With the eye P, the cones over the segments ab and pq cross iff p and q lie on different sides of the plane Pab, a and b
/// on different sides of Ppq, and the two intersections are on the same ray from P rather than on opposite ones, which the
/// signs tell together: the side on which b lies of pq is the side on which p lies of ab. The contour is the nearer one iff
/// the tetrahedron abpq is wound accordingly.
pub fn crossing(stroke: &Stroke, viewpoint: &Viewpoint, index: u32, contour: &Contour, depth: Depth) -> Option<Event> {
    let [a, b] = stroke.ends;
    let [p, q] = contour.ends;
    let side_p = side_of(stroke, viewpoint, p);
    if side_p == side_of(stroke, viewpoint, q) {
        return None;
    }
    let (at_a, at_b) = (turn(viewpoint, p, q, a), turn(viewpoint, p, q, b));
    let toward_left = if at_a < 0.0 && at_b > 0.0 {
        1
    } else if at_a > 0.0 && at_b < 0.0 {
        -1
    } else {
        return None;
    };
    if toward_left != side_p {
        return None;
    }
    let mut change = Layers::default();
    change.add(contour.to_the_left, toward_left);
    let mut change = Some(change);
    if depth == Depth::Nearer {
        let nearer = orientation(a, b, p, q) * f64::from(side_p);
        if nearer < 0.0 {
            return None;
        }
        if nearer == 0.0 {
            change = None;
        }
    }
    let (t, doubt) = root(at_a, at_b);
    Some(Event { t, doubt, change, contour: Some(index) })
}

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
    let (t, doubt) = root(above_a, above_b);
    Some(Passage { t, doubt, outward: above_b > 0.0, through_rim: around.contains(&0.0) })
}

/// What changes in front of a stroke where it passes through a face. Exact. O(1).
pub fn piercing(passage: Passage, corners: [Vec3; 3], viewpoint: &Viewpoint) -> Event {
    let Passage { t, doubt, outward, through_rim } = passage;
    let facing = judge(corners, viewpoint).facing;
    // The viewer is on the outer side of a front face and on the inner side of a back face.
    let away_from_viewer = outward != (facing == Facing::Front);
    let mut change = Layers::default();
    change.add(Layers::of(facing), if away_from_viewer { 1 } else { -1 });
    Event { t, doubt, change: (!through_rim).then_some(change), contour: None }
}

/// Whether a point lies in the plane of a face and not certainly outside of it. A superset: a point in the plane beside a
/// corner may count.
pub fn touches(point: Vec3, corners: [Vec3; 3]) -> bool {
    let [u, v, w] = corners;
    let (low, high) = (u.min(v).min(w), u.max(v).max(w));
    point.cmpge(low).all() && point.cmple(high).all() && orientation(u, v, w, point) == 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chains::SegmentSource;
    use crate::kind::LineKind;
    use crate::stroke::NO_VERTEX;
    use silhouette_core::EdgeId;

    const VIEW: Viewpoint = Viewpoint::Perspective { eye: Vec3::new(0.0, 0.0, 10.0) };

    fn stroke(a: Vec3, b: Vec3, side: i8) -> Stroke {
        Stroke {
            ends: [a, b],
            vertices: [NO_VERTEX; 2],
            source: SegmentSource::Curve(0),
            kind: LineKind::Curve,
            object: 0,
            side,
            own: 0..0,
        }
    }

    fn contour(p: Vec3, q: Vec3) -> Contour {
        let to_the_left = Layers { front: 1, back: 1 };
        Contour { edge: EdgeId::new(0), vertices: [0, 1], ends: [p, q], to_the_left }
    }

    fn cross(stroke: &Stroke, p: Vec3, q: Vec3) -> Option<Event> {
        crossing(stroke, &VIEW, 0, &contour(p, q), Depth::Nearer)
    }

    #[test]
    fn a_nearer_contour_is_crossed_in_both_directions() {
        let along_x = stroke(Vec3::new(-1.0, 0.0, 0.0), Vec3::new(3.0, 0.0, 0.0), 1);
        // In front, running upwards: its left is towards -x, so going along +x leaves that side.
        let (p, q) = (Vec3::new(0.0, -1.0, 1.0), Vec3::new(0.0, 1.0, 1.0));
        let event = cross(&along_x, p, q).unwrap();
        assert!((event.t - 0.25).abs() <= event.doubt);
        assert_eq!(event.change, Some(Layers { front: -1, back: -1 }));
        assert_eq!(cross(&along_x, q, p).unwrap().change, Some(Layers { front: 1, back: 1 }));
        for behind in [-1.0, -30.0] {
            let (p, q) = (p.with_z(behind), q.with_z(behind));
            assert_eq!(cross(&along_x, p, q), None);
            assert!(crossing(&along_x, &VIEW, 0, &contour(p, q), Depth::Any).is_some());
        }
        assert_eq!(cross(&along_x, p.with_z(30.0), q.with_z(30.0)), None, "behind the eye");
    }

    #[test]
    fn touching_in_space_is_not_decided() {
        let along_x = stroke(Vec3::new(-1.0, 0.0, 0.0), Vec3::new(3.0, 0.0, 0.0), 1);
        let event = cross(&along_x, Vec3::new(1.0, -1.0, 0.0), Vec3::new(1.0, 1.0, 0.0)).unwrap();
        assert_eq!(event.change, None);
    }

    #[test]
    fn two_contours_that_meet_on_a_stroke_are_crossed_once() {
        let (a, b) = (Vec3::new(-1.0, 0.0, 0.0), Vec3::new(3.0, 0.0, 0.0));
        let (low, middle, high) = (Vec3::new(0.0, -1.0, 1.0), Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.0, 1.0, 1.0));
        for side in [-1, 1] {
            let stroke = stroke(a, b, side);
            let crossed = [cross(&stroke, low, middle), cross(&stroke, middle, high)];
            assert_eq!(crossed.iter().flatten().count(), 1, "{crossed:?}");
        }
        // Two that come from one side and return to it, and one that covers the stroke, on either side: never an odd number.
        for side in [-1, 1] {
            let stroke = stroke(a, b, side);
            let back = [cross(&stroke, low, middle), cross(&stroke, middle, low.with_x(-0.5))];
            assert!(back.iter().flatten().count().is_multiple_of(2), "{back:?}");
            assert_eq!(cross(&stroke, a.with_z(1.0), b.with_z(1.0) - a), None);
        }
    }

    #[test]
    fn a_face_is_pierced_towards_its_far_side() {
        let [u, v, w] = [Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, -1.0, 0.0), Vec3::new(0.0, 1.0, 0.0)];
        let pierce = |ends: [Vec3; 2], corners| passage(ends, corners).map(|at| piercing(at, corners, &VIEW));
        let inward = [Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.0, 0.0, -3.0)];
        let event = pierce(inward, [u, v, w]).unwrap();
        assert!((event.t - 0.25).abs() <= event.doubt);
        assert_eq!(event.change, Some(Layers { front: 1, back: 0 }));
        assert_eq!(pierce(inward, [u, w, v]).unwrap().change, Some(Layers { front: 0, back: 1 }));
        let outward = [inward[1], inward[0]];
        assert_eq!(pierce(outward, [u, v, w]).unwrap().change, Some(Layers { front: -1, back: 0 }));
        assert_eq!(pierce(inward.map(|end| end + 2.0 * Vec3::X), [u, v, w]), None, "beside it");
        assert_eq!(pierce(inward.map(|end| end - Vec3::Y), [u, v, w]).unwrap().change, None, "through the rim");
        assert_eq!(pierce([Vec3::Z, Vec3::ZERO], [u, v, w]), None, "it only touches");
    }
}
