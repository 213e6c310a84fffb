//! Facing by a face's plane equation (Hall 2003, Definitions), in 32 bits and yet exact.
//!
//! A plane is a unit normal `n` and an offset `d`, relative to the middle `c` of the mesh, computed in 64 bits from the
//! corners and then rounded; the test of a view is `v = n . (P - c) + d`, four products of 32-bit floats, and the sign
//! of `v` is that of the true signed distance `s` wherever `|v|` exceeds one bound for the whole view. Elsewhere, which
//! is one face in a hundred thousand, [`judge`] decides.
//!
//! # The bound
//!
//! Let `u = 2^-24`, `p = P - c` and `R` the largest distance of a vertex from `c`, hence `|d| <= R`.
//!
//! - The cross product in 64 bits is off by less than `2^-50 |a| |b|` for edges `a`, `b`. A face with
//!   `|a x b| < 2^-18 |a| |b|` (a needle, or no area) gets the zero plane, which no bound certifies; in all others the
//!   unit normal is off by less than `2^-30`.
//! - Rounding `n`, `d` and `p` to 32 bits is off by `u` relatively each. Four products and three sums, in any order,
//!   are off by at most `4u / (1 - 4u)` times the sum of the products' magnitudes.
//! - So `|v - s| <= (6u + 2^-29) |p|_1 + (5u + 2^-29) R`, below `8u (|p|_1 + R)`; the rounding of 64-bit coordinates
//!   far from their origin adds at most `2^-50 (|c|_1 + |P|_1)`, products that underflow less than the smallest normal
//!   float.
//!
//! Overflow makes the bound infinite and certifies nothing. For an orthographic view along `W` the offset plays no part
//! and the bound is `8u |W|_1`.

use silhouette_core::Viewpoint;
use silhouette_core::facing::{Facing, Judgement, judge};
use silhouette_core::glam::{DVec3, Mat4, Vec3, Vec4};

/// A face's sides span less than this sine: its plane is not trusted to 64 bits. See the [module](self).
const NEEDLE_SINE: f64 = 1.0 / 262_144.0;

/// Relative error of the test, `8u`. See the [module](self).
const RELATIVE_BOUND: f64 = 8.0 / 16_777_216.0;

/// Relative error of 64-bit coordinates that are made relative to the middle, `2^-50`.
const RECENTRE_BOUND: f64 = 4.0 * f64::EPSILON;

/// Bounds beyond this are taken as infinite, so that no partial sum of a certified test overflows.
const LARGEST_REACH: f64 = f32::MAX as f64 / 16.0;

/// Sum of magnitudes.
fn l1(v: DVec3) -> f64 {
    v.abs().element_sum()
}

/// Unit normal and offset of a face relative to `center`, or zeros where 64 bits do not suffice.
pub(crate) fn plane([v0, v1, v2]: [DVec3; 3], center: DVec3) -> [f32; 4] {
    let (a, b) = (v1 - v0, v2 - v0);
    let normal = a.cross(b);
    let length = normal.length();
    if length > NEEDLE_SINE * (a.length() * b.length()) {
        let unit = normal / length;
        let [x, y, z] = unit.as_vec3().to_array();
        [x, y, z, -unit.dot(v0 - center) as f32]
    } else {
        [0.0; 4]
    }
}

/// One view against any plane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PlaneTest {
    viewpoint: Viewpoint,
    point: [f32; 4],
    error: f32,
    /// Length of a unit of distance in the space that views move in: 1 for eyes, 1 / |W| for directions W.
    unit: f64,
}

impl PlaneTest {
    /// The test of a view of planes relative to `center`, whose faces lie within `radius` of it.
    pub fn new(viewpoint: &Viewpoint, center: DVec3, radius: f64) -> Self {
        let (point, weight, error) = match *viewpoint {
            Viewpoint::Perspective { eye } => {
                let eye = eye.as_dvec3();
                let reach = l1(eye - center) + radius;
                (eye - center, 1.0, bound(reach, RELATIVE_BOUND * reach + RECENTRE_BOUND * (l1(center) + l1(eye))))
            }
            Viewpoint::Orthographic { toward_viewer } => {
                let direction = toward_viewer.as_dvec3();
                (direction, 0.0, bound(l1(direction) + radius, RELATIVE_BOUND * l1(direction)))
            }
        };
        let [x, y, z] = point.as_vec3().to_array();
        let unit = if weight == 0.0 { point.length().recip() } else { 1.0 };
        Self { viewpoint: *viewpoint, point: [x, y, z, weight], error, unit }
    }

    #[inline]
    fn distance(&self, n: [f32; 4]) -> f32 {
        let p = &self.point;
        (p[0] * n[0] + p[1] * n[1]) + (p[2] * n[2] + p[3] * n[3])
    }

    /// Distance of the eye from a plane, or sine of a direction's angle with it; never too great, and 0 where the plane
    /// does not tell.
    #[inline]
    pub fn height(&self, n: [f32; 4]) -> f64 {
        let height = (f64::from(self.distance(n).abs()) - f64::from(self.error)) * self.unit;
        // Not a number where the error is infinite: then the maximum is 0.
        (height * (1.0 - 4.0 * f64::EPSILON)).max(0.0)
    }

    /// Whether a face is front; `None` where the bound does not tell.
    #[inline]
    fn certified(&self, n: [f32; 4]) -> Option<bool> {
        let distance = self.distance(n);
        // What is not a number is not certain.
        if distance.abs() > self.error { Some(distance > 0.0) } else { None }
    }

    /// Which of four faces are front, a bit each; `None` where the bound does not tell it of all.
    #[inline]
    pub fn certified_four(&self, planes: [[f32; 4]; 4]) -> Option<u32> {
        let n = Mat4::from_cols_array_2d(&planes).transpose();
        let p = self.point;
        let distances = (n.x_axis * p[0] + n.y_axis * p[1]) + (n.z_axis * p[2] + n.w_axis * p[3]);
        let are_certain = distances.abs().cmpgt(Vec4::splat(self.error)).all();
        are_certain.then(|| distances.cmpgt(Vec4::ZERO).bitmask())
    }

    /// The exact facing of a face with this plane, whose corners `corners` yields.
    #[inline]
    pub fn judge(&self, plane: [f32; 4], corners: impl FnOnce() -> [Vec3; 3]) -> Judgement {
        match self.certified(plane) {
            Some(true) => Judgement { facing: Facing::Front, exact_fallback: false },
            Some(false) => Judgement { facing: Facing::Back, exact_fallback: false },
            None => fall_back(corners(), &self.viewpoint),
        }
    }
}

#[cold]
fn fall_back(corners: [Vec3; 3], viewpoint: &Viewpoint) -> Judgement {
    Judgement { exact_fallback: true, ..judge(corners, viewpoint) }
}

/// A bound as a 32-bit float that is not below it; infinite where partial sums could overflow.
fn bound(reach: f64, error: f64) -> f32 {
    if reach < LARGEST_REACH { (error * (1.0 + 1e-6)) as f32 + f32::MIN_POSITIVE } else { f32::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ConnectivityTable;
    use proptest::prelude::*;
    use silhouette_core::{FaceId, Topology, TriangleMesh};
    use std::sync::Arc;

    fn table(mesh: &TriangleMesh) -> ConnectivityTable {
        ConnectivityTable::new(mesh, &Arc::new(Topology::new(mesh)))
    }

    fn coordinate() -> impl Strategy<Value = f32> {
        let wild = (any::<u32>()).prop_map(f32::from_bits).prop_filter("finite", |x| x.is_finite());
        prop_oneof![4 => -2.0_f32..2.0, 2 => (-3_i8..3).prop_map(f32::from), 1 => wild]
    }

    fn point() -> impl Strategy<Value = Vec3> {
        prop::array::uniform3(coordinate()).prop_map(Vec3::from)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        #[test]
        fn what_is_certified_is_exact(
            corners in prop::array::uniform3(point()), others in prop::collection::vec(point(), 0..4),
            view in point(), is_eye in any::<bool>(), offset in -24_i32..24, scale in -30_i32..30,
            near_plane in any::<bool>(), weights in prop::array::uniform2(-2.0_f32..2.0),
        ) {
            let place = |p: Vec3| p * 2.0_f32.powi(scale) + Vec3::splat(2.0_f32.powi(offset));
            let corners = corners.map(place);
            let [a, b, c] = corners;
            let view = if near_plane { a + (b - a) * weights[0] + (c - a) * weights[1] } else { place(view) };
            let positions: Vec<Vec3> = corners.into_iter().chain(others.into_iter().map(place)).collect();
            let mut triangles = vec![[0, 1, 2]];
            triangles.extend((3..positions.len() as u32).map(|vertex| [0, 1, vertex]));
            prop_assume!(positions.iter().all(|p| p.is_finite()));
            let mesh = TriangleMesh::new(positions, triangles).unwrap();
            let viewpoint = if is_eye {
                Viewpoint::Perspective { eye: view }
            } else {
                Viewpoint::Orthographic { toward_viewer: view }
            };
            let table = table(&mesh);
            let test = table.test(&viewpoint);
            for face in (0..mesh.face_count()).map(FaceId::from_usize) {
                let expected = judge(mesh.corners(face), &viewpoint).facing == Facing::Front;
                let of_one = test.certified(table.plane(face));
                let four = [face, FaceId::new(0), face, FaceId::new(0)].map(|face| table.plane(face));
                let of_four = test.certified_four(four).map(|fronts| [fronts & 1 == 1, fronts & 4 == 4]);
                for is_front in of_one.into_iter().chain(of_four.into_iter().flatten()) {
                    prop_assert_eq!(is_front, expected, "face {} of {:?} from {:?}", face, mesh, viewpoint);
                }
            }
        }
    }

    /// The bound is not just safe, but of use: a sound one that certifies nothing would pass every other test.
    #[test]
    fn hardly_any_face_is_left_open() {
        let mesh = silhouette_core::shapes::by_name("blob:20000").unwrap();
        let table = table(&mesh);
        let viewpoint = Viewpoint::Perspective { eye: Vec3::new(2.0, 1.0, 1.5) };
        let test = table.test(&viewpoint);
        let open = (0..20_000).filter(|&face| test.certified(table.plane(FaceId::new(face))).is_none()).count();
        assert!(open <= 2, "{open}");
        let edge_on = Viewpoint::Perspective { eye: mesh.positions()[0] };
        let test = table.test(&edge_on);
        assert!((0..20_000).any(|face| test.certified(table.plane(FaceId::new(face))).is_none()), "ties are open");
    }
}
