//! Orientation of four points, and of three as a viewer sees them: exact in sign, close in value.
//!
//! Every yes-or-no question about points, edges and faces in a picture comes down to the sign of one determinant. Where a
//! place is wanted as well (the point at which one edge crosses another is a ratio of two determinants), a value that
//! merely has the right sign is of no use; so these functions promise a small *relative* error, near zero too, and zero
//! exactly where the determinant of the 32-bit inputs is zero.
//!
//! # Filter
//!
//! In `f64` with unit roundoff `u = 2^-53`, each of the six products of the determinant of three differences passes through
//! at most eight roundings, so that the computed value is within `9u M` of the true one, `M` being the sum of the products'
//! magnitudes. A value above `2^30` times that bound is within `2^-30` of the truth, relatively. Products of three 32-bit
//! floats neither overflow nor underflow in `f64`. Whatever is closer to zero is summed exactly, as an expansion.

use crate::exact::sum_of_products;
use crate::view::Viewpoint;
use glam::{DVec3, Vec3};

/// Largest relative error of a value of this module.
pub const RELATIVE_ERROR: f64 = 1.0 / (1_u64 << 30) as f64;

/// A value above this share of the products' magnitudes has a relative error below [`RELATIVE_ERROR`].
const CERTAIN: f64 = 9.0 * (f64::EPSILON / 2.0) / RELATIVE_ERROR;

/// `((b - a) x (c - a)) . (d - a)`: six times the volume of the tetrahedron, above 0 where `d` lies on the side from which
/// `a b c` runs counter-clockwise. Within [`RELATIVE_ERROR`], 0 only for points in one plane.
#[inline]
pub fn orientation(a: Vec3, b: Vec3, c: Vec3, d: Vec3) -> f64 {
    certain_orientation(a, b, c, d).unwrap_or_else(|| exact_orientation(a, b, c, d))
}

/// `normal . (p - point)`: above 0 where `p` lies on the side of the plane through `point` to which `normal` points. Within
/// [`RELATIVE_ERROR`], 0 only in the plane.
#[inline]
pub fn height_over_plane(point: Vec3, normal: Vec3, p: Vec3) -> f64 {
    let products = normal.as_dvec3() * (p.as_dvec3() - point.as_dvec3());
    let (value, magnitude) = (products.element_sum(), products.abs().element_sum());
    let is_certain = value.abs() > CERTAIN * magnitude || magnitude == 0.0;
    if is_certain { value } else { exact_height(point, normal, p) }
}

#[cold]
fn exact_height(point: Vec3, normal: Vec3, p: Vec3) -> f64 {
    let product = |sign: f64, of: Vec3| (0..3).map(move |axis| (sign, [normal[axis], of[axis], 1.0]));
    sum_of_products(product(1.0, p).chain(product(-1.0, point)))
}

#[inline]
fn certain_orientation(a: Vec3, b: Vec3, c: Vec3, d: Vec3) -> Option<f64> {
    let base = a.as_dvec3();
    certain_triple(b.as_dvec3() - base, c.as_dvec3() - base, d.as_dvec3() - base)
}

#[cold]
fn exact_orientation(a: Vec3, b: Vec3, c: Vec3, d: Vec3) -> f64 {
    // Shared vertices are the common case of points in one plane.
    if a == b || a == c || a == d || b == c || b == d || c == d {
        return 0.0;
    }
    let faces = [(1.0, [b, c, d]), (-1.0, [a, c, d]), (1.0, [a, b, d]), (-1.0, [a, b, c])];
    sum_of_products(faces.into_iter().flat_map(|(sign, corners)| determinant(sign, corners)))
}

/// How `a b c` turns as seen from `viewpoint`: above 0 for a counter-clockwise turn, where `c` lies to the left of the line
/// from `a` to `b`. It is the number whose sign is the facing of a face with these corners. As a function of each point it
/// is affine. Within [`RELATIVE_ERROR`]; 0 only where the three points and the eye lie in one plane.
#[inline]
pub fn turn(viewpoint: &Viewpoint, a: Vec3, b: Vec3, c: Vec3) -> f64 {
    certain_turn(viewpoint, a, b, c).unwrap_or_else(|| exact_turn(viewpoint, a, b, c))
}

/// [`turn`] where the filter is certain of it.
#[inline]
pub(crate) fn certain_turn(viewpoint: &Viewpoint, a: Vec3, b: Vec3, c: Vec3) -> Option<f64> {
    match *viewpoint {
        Viewpoint::Perspective { eye } => certain_orientation(a, b, c, eye),
        Viewpoint::Orthographic { toward_viewer } => {
            let base = a.as_dvec3();
            certain_triple(b.as_dvec3() - base, c.as_dvec3() - base, toward_viewer.as_dvec3())
        }
    }
}

/// [`turn`] by exact arithmetic.
#[cold]
pub(crate) fn exact_turn(viewpoint: &Viewpoint, a: Vec3, b: Vec3, c: Vec3) -> f64 {
    match *viewpoint {
        Viewpoint::Perspective { eye } => exact_orientation(a, b, c, eye),
        Viewpoint::Orthographic { toward_viewer } => exact_turn_along(toward_viewer, a, b, c),
    }
}

fn exact_turn_along(direction: Vec3, a: Vec3, b: Vec3, c: Vec3) -> f64 {
    if a == b || a == c || b == c {
        return 0.0;
    }
    let sides = [[a, b, direction], [b, c, direction], [c, a, direction]];
    sum_of_products(sides.into_iter().flat_map(|corners| determinant(1.0, corners)))
}

/// `(x cross y) . z` where the filter is certain of it.
#[inline]
fn certain_triple(x: DVec3, y: DVec3, z: DVec3) -> Option<f64> {
    let (positive, negative) = ([x.y * y.z, x.z * y.x, x.x * y.y], [x.z * y.y, x.x * y.z, x.y * y.x]);
    let (mut value, mut magnitude) = (0.0, 0.0);
    for axis in 0..3 {
        value += (positive[axis] - negative[axis]) * z[axis];
        magnitude += (positive[axis].abs() + negative[axis].abs()) * z[axis].abs();
    }
    (value.abs() > CERTAIN * magnitude || magnitude == 0.0).then_some(value)
}

/// The six products of the determinant of three rows.
fn determinant(sign: f64, [x, y, z]: [Vec3; 3]) -> impl Iterator<Item = (f64, [f32; 3])> {
    (0..3).flat_map(move |axis| {
        let (next, after) = ((axis + 1) % 3, (axis + 2) % 3);
        [(sign, [x[next], y[after], z[axis]]), (-sign, [x[after], y[next], z[axis]])]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::facing::{Facing, judge};
    use proptest::prelude::*;

    fn float(p: [i32; 3], scale: f64) -> Vec3 {
        Vec3::from(p.map(|c| (f64::from(c) * scale) as f32))
    }

    /// The same determinant in integers.
    fn integer([a, b, c, d]: [[i32; 3]; 4]) -> i128 {
        let minus = |p: [i32; 3]| [0, 1, 2].map(|i| i128::from(p[i]) - i128::from(a[i]));
        let (x, y, z) = (minus(b), minus(c), minus(d));
        (x[1] * y[2] - x[2] * y[1]) * z[0] + (x[2] * y[0] - x[0] * y[2]) * z[1] + (x[0] * y[1] - x[1] * y[0]) * z[2]
    }

    fn check(points: [[i32; 3]; 4], exponent: i32) {
        let scale = 2.0_f64.powi(exponent);
        let [a, b, c, d] = points.map(|p| float(p, scale));
        let expected = integer(points) as f64 * scale.powi(3);
        for value in [orientation(a, b, c, d), turn(&Viewpoint::Perspective { eye: d }, a, b, c)] {
            assert!((value - expected).abs() <= expected.abs() * RELATIVE_ERROR * 1.001, "{value} for {expected}");
        }
        let along = turn(&Viewpoint::Orthographic { toward_viewer: d }, a, b, c);
        let shifted = [0, 1, 2].map(|i| points[3][i].saturating_add(points[0][i]));
        let expected = integer([points[0], points[1], points[2], shifted]) as f64 * scale.powi(3);
        assert!((along - expected).abs() <= expected.abs() * RELATIVE_ERROR * 1.001, "{along} for {expected}");
    }

    #[test]
    fn the_sign_of_a_turn_is_the_facing() {
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y];
        for height in [-1.0, 0.0, 1e-30, 1.0] {
            for viewpoint in [
                Viewpoint::Perspective { eye: Vec3::new(5.0, 7.0, height) },
                Viewpoint::Orthographic { toward_viewer: Vec3::new(5.0, 7.0, height) },
            ] {
                let is_front = judge(corners, &viewpoint).facing == Facing::Front;
                assert_eq!(turn(&viewpoint, corners[0], corners[1], corners[2]) > 0.0, is_front);
            }
        }
    }

    #[test]
    fn planes_are_exact() {
        let (point, normal) = (Vec3::new(0.1, 0.2, 0.3), Vec3::ONE);
        // 0.1 + 0.2 + 0.3 in another order, whose sum in floats is another number.
        for p in [Vec3::new(0.3, 0.1, 0.2), Vec3::new(0.2, 0.3, 0.1), point] {
            assert!(height_over_plane(point, normal, p) == 0.0, "{p}");
        }
        let above = Vec3::new(0.3, 0.1, 0.2_f32.next_up());
        let expected = f64::from(0.2_f32.next_up()) - f64::from(0.2_f32);
        for (normal, sign) in [(normal, 1.0), (-normal, -1.0)] {
            let height = height_over_plane(point, normal, above);
            assert!((height / (sign * expected) - 1.0).abs() <= RELATIVE_ERROR, "{height} for {expected}");
        }
        let far = f32::MAX;
        assert!(height_over_plane(Vec3::splat(far), Vec3::splat(far), Vec3::splat(-far)) < 0.0);
        assert!(height_over_plane(Vec3::X, Vec3::new(f32::from_bits(1), 0.0, 0.0), Vec3::new(2.0, far, -far)) > 0.0);
    }

    fn point(range: i32) -> impl Strategy<Value = [i32; 3]> {
        prop::array::uniform3(-range..=range)
    }

    proptest! {
        #[test]
        fn random_points(points in prop::array::uniform4(point(1 << 22)), exponent in -120..80) {
            check(points, exponent);
        }

        /// Few distinct coordinates far from the origin: planes are common, and differences cancel.
        #[test]
        fn nearly_degenerate_points(points in prop::array::uniform4(point(2)), offset in point(1 << 21)) {
            check(points.map(|p| [0, 1, 2].map(|i| p[i] + offset[i])), 0);
        }

        /// Points moved by a little off a plane through large coordinates: what the filter alone would get wrong.
        #[test]
        fn points_close_to_a_plane(points in prop::array::uniform3(point(1 << 20)), step in point(1), s in -3..4, t in -3..4) {
            let [a, b, c] = points;
            let d = [0, 1, 2].map(|i| a[i] + s * (b[i] - a[i]) + t * (c[i] - a[i]) + step[i]);
            check([a, b, c, d], -20);
        }
    }
}
