//! Step 4: where edges cross in the picture, and which of them is nearer.
//!
//! With the viewer P, the cones over the segments ab and pq cross iff p and q lie on different sides of the plane Pab, a and b
//! on different sides of Ppq, and the two intersections are on the same ray from P rather than on opposite ones, which the
//! signs decide together: the side on which b lies of pq is the side on which p lies of ab. The segment pq is the nearer one
//! iff the tetrahedron abpq is wound accordingly. All of these are signs of determinants, exact as the displaced viewer sees
//! them.
//!
//! # Ties
//!
//! What the displaced viewer leaves undecided touches in space. A stroke there is taken to be moved infinitesimally towards
//! [its surface](crate::surface): a vertex on the stroke's line lies on the other side. Where a stroke ends on the line of a
//! contour there is no crossing within it, and where it crosses a contour in space, what lies beyond is not known of the
//! contour alone: such an event begins a new span, which a line of sight decides.

use crate::layers::Layers;
use silhouette_core::DisplacedViewer;
use silhouette_core::displaced::{Turn, of_one_power};
use silhouette_core::glam::Vec3;
use silhouette_core::orientation::{RELATIVE_ERROR, orientation};

/// A place along a stroke where the layers in front of it may change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// Parameter along the stroke, between 0 and 1.
    pub t: f64,
    /// Bound of the rounding error of `t`.
    pub doubt: f64,
    /// What is added beyond it, going from the first end to the second; `None` where that is not known.
    pub change: Option<Layers>,
}

/// Where an affine function vanishes that is `at_a` at parameter 0 and `at_b` at 1, these being of opposite signs, or 0, and
/// within [`RELATIVE_ERROR`] of the truth. Nothing cancels in the difference, so the result is as good, relatively.
pub fn root([at_a, at_b]: [f64; 2]) -> (f64, f64) {
    let t = at_a / (at_a - at_b);
    (t, 4.0 * RELATIVE_ERROR * t * (1.0 - t) + f64::EPSILON)
}

/// A segment that may be crossed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossed {
    /// Its ends.
    pub ends: [Vec3; 2],
    /// Change of layers on crossing it towards the left, looking from the first end to the second.
    pub to_the_left: Layers,
}

/// How two segments cross in the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// Of either segment, how the other's line turns at its first end and at its second.
    turns: [[Turn; 2]; 2],
    /// Which segment is nearer to the viewer; `None` where they cross in space.
    pub nearer: Option<usize>,
}

impl Crossing {
    /// The event on segment `which`, if the other hides it there or that is not known.
    pub fn event(&self, which: usize, other: &Crossed) -> Option<Event> {
        if self.nearer == Some(which) {
            return None;
        }
        let [at_a, at_b] = self.turns[which];
        let (t, doubt) = root(of_one_power([at_a, at_b]));
        let change = self.nearer.map(|_| other.to_the_left.times(if at_b.sign() > 0 { 1 } else { -1 }));
        Some(Event { t, doubt, change })
    }
}

/// What is known of how two segments cross.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Meeting {
    /// They do not.
    Apart,
    /// They cross.
    Crossing(Crossing),
    /// Three of the four ends lie on one line: it depends on which of the two is the stroke.
    Touching,
}

/// How two segments meet in the picture. Exact. O(1).
#[inline]
pub fn meeting(viewer: &DisplacedViewer, [a, b]: [Vec3; 2], [p, q]: [Vec3; 2]) -> Meeting {
    let of_p = viewer.turn(a, b, p);
    let of_q = viewer.turn(a, b, q);
    let product = of_p.sign() * of_q.sign();
    if product > 0 {
        return Meeting::Apart;
    }
    let of_a = viewer.turn(p, q, a);
    let of_b = viewer.turn(p, q, b);
    if product == 0 || of_a.sign() * of_b.sign() == 0 {
        return Meeting::Touching;
    }
    if of_a.sign() == of_b.sign() || of_b.sign() != of_p.sign() {
        return Meeting::Apart;
    }
    let depth = orientation(a, b, p, q) * f64::from(of_p.sign());
    let nearer = if depth > 0.0 { Some(1) } else { (depth < 0.0).then_some(0) };
    Meeting::Crossing(Crossing { turns: [[of_a, of_b], [of_p, of_q]], nearer })
}

/// The event on a stroke from `a` to `b` where it crosses a contour that it touches, the stroke being moved infinitesimally
/// towards `surface`. Exact. O(1).
#[cold]
pub fn touching_event(
    viewer: &DisplacedViewer,
    [a, b]: [Vec3; 2],
    surface: Option<Vec3>,
    contour: &Crossed,
) -> Option<Event> {
    let [p, q] = contour.ends;
    let beyond = surface.map_or(-1, |apex| -viewer.turn(a, b, apex).sign());
    let side = |vertex: Vec3| match viewer.turn(a, b, vertex).sign() {
        0 => beyond,
        sign => sign,
    };
    let (of_a, of_b) = (viewer.turn(p, q, a), viewer.turn(p, q, b));
    let [side_p, side_q] = [p, q].map(side);
    if side_p == side_q || of_a.sign() * of_b.sign() >= 0 || of_b.sign() != side_p {
        return None;
    }
    let depth = orientation(a, b, p, q) * f64::from(side_p);
    if depth < 0.0 {
        return None;
    }
    let (t, doubt) = root(of_one_power([of_a, of_b]));
    let change = (depth > 0.0).then(|| contour.to_the_left.times(of_b.sign()));
    Some(Event { t, doubt, change })
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::Viewpoint;

    fn viewer() -> DisplacedViewer {
        DisplacedViewer::new(Viewpoint::Perspective { eye: Vec3::new(0.0, 0.0, 10.0) }, Vec3::ZERO)
    }

    fn contour(p: Vec3, q: Vec3) -> Crossed {
        Crossed { ends: [p, q], to_the_left: Layers { front: 1, back: 1 } }
    }

    /// The event on a stroke along x, whose surface is towards `surface`.
    fn cross(surface: Vec3, p: Vec3, q: Vec3) -> Option<Event> {
        let ends = [Vec3::new(-1.0, 0.0, 0.0), Vec3::new(3.0, 0.0, 0.0)];
        let other = contour(p, q);
        let either_way = [[0, 1], [1, 0]].map(|order| {
            let pair = [ends, other.ends];
            match meeting(&viewer(), pair[order[0]], pair[order[1]]) {
                Meeting::Apart => None,
                Meeting::Crossing(crossing) => crossing.event(order[0], &other),
                Meeting::Touching => touching_event(&viewer(), ends, Some(surface), &other),
            }
        });
        assert_eq!(either_way[0], either_way[1], "whichever comes first");
        either_way[0]
    }

    #[test]
    fn a_nearer_contour_is_crossed_in_both_directions() {
        // In front, running upwards: its left is towards -x, so going along +x leaves that side.
        let (p, q) = (Vec3::new(0.0, -1.0, 1.0), Vec3::new(0.0, 1.0, 1.0));
        let event = cross(Vec3::Y, p, q).unwrap();
        assert!((event.t - 0.25).abs() <= event.doubt);
        assert_eq!(event.change, Some(Layers { front: -1, back: -1 }));
        assert_eq!(cross(Vec3::Y, q, p).unwrap().change, Some(Layers { front: 1, back: 1 }));
        for behind in [-1.0, -30.0] {
            assert_eq!(cross(Vec3::Y, p.with_z(behind), q.with_z(behind)), None);
        }
        assert_eq!(cross(Vec3::Y, p.with_z(30.0), q.with_z(30.0)), None, "behind the eye");
    }

    #[test]
    fn what_crosses_in_space_is_not_known_beyond() {
        let event = cross(Vec3::Y, Vec3::new(1.0, -1.0, 0.0), Vec3::new(1.0, 1.0, 0.0)).unwrap();
        assert_eq!(event.change, None);
    }

    #[test]
    fn two_contours_that_meet_over_a_stroke_are_crossed_once() {
        let (low, middle, high) = (Vec3::new(0.0, -1.0, 1.0), Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.0, 1.0, 1.0));
        for surface in [Vec3::Y, Vec3::NEG_Y] {
            let crossed = [cross(surface, low, middle), cross(surface, middle, high)];
            assert_eq!(crossed.iter().flatten().count(), 1, "{crossed:?}");
            // Two that come from one side and return to it, and one that covers the stroke: never an odd number.
            let back = [cross(surface, low, middle), cross(surface, middle, low.with_x(-0.5))];
            assert!(back.iter().flatten().count().is_multiple_of(2), "{back:?}");
            assert_eq!(cross(surface, Vec3::new(-1.0, 0.0, 1.0), Vec3::new(3.0, 0.0, 1.0)), None);
        }
    }

    #[test]
    fn a_vertex_on_a_stroke_lies_away_from_its_surface() {
        // A contour from the middle of the stroke, upwards: crossed by a stroke that belongs to what is above it.
        let (middle, high) = (Vec3::new(1.0, 0.0, 0.0), Vec3::new(1.0, 1.0, 1.0));
        assert_eq!(cross(Vec3::NEG_Y, middle, high), None);
        let event = cross(Vec3::Y, middle, high).unwrap();
        assert!((event.t - 0.5).abs() <= event.doubt && event.change.is_none(), "{event:?}");
        // One that ends where the stroke does is not crossed within it.
        assert_eq!(cross(Vec3::Y, Vec3::new(-1.0, 0.0, 0.0), high), None);
    }
}
