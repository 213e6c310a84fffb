//! Brute force that shares no code with the crate: every face against a sight line, in integers where floats are in doubt.

use num_bigint::BigInt;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::{TriangleMesh, Viewpoint};

/// A parameter along an edge is a multiple of this, so that points of the edge are exact.
const STEPS: i64 = 1 << 20;

/// The parameter next to `t` at which the oracle can look, strictly between 0 and 1.
pub fn nearest_step(t: f64) -> i64 {
    ((t * STEPS as f64).round() as i64).clamp(1, STEPS - 1)
}

/// Number of solids or sheets in front of the point `step / STEPS` of the edge; `None` where the sight line passes exactly
/// through an edge of a face, or the point lies exactly in a face's plane and inside of it.
pub fn invisibility(mesh: &TriangleMesh, viewpoint: &Viewpoint, edge: [u32; 2], step: i64) -> Option<u32> {
    let [a, b] = edge.map(|vertex| mesh.positions()[vertex as usize]);
    let t = step as f64 / STEPS as f64;
    let place = a.as_dvec3() + (b.as_dvec3() - a.as_dvec3()) * t;
    let toward = match *viewpoint {
        Viewpoint::Perspective { eye } => eye.as_dvec3() - place,
        Viewpoint::Orthographic { toward_viewer } => toward_viewer.as_dvec3(),
    };
    let size = f64::from(a.abs().max(b.abs()).max_element());
    let (mut front, mut back) = (0, 0);
    for triangle in mesh.triangles() {
        let corners = triangle.map(|vertex| mesh.positions()[vertex as usize]);
        // By place, not by id: at a seam, a face of the other side lies on the edge as well.
        if corners.contains(&a) && corners.contains(&b) {
            continue;
        }
        let signs = match rounded_signs(corners, place, toward, size, viewpoint) {
            Verdict::Missed => continue,
            Verdict::Doubt => exact_signs(corners, [a, b], step, viewpoint),
            Verdict::Cut(facing) => [facing, facing, facing, facing, -facing],
        };
        let [facing, sides @ .., above] = signs;
        if facing == 0 || sides.contains(&-facing) || above == facing {
            continue;
        }
        if sides.contains(&0) || above == 0 {
            return None;
        }
        if facing > 0 { front += 1 } else { back += 1 }
    }
    Some(front.max(back))
}

enum Verdict {
    Missed,
    Doubt,
    Cut(i32),
}

/// In floats, with a wide margin.
fn rounded_signs(corners: [Vec3; 3], place: DVec3, toward: DVec3, size: f64, viewpoint: &Viewpoint) -> Verdict {
    const MARGIN: f64 = 1e-9;
    let [u, v, w] = corners.map(|corner| corner.as_dvec3() - place);
    let reach = u.length() + v.length() + w.length() + size;
    let margin = MARGIN * reach * reach * toward.length();
    let sides = [u.cross(v).dot(toward), v.cross(w).dot(toward), w.cross(u).dot(toward)];
    if sides.iter().any(|&side| side > margin) && sides.iter().any(|&side| side < -margin) {
        return Verdict::Missed;
    }
    if sides.iter().any(|side| side.abs() <= margin) {
        return Verdict::Doubt;
    }
    let facing = if sides[0] > 0.0 { 1 } else { -1 };
    let normal = (v - u).cross(w - u);
    let above_point = -normal.dot(u) * f64::from(facing);
    let above_eye = match viewpoint {
        Viewpoint::Perspective { .. } => normal.dot(toward - u) * f64::from(facing),
        Viewpoint::Orthographic { .. } => f64::INFINITY,
    };
    let margin = MARGIN * reach * reach * (reach + toward.length());
    if above_point > margin || above_eye < -margin {
        Verdict::Missed
    } else if above_point < -margin && above_eye > margin {
        Verdict::Cut(facing)
    } else {
        Verdict::Doubt
    }
}

/// Signs of the facing, of the sight line's side of each of the three sides, and of the point's height above the face.
fn exact_signs(corners: [Vec3; 3], ends: [Vec3; 2], step: i64, viewpoint: &Viewpoint) -> [i32; 5] {
    type Point = [BigInt; 3];
    // Any finite f32 is a multiple of 2^-149; the edge's points are multiples of that over STEPS.
    let integer = |value: f32| {
        let bits = value.to_bits();
        let (exponent, fraction) = ((bits >> 23 & 0xff) as i32, i64::from(bits & 0x7f_ffff));
        let significand = if exponent == 0 { fraction } else { fraction | 1 << 23 };
        BigInt::from(if bits >> 31 == 1 { -significand } else { significand }) << (exponent.max(1) - 1)
    };
    let point = |p: Vec3| -> Point { [p.x, p.y, p.z].map(|c| integer(c) * STEPS) };
    let minus = |p: &Point, q: &Point| -> Point { [0, 1, 2].map(|i| &p[i] - &q[i]) };
    let determinant = |x: &Point, y: &Point, z: &Point| {
        (&x[1] * &y[2] - &x[2] * &y[1]) * &z[0]
            + (&x[2] * &y[0] - &x[0] * &y[2]) * &z[1]
            + (&x[0] * &y[1] - &x[1] * &y[0]) * &z[2]
    };
    let sign = |value: BigInt| match value.sign() {
        num_bigint::Sign::Plus => 1,
        num_bigint::Sign::NoSign => 0,
        num_bigint::Sign::Minus => -1,
    };
    let [u, v, w] = corners.map(point);
    let [a, b] = ends.map(|end| [end.x, end.y, end.z].map(integer));
    let place: Point = [0, 1, 2].map(|i| &a[i] * (STEPS - step) + &b[i] * step);
    let toward = |from: &Point| match *viewpoint {
        Viewpoint::Perspective { eye } => minus(&point(eye), from),
        Viewpoint::Orthographic { toward_viewer } => point(toward_viewer),
    };
    let side = |p: &Point, q: &Point| sign(determinant(&minus(p, &place), &minus(q, &place), &toward(&place)));
    let (vu, wu) = (minus(&v, &u), minus(&w, &u));
    let facing = sign(determinant(&vu, &wu, &toward(&u)));
    let above = sign(determinant(&vu, &wu, &minus(&place, &u)));
    [facing, side(&u, &v), side(&v, &w), side(&w, &u), above]
}
