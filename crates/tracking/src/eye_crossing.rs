//! Whether the eye may have crossed the surface between two frames, where tracking must not be trusted.
//!
//! New silhouettes come from concave edges only while the eye stays on its side of the surface: an eye that leaves a
//! convex body through a face sees a silhouette without any concave edge. The test is sound and cheap: where it says
//! no, the segment from eye to eye does not meet the surface. It says no if
//!
//! 1. neither the eye nor the mesh moved; or
//! 2. the segment misses the box around the mesh; or
//! 3. both eyes lie in a ball that is known to be clear of the surface. Such a ball is measured when the test has said
//!    yes for an eye inside the box, about that eye: O(F), at a time when brute force looks at every face anyway.
//!
//! An eye on the surface has no clear ball, so each of its moves is found by brute force.

use crate::faces::Surface;
use silhouette_core::glam::{DVec3, Vec3};

/// Share of coordinates and distances that is given away so that rounding in 64 bits cannot make the test unsound.
const ROUNDING: f64 = 1e-9;

/// A ball clear of the surface, if one is known.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ClearBall {
    ball: Option<(DVec3, f64)>,
    /// Whether the surface has moved since the last frame.
    has_moved: bool,
}

impl ClearBall {
    /// Whether the segment between two eyes may meet the surface inside `bounds`. O(1).
    pub fn may_have_crossed(&self, bounds: [DVec3; 2], before: Vec3, now: Vec3) -> bool {
        let (before, now) = (before.as_dvec3(), now.as_dvec3());
        (before != now || self.has_moved) && meets_box(bounds, before, now) && !(self.holds(before) && self.holds(now))
    }

    fn holds(&self, point: DVec3) -> bool {
        self.ball.is_some_and(|(center, radius)| point.distance(center) < radius)
    }

    /// Measures the ball about an eye: O(F) if the eye is inside `bounds`, O(1) otherwise, where no ball is needed.
    pub fn measure(&mut self, surface: &Surface, bounds: [DVec3; 2], eye: Vec3) {
        let eye = eye.as_dvec3();
        self.ball = meets_box(bounds, eye, eye).then(|| (eye, clearance(surface, eye)));
    }

    /// Forgets the ball: the surface has moved.
    pub fn forget(&mut self) {
        *self = Self { ball: None, has_moved: true };
    }

    /// Says that a frame has seen the surface where it is.
    pub fn see(&mut self) {
        self.has_moved = false;
    }
}

/// Whether a segment meets a box, widened by more than rounding can lose. True for what is not a number.
fn meets_box([min, max]: [DVec3; 2], from: DVec3, to: DVec3) -> bool {
    let slack = ROUNDING * (min.abs().max(max.abs()) + from.abs().max(to.abs()));
    let (min, max) = (min - slack, max + slack);
    let step = to - from;
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for axis in 0..3 {
        let (near, far) = (min[axis] - from[axis], max[axis] - from[axis]);
        if step[axis] == 0.0 {
            if near > 0.0 || far < 0.0 {
                return false;
            }
            continue;
        }
        let (a, b) = (near / step[axis], far / step[axis]);
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    // `max` and `min` pass over what is not a number, so that it meets the box.
    enter <= leave
}

/// A lower bound of the distance from a point to the surface.
fn clearance(surface: &Surface, point: DVec3) -> f64 {
    let corners = |triangle: &[u32; 3]| triangle.map(|vertex| surface.positions[vertex as usize].as_dvec3());
    let mut nearest = f64::INFINITY;
    for [a, b, c] in surface.triangles.iter().map(corners) {
        // Far enough for sure: farther from a corner than the ball and the longer side from there together.
        let reach = a.distance_squared(b).max(a.distance_squared(c)).sqrt();
        if point.distance(a) - reach >= nearest {
            continue;
        }
        nearest = nearest.min(distance_to_triangle(point, [a, b, c]));
    }
    let scale = point.abs().element_sum() + surface.table.center().abs().element_sum() + surface.table.radius();
    nearest * (1.0 - ROUNDING) - scale * ROUNDING
}

/// Distance from a point to a triangle: to the nearest of its sides, or to its plane where that is met inside.
fn distance_to_triangle(point: DVec3, corners: [DVec3; 3]) -> f64 {
    let [a, b, c] = corners;
    let normal = (b - a).cross(c - a);
    let sides = [[a, b], [b, c], [c, a]];
    let is_inside =
        normal != DVec3::ZERO && sides.iter().all(|[from, to]| (*to - *from).cross(point - *from).dot(normal) >= 0.0);
    if is_inside {
        // The smaller of two lower bounds where a needle's normal is little more than rounding.
        return (normal.normalize().dot(point - a)).abs().min(point.distance(a));
    }
    sides.into_iter().map(|[from, to]| distance_to_segment(point, from, to)).fold(f64::INFINITY, f64::min)
}

fn distance_to_segment(point: DVec3, from: DVec3, to: DVec3) -> f64 {
    let side = to - from;
    let length_squared = side.length_squared();
    let along = if length_squared > 0.0 { ((point - from).dot(side) / length_squared).clamp(0.0, 1.0) } else { 0.0 };
    point.distance(from + side * along)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ConnectivityTable;
    use silhouette_core::{Topology, TriangleMesh};
    use std::sync::Arc;

    fn table(mesh: &TriangleMesh) -> ConnectivityTable {
        ConnectivityTable::new(mesh, &Arc::new(Topology::new(mesh)))
    }

    fn crossed(mesh: &TriangleMesh, measured_at: Option<Vec3>, before: Vec3, now: Vec3) -> bool {
        let table = table(mesh);
        let (positions, triangles) = (mesh.positions(), mesh.triangles());
        let surface = Surface { positions, triangles, table: &table };
        let mut ball = ClearBall::default();
        if let Some(eye) = measured_at {
            ball.measure(&surface, table.bounds(), eye);
        }
        ball.may_have_crossed(table.bounds(), before, now)
    }

    #[test]
    fn segments_through_the_box_count_unless_a_clear_ball_holds_them() {
        let mesh = silhouette_core::shapes::by_name("icosphere:3").unwrap();
        let at = |x: f32, y: f32| Vec3::new(x, y, 0.0);
        assert!(!crossed(&mesh, None, at(3.0, 0.0), at(3.0, 1.0)), "outside");
        assert!(!crossed(&mesh, None, at(3.0, 0.0), at(0.0, 3.0)), "around the corner of the box");
        assert!(crossed(&mesh, None, at(-3.0, 0.0), at(3.0, 0.1)), "right through");
        assert!(crossed(&mesh, None, at(0.0, 0.0), at(0.1, 0.0)), "inside, nothing measured");
        assert!(!crossed(&mesh, Some(at(0.0, 0.0)), at(0.2, 0.0), at(-0.9, 0.1)), "inside the clear ball");
        assert!(crossed(&mesh, Some(at(0.0, 0.0)), at(0.2, 0.0), at(1.05, 0.0)), "out of it");
        assert!(!crossed(&mesh, None, at(1.0, 0.0), at(1.0, 0.0)), "at rest, even on a vertex");
        assert!(crossed(&mesh, None, at(f32::NAN, 0.0), at(1.0, 0.0)));
    }

    #[test]
    fn the_clear_ball_never_reaches_a_corner_or_an_inner_point_of_a_face() {
        let mesh = silhouette_core::shapes::by_name("blob:400").unwrap();
        let table = table(&mesh);
        let (positions, triangles) = (mesh.positions(), mesh.triangles());
        let surface = Surface { positions, triangles, table: &table };
        for step in 0..200_i16 {
            let t = f64::from(step);
            let eye = DVec3::new((0.37 * t).sin(), (0.91 * t).cos(), (0.53 * t).sin()) * (0.2 + 0.01 * t);
            let clear = clearance(&surface, eye);
            let mut nearest = f64::INFINITY;
            for triangle in triangles {
                let [a, b, c] = triangle.map(|vertex| positions[vertex as usize].as_dvec3());
                for (s, t) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.3, 0.3), (0.5, 0.5), (0.1, 0.6), (0.6, 0.1)] {
                    nearest = nearest.min(eye.distance(a + (b - a) * s + (c - a) * t));
                }
            }
            assert!(clear <= nearest, "{clear} {nearest}");
            assert!(clear > nearest - 0.2, "close to the sampled distance: {clear} {nearest}");
        }
    }
}
