//! Whether a segment touches a triangle, decided exactly: any point in common counts, ends and rims included.

use robust::{Coord, Coord3D, orient2d, orient3d};
use silhouette_core::glam::{Vec2, Vec3};

/// Whether a segment and a triangle have a point in common. A segment may be a point. A triangle without area has no point
/// here: it consists of its sides, to be asked as segments. Exact. O(1).
pub fn touches([a, b]: [Vec3; 2], corners: [Vec3; 3]) -> bool {
    let [u, v, w] = corners;
    let (above_a, above_b) = (orientation(u, v, w, a), orientation(u, v, w, b));
    if above_a > 0.0 && above_b > 0.0 || above_a < 0.0 && above_b < 0.0 {
        return false;
    }
    if above_a == 0.0 && above_b == 0.0 {
        return Plane::of(corners).is_some_and(|plane| plane.touches([a, b], corners));
    }
    // The line meets the plane in one point, between the ends. It passes no side on the outside.
    let around = [orientation(a, b, u, v), orientation(a, b, v, w), orientation(a, b, w, u)];
    around.iter().all(|&side| side >= 0.0) || around.iter().all(|&side| side <= 0.0)
}

/// Whether two triangles have a point in common: if so, an edge of one has one with the other. Exact. O(1).
#[cfg(any(test, feature = "simplify"))]
pub fn faces_touch(one: [Vec3; 3], other: [Vec3; 3]) -> bool {
    let sides = |[a, b, c]: [Vec3; 3]| [[a, b], [b, c], [c, a]];
    // Mostly, all corners lie on one side.
    let is_apart = |[u, v, w]: [Vec3; 3], corners: [Vec3; 3]| {
        let heights = corners.map(|corner| orientation(u, v, w, corner));
        heights.iter().all(|&height| height > 0.0) || heights.iter().all(|&height| height < 0.0)
    };
    !is_apart(one, other)
        && !is_apart(other, one)
        && (sides(one).into_iter().any(|side| touches(side, other))
            || sides(other).into_iter().any(|side| touches(side, one)))
}

/// Whether a segment from a triangle's first corner has further points in common with it. Exact. O(1).
pub fn touches_beyond_corner(end: Vec3, corners: [Vec3; 3]) -> bool {
    let [u, v, w] = corners;
    orientation(u, v, w, end) == 0.0
        && Plane::of(corners).is_some_and(|plane| {
            let area = plane.turn(u, v, w);
            plane.turn(u, v, end) * area >= 0.0 && plane.turn(u, end, w) * area >= 0.0
        })
}

/// Above 0 where `d` lies on the side from which `a b c` runs counter-clockwise, 0 in their plane. Only its sign means something,
/// which is all that is asked here: faces in one plane are common in hulls, and signs take a fraction of the time of values.
fn orientation(a: Vec3, b: Vec3, c: Vec3, d: Vec3) -> f64 {
    let coord = |point: Vec3| Coord3D { x: point.x, y: point.y, z: point.z };
    -orient3d(coord(a), coord(b), coord(c), coord(d))
}

/// The plane of a triangle, looked at along an axis that it does not contain.
struct Plane(fn(Vec3) -> Vec2);

impl Plane {
    /// `None` for a triangle without area.
    fn of([u, v, w]: [Vec3; 3]) -> Option<Self> {
        let planes: [fn(Vec3) -> Vec2; 3] =
            [|point| Vec2::new(point.y, point.z), |point| Vec2::new(point.z, point.x), Vec3::truncate];
        planes.map(Self).into_iter().find(|plane| plane.turn(u, v, w) != 0.0)
    }

    /// Its sign is that of the turn from `a` to `b` to `c`.
    fn turn(&self, a: Vec3, b: Vec3, c: Vec3) -> f64 {
        let [a, b, c] = [a, b, c].map(self.0).map(|point| Coord { x: point.x, y: point.y });
        orient2d(a, b, c)
    }

    /// Whether segment and triangle, both in the plane, have a point in common.
    fn touches(&self, segment: [Vec3; 2], corners: [Vec3; 3]) -> bool {
        let [u, v, w] = corners;
        let sides = [[u, v], [v, w], [w, u]];
        let area = self.turn(u, v, w);
        let is_inside = sides.iter().all(|&[from, to]| self.turn(from, to, segment[0]) * area >= 0.0);
        is_inside || sides.into_iter().any(|side| self.meet(segment, side))
    }

    /// Whether two segments in the plane have a point in common.
    fn meet(&self, [a, b]: [Vec3; 2], [c, d]: [Vec3; 2]) -> bool {
        let (of_a, of_b) = (self.turn(c, d, a), self.turn(c, d, b));
        let (of_c, of_d) = (self.turn(a, b, c), self.turn(a, b, d));
        let is_apart = |x: f64, y: f64| x > 0.0 && y > 0.0 || x < 0.0 && y < 0.0;
        // On one line, the boxes decide.
        let overlap = a.min(b).cmple(c.max(d)).all() && c.min(d).cmple(a.max(b)).all();
        overlap && !is_apart(of_a, of_b) && !is_apart(of_c, of_d)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const CORNERS: [Vec3; 3] = [Vec3::ZERO, Vec3::new(4.0, 0.0, 0.0), Vec3::new(0.0, 4.0, 0.0)];

    fn meets(from: [f32; 3], to: [f32; 3]) -> bool {
        touches([from.into(), to.into()], CORNERS)
    }

    #[test]
    fn a_segment_through_the_inside_the_rim_or_a_corner_touches() {
        for [x, y] in [[1.0, 1.0], [2.0, 2.0], [0.0, 3.0], [4.0, 0.0]] {
            assert!(meets([x, y, -1.0], [x, y, 1.0]), "across at {x} {y}");
            assert!(meets([x, y, 0.0], [x, y, 1.0]), "it starts at {x} {y}");
            assert!(meets([x, y, 0.0], [x, y, 0.0]), "a point at {x} {y}");
            assert!(!meets([x, y, 1e-30], [x, y, 1.0]), "just above {x} {y}");
        }
        for [x, y] in [[2.0, 2.1], [-1e-30, 1.0], [5.0, 0.0]] {
            assert!(!meets([x, y, -1.0], [x, y, 1.0]), "beside at {x} {y}");
            assert!(!meets([x, y, 0.0], [x, y, 0.0]), "a point beside at {x} {y}");
        }
    }

    #[test]
    fn a_segment_in_the_plane_touches_where_it_meets_the_rim_or_lies_inside() {
        assert!(meets([1.0, 1.0, 0.0], [1.5, 1.0, 0.0]), "inside");
        assert!(meets([-1.0, 1.0, 0.0], [9.0, 1.0, 0.0]), "across");
        assert!(meets([-1.0, 4.0, 0.0], [3.0, 4.0, 0.0]), "at a corner");
        assert!(meets([3.0, 0.0, 0.0], [9.0, 0.0, 0.0]), "along a side");
        assert!(!meets([5.0, 0.0, 0.0], [9.0, 0.0, 0.0]), "on the line of a side");
        assert!(!meets([3.0, 3.0, 0.0], [9.0, 0.0, 0.0]), "beside");
    }

    #[test]
    fn a_segment_at_a_corner_goes_on_along_the_face_or_leaves_it() {
        let [u, v, w] = CORNERS;
        for (end, expected) in [
            (Vec3::new(1.0, 1.0, 0.0), true),
            (Vec3::new(9.0, 1.0, 0.0), true),
            (Vec3::new(9.0, 0.0, 0.0), true),
            (Vec3::new(9.0, -1.0, 0.0), false),
            (Vec3::new(-1.0, -1.0, 0.0), false),
            (Vec3::new(-1.0, 0.0, 0.0), false),
            (Vec3::new(1.0, 1.0, 1e-30), false),
        ] {
            assert_eq!(touches_beyond_corner(end, [u, v, w]), expected, "{end}");
            assert_eq!(touches_beyond_corner(end, [u, w, v]), expected, "{end}");
        }
    }

    /// Segment and triangle in integers: is there a common point? By clipping the segment, in fractions over one denominator.
    fn in_integers([a, b]: [[i64; 3]; 2], [u, v, w]: [[i64; 3]; 3]) -> bool {
        let minus = |p: [i64; 3], q: [i64; 3]| [0, 1, 2].map(|axis| p[axis] - q[axis]);
        let cross = |p: [i64; 3], q: [i64; 3]| {
            [0, 1, 2].map(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                p[j] * q[k] - p[k] * q[j]
            })
        };
        let dot = |p: [i64; 3], q: [i64; 3]| (0..3).map(|axis| p[axis] * q[axis]).sum::<i64>();
        let normal = cross(minus(v, u), minus(w, u));
        // Inside are all points at which these affine functions are 0 or more; on the plane, one is 0.
        let sides = [[u, v], [v, w], [w, u]].map(|[from, to]| {
            let inward = cross(normal, minus(to, from));
            [a, b].map(|end| dot(inward, minus(end, from)))
        });
        let height = [a, b].map(|end| dot(normal, minus(end, u)));
        let constraints = [sides[0], sides[1], sides[2], height, height.map(|value| -value)];
        // From t = low to t = high, as fractions.
        let (mut low, mut high) = ((0_i128, 1_i128), (1_i128, 1_i128));
        for [at_a, at_b] in constraints.map(|ends| ends.map(i128::from)) {
            let change = at_b - at_a;
            match change {
                0 if at_a < 0 => return false,
                0 => {}
                1.. if -at_a * low.1 > low.0 * change => low = (-at_a, change),
                ..0 if at_a * high.1 < -high.0 * change => high = (at_a, -change),
                _ => {}
            }
        }
        normal != [0; 3] && low.0 * high.1 <= high.0 * low.1
    }

    proptest! {
        /// On a small lattice, where touching, coplanar and degenerate cases are the rule.
        #[test]
        fn touching_is_what_integers_say(
            points in prop::array::uniform5(prop::array::uniform3(-3_i64..=3)), exponent in -80..80, offset in 0_i64..3,
        ) {
            let scale = 2.0_f32.powi(exponent);
            let place = |p: [i64; 3]| Vec3::from(p.map(|c| (c + offset * 1_000_000) as f32)) * scale;
            let [a, b, u, v, w] = points;
            let expected = in_integers([a, b], [u, v, w]);
            prop_assert_eq!(touches([place(a), place(b)], [u, v, w].map(place)), expected);
        }
    }
}
