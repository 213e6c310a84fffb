//! Facing: front or back, by the exact sign, the same for every method and every number of threads.
//!
//! A face with corners `v0 v1 v2` is *front* iff the eye lies strictly on the outer side of its plane:
//! `((v1 - v0) x (v2 - v0)) . (P - v0) > 0` (Hall 2003, Definitions), or `. W > 0` for an orthographic view towards whose
//! viewer `W` points. Ties, and with them faces of zero area, are *back*. The sign is that of the real number which the
//! 32-bit inputs define; no rounding is left in it.
//!
//! # Filter
//!
//! The sign is first evaluated in `f32`. With the unit roundoff `u = 2^-24`, each of the six products in the expansion
//! passes through at most eight roundings (three differences, two products, three sums), so the computed value differs
//! from the true one by at most `8u / (1 - 8u)` times the sum of the products' magnitudes, `M`. `M` itself is evaluated
//! with at most eight roundings and no cancellation. A relative bound of `9u` covers both and the rounding of the bound
//! itself. Products that underflow lose at most `2^-150` each, once in the six inner and once in the three outer ones:
//! `2^-148 (|p| + 1)` in all, covered by `2^-126 (|p| + 1)`. Overflow makes the bound infinite or NaN and the test fails.
//! Where the filter cannot certify the sign, it is computed exactly: `robust::orient3d` for an eye, an expansion sum for a
//! direction (whose end point would have to be rounded to be a point).

use crate::exact::sign_of_products;
use crate::id::FaceId;
use crate::mesh::TriangleMesh;
use crate::view::Viewpoint;
use glam::{Mat4, Vec3, Vec3Swizzles, Vec4};
use rayon::prelude::*;
use robust::{Coord3D, orient3d};
use std::cmp::Ordering;

/// Which side of a face the viewer is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Facing {
    /// The viewer is strictly on the outer side of the face's plane.
    Front,
    /// The viewer is on the inner side or in the plane.
    Back,
}

/// A facing and how it was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Judgement {
    /// The exact facing.
    pub facing: Facing,
    /// Whether the `f32` filter had to give way to exact arithmetic.
    pub exact_fallback: bool,
}

/// Bound of the relative error of the `f32` evaluation; derived in the [module](self).
const RELATIVE_BOUND: f32 = 9.0 * (f32::EPSILON / 2.0);

/// Bound of the absolute error by underflow, a unit of `|p| + 1`; derived in the [module](self). Equals `2^-126`: processors
/// take a hundred cycles and more for the subnormal products that the least bound would make.
const UNDERFLOW_BOUND: f32 = f32::MIN_POSITIVE;

/// The exact facing of a face with these corners (counter-clockwise seen from outside).
#[inline]
pub fn judge(corners: [Vec3; 3], viewpoint: &Viewpoint) -> Judgement {
    viewpoint.judge(corners)
}

/// The facing that the filter is certain of.
#[inline]
fn filtered_facing([v0, v1, v2]: [Vec3; 3], viewpoint: &Viewpoint) -> Option<Facing> {
    let toward_viewer = match *viewpoint {
        Viewpoint::Perspective { eye } => eye - v0,
        Viewpoint::Orthographic { toward_viewer } => toward_viewer,
    };
    let (value, error) = filter(v1 - v0, v2 - v0, toward_viewer);
    if value > error {
        Some(Facing::Front)
    } else if value < -error {
        Some(Facing::Back)
    } else {
        None
    }
}

/// `(a x b) . p`, rounded, and a bound of its error.
#[inline]
fn filter(a: Vec3, b: Vec3, p: Vec3) -> (f32, f32) {
    let (positive, negative) = (a.yzx() * b.zxy(), a.zxy() * b.yzx());
    let value = p.dot(positive - negative);
    let magnitude = p.abs().dot(positive.abs() + negative.abs());
    (value, RELATIVE_BOUND * magnitude + UNDERFLOW_BOUND * (p.abs().element_sum() + 1.0))
}

/// Exact sign of `((v1 - v0) x (v2 - v0)) . (point - v0)`.
fn side_of_point(v0: Vec3, v1: Vec3, v2: Vec3, point: Vec3) -> Ordering {
    let coord = |p: Vec3| Coord3D { x: f64::from(p.x), y: f64::from(p.y), z: f64::from(p.z) };
    // `orient3d` is positive where the point lies on the side from which the triangle runs clockwise.
    let clockwise = orient3d(coord(v0), coord(v1), coord(v2), coord(point));
    0.0_f64.partial_cmp(&clockwise).unwrap_or(Ordering::Equal)
}

/// Exact sign of `((v1 - v0) x (v2 - v0)) . direction`, as `(v0 x v1 + v1 x v2 + v2 x v0) . direction`.
fn side_of_direction(v0: Vec3, v1: Vec3, v2: Vec3, direction: Vec3) -> Ordering {
    let corners = [v0, v1, v2];
    let products = (0..3).flat_map(|i| {
        let (u, v) = (corners[i], corners[(i + 1) % 3]);
        (0..3).flat_map(move |axis| {
            let (next, after) = ((axis + 1) % 3, (axis + 2) % 3);
            [(1.0, [u[next], v[after], direction[axis]]), (-1.0, [u[after], v[next], direction[axis]])]
        })
    });
    sign_of_products(products)
}

#[inline]
fn corners(mesh: &TriangleMesh, triangle: [u32; 3]) -> [Vec3; 3] {
    triangle.map(|vertex| mesh.positions()[vertex as usize])
}

/// Four vectors, coordinate by coordinate.
type FourVectors = [Vec4; 3];

/// The vertices at one corner of four faces.
#[inline]
fn four_corners(mesh: &TriangleMesh, triangles: &[[u32; 3]; 4], corner: usize) -> FourVectors {
    let at = |face: usize| mesh.positions()[triangles[face][corner] as usize].extend(0.0);
    let by_coordinate = Mat4::from_cols(at(0), at(1), at(2), at(3)).transpose();
    [by_coordinate.x_axis, by_coordinate.y_axis, by_coordinate.z_axis]
}

/// [`filter`] for four faces at once.
#[inline]
fn filter_four(a: FourVectors, b: FourVectors, p: FourVectors) -> (Vec4, Vec4) {
    let (mut value, mut magnitude, mut size) = (Vec4::ZERO, Vec4::ZERO, Vec4::ONE);
    for (axis, next, last) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
        let (positive, negative) = (a[next] * b[last], a[last] * b[next]);
        value += p[axis] * (positive - negative);
        magnitude += p[axis].abs() * (positive.abs() + negative.abs());
        size += p[axis].abs();
    }
    (value, magnitude * RELATIVE_BOUND + size * UNDERFLOW_BOUND)
}

/// A bit for each of up to 64 faces that is certainly front, and one for each of which the filter is not certain. Four faces
/// at a time, without a branch per face.
#[inline]
fn certain_bits(mesh: &TriangleMesh, triangles: &[[u32; 3]], viewpoint: &Viewpoint) -> (u64, u64) {
    let (mut front, mut unsure) = (0, 0);
    let (fours, rest) = triangles.as_chunks::<4>();
    for (index, four) in fours.iter().enumerate() {
        let [v0, v1, v2] = [four_corners(mesh, four, 0), four_corners(mesh, four, 1), four_corners(mesh, four, 2)];
        let from_v0 = |other: FourVectors| [other[0] - v0[0], other[1] - v0[1], other[2] - v0[2]];
        let toward_viewer = match *viewpoint {
            Viewpoint::Perspective { eye } => from_v0([Vec4::splat(eye.x), Vec4::splat(eye.y), Vec4::splat(eye.z)]),
            Viewpoint::Orthographic { toward_viewer: w } => [Vec4::splat(w.x), Vec4::splat(w.y), Vec4::splat(w.z)],
        };
        let (value, error) = filter_four(from_v0(v1), from_v0(v2), toward_viewer);
        front |= u64::from(value.cmpgt(error).bitmask()) << (4 * index);
        // A bound that is not a number is no certainty either.
        unsure |= u64::from((!value.abs().cmpgt(error)).bitmask()) << (4 * index);
    }
    for (bit, &triangle) in (4 * fours.len()..).zip(rest) {
        let facing = filtered_facing(corners(mesh, triangle), viewpoint);
        front |= u64::from(facing == Some(Facing::Front)) << bit;
        unsure |= u64::from(facing.is_none()) << bit;
    }
    (front, unsure)
}

/// Decides facing exactly: a [`Viewpoint`] by Hall's definition, under which ties are back, or a
/// [`DisplacedViewer`](crate::DisplacedViewer), for whom there are no ties.
pub trait FacingRule: Sync {
    /// Where faces are seen from.
    fn viewpoint(&self) -> &Viewpoint;

    /// The facing of a face by exact arithmetic.
    fn judge_exactly(&self, corners: [Vec3; 3]) -> Facing;

    /// The facing of a face: by the filter where that is certain.
    #[inline]
    fn judge(&self, corners: [Vec3; 3]) -> Judgement {
        match filtered_facing(corners, self.viewpoint()) {
            Some(facing) => Judgement { facing, exact_fallback: false },
            None => Judgement { facing: self.judge_exactly(corners), exact_fallback: true },
        }
    }
}

impl FacingRule for Viewpoint {
    fn viewpoint(&self) -> &Viewpoint {
        self
    }

    #[cold]
    fn judge_exactly(&self, [v0, v1, v2]: [Vec3; 3]) -> Facing {
        let sign = match *self {
            Self::Perspective { eye } => side_of_point(v0, v1, v2, eye),
            Self::Orthographic { toward_viewer } => side_of_direction(v0, v1, v2, toward_viewer),
        };
        if sign == Ordering::Greater { Facing::Front } else { Facing::Back }
    }
}

/// The facing of every face for one view, one bit per face.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct FaceFacings {
    front: Vec<u64>,
    /// Faces that were left to exact arithmetic.
    doubtful: Vec<u64>,
    faces: usize,
}

/// Words of 64 faces that a rayon task takes at least: about 0.1 ms of work, so that small meshes stay on one thread.
const WORDS_PER_TASK: usize = 256;

impl FaceFacings {
    /// Facing of every face of `mesh`. O(F), parallel. Keep the value and call [`classify`](Self::classify) to reuse its
    /// memory.
    pub fn new(mesh: &TriangleMesh, rule: &impl FacingRule) -> Self {
        let mut facings = Self::default();
        facings.classify(mesh, rule);
        facings
    }

    /// Replaces the facings by those of another view; yields the number of exact fallbacks. O(F), parallel, allocates
    /// nothing once the value has seen a mesh of this size.
    pub fn classify(&mut self, mesh: &TriangleMesh, rule: &impl FacingRule) -> u64 {
        self.clear(mesh.face_count());
        let triangles = mesh.triangles().par_chunks(64);
        self.front
            .par_iter_mut()
            .zip(self.doubtful.par_iter_mut())
            .zip(triangles)
            .with_min_len(WORDS_PER_TASK)
            .map(|((word, doubtful), triangles)| {
                let (front, mut unsure) = certain_bits(mesh, triangles, rule.viewpoint());
                (*word, *doubtful) = (front, unsure);
                let fallbacks = u64::from(unsure.count_ones());
                while unsure != 0 {
                    let bit = unsure.trailing_zeros();
                    unsure &= unsure - 1;
                    let facing = rule.judge_exactly(corners(mesh, triangles[bit as usize]));
                    *word |= u64::from(facing == Facing::Front) << bit;
                }
                fallbacks
            })
            .sum()
    }

    /// Facings from any rule whatever, for tests of what holds for every labelling.
    pub fn from_fn(faces: usize, mut is_front: impl FnMut(FaceId) -> bool) -> Self {
        let mut facings = Self::default();
        facings.clear(faces);
        for face in (0..faces).map(FaceId::from_usize) {
            if is_front(face) {
                facings.set(face, Facing::Front);
            }
        }
        facings
    }

    /// Makes `faces` faces, all back.
    pub fn clear(&mut self, faces: usize) {
        for bits in [&mut self.front, &mut self.doubtful] {
            bits.clear();
            bits.resize(faces.div_ceil(64), 0);
        }
        self.faces = faces;
    }

    /// Sets the facing of a face.
    ///
    /// # Panics
    /// If there is no such face.
    #[inline]
    pub fn set(&mut self, face: FaceId, facing: Facing) {
        assert!(face.index() < self.faces, "face {face} of {}", self.faces);
        let (word, bit) = (&mut self.front[face.index() / 64], 1 << (face.index() % 64));
        match facing {
            Facing::Front => *word |= bit,
            Facing::Back => *word &= !bit,
        }
    }

    /// Number of faces.
    pub fn len(&self) -> usize {
        self.faces
    }

    /// Whether there is no face.
    pub fn is_empty(&self) -> bool {
        self.faces == 0
    }

    /// Whether a face is front.
    ///
    /// # Panics
    /// If the face is far out of range.
    #[inline]
    pub fn is_front(&self, face: FaceId) -> bool {
        self.front[face.index() / 64] >> (face.index() % 64) & 1 == 1
    }

    /// One bit per face, set for front faces: face `f` is bit `f % 64` of word `f / 64`. Bits beyond the last face are 0.
    pub fn words(&self) -> &[u64] {
        &self.front
    }

    /// Number of front faces.
    pub fn front_count(&self) -> usize {
        self.front.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// Faces that the last call of [`classify`](Self::classify) left to exact arithmetic, ascending; those seen edge-on are
    /// among them. O(F / 64).
    pub fn doubtful_faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        let words = self.doubtful.iter().enumerate().filter(|(_, word)| **word != 0);
        words.flat_map(|(index, &word)| {
            (0..64).filter(move |bit| word >> bit & 1 == 1).map(move |bit| FaceId::from_usize(64 * index + bit))
        })
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        size_of_val(self.front.as_slice()) + size_of_val(self.doubtful.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The same sign in integer arithmetic, for coordinates that are integers of at most 24 bits.
    fn integer_sign([v0, v1, v2]: [[i32; 3]; 3], viewpoint: [i32; 3], is_point: bool) -> i128 {
        let sub = |p: [i32; 3], q: [i32; 3]| [0, 1, 2].map(|i| i128::from(p[i]) - i128::from(q[i]));
        let (a, b) = (sub(v1, v0), sub(v2, v0));
        let p = if is_point { sub(viewpoint, v0) } else { viewpoint.map(i128::from) };
        (a[1] * b[2] - a[2] * b[1]) * p[0] + (a[2] * b[0] - a[0] * b[2]) * p[1] + (a[0] * b[1] - a[1] * b[0]) * p[2]
    }

    fn check(corners: [[i32; 3]; 3], viewpoint: [i32; 3], exponent: i32) -> (bool, bool) {
        let scale = 2.0_f64.powi(exponent);
        let float = |p: [i32; 3]| Vec3::from(p.map(|c| (f64::from(c) * scale) as f32));
        let mut fallbacks = [false; 2];
        for (index, is_point) in [true, false].into_iter().enumerate() {
            let view = if is_point {
                Viewpoint::Perspective { eye: float(viewpoint) }
            } else {
                Viewpoint::Orthographic { toward_viewer: float(viewpoint) }
            };
            let judgement = judge(corners.map(float), &view);
            let expected = integer_sign(corners, viewpoint, is_point) > 0;
            assert_eq!(judgement.facing == Facing::Front, expected, "{corners:?} {viewpoint:?} {view:?}");
            fallbacks[index] = judgement.exact_fallback;
        }
        (fallbacks[0], fallbacks[1])
    }

    #[test]
    fn ties_are_back_and_need_the_fallback() {
        let corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]];
        assert_eq!(check(corners, [5, 7, 0], 0), (true, true));
        assert_eq!(check(corners, [5, 7, 1], 0), (false, false));
        assert_eq!(check([[3, 3, 3]; 3], [5, 7, 1], 0), (true, true), "zero area");
    }

    #[test]
    fn underflow_and_overflow_reach_the_fallback() {
        let corners = [[0, 0, 0], [3, 0, 0], [0, 3, 0]];
        for exponent in [-149, -148, -100, -60, 100, 123] {
            assert_eq!(check(corners, [1, 1, 2], exponent).0, exponent.abs() >= 60, "2^{exponent}");
        }
    }

    #[test]
    fn an_eye_that_is_not_finite_sees_only_backs() {
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y];
        for bad in [f32::NAN, f32::INFINITY] {
            let judgement = judge(corners, &Viewpoint::Perspective { eye: Vec3::splat(bad) });
            assert_eq!(judgement.facing, Facing::Back);
        }
    }

    fn point(range: i32) -> impl Strategy<Value = [i32; 3]> {
        prop::array::uniform3(-range..=range)
    }

    proptest! {
        #[test]
        fn random_faces(corners in prop::array::uniform3(point(1 << 23)), view in point(1 << 23), exponent in -120..80) {
            check(corners, view, exponent);
        }

        /// Few distinct coordinates: coplanar eyes and zero areas are common.
        #[test]
        fn nearly_degenerate_faces(corners in prop::array::uniform3(point(2)), view in point(2), offset in point(1 << 22)) {
            let moved = |p: [i32; 3]| [0, 1, 2].map(|i| p[i] + offset[i]);
            check(corners.map(moved), moved(view), 0);
        }

        /// Meshes of any number of faces, of which four are looked at at a time; negated views have other certain facings.
        #[test]
        fn all_faces_of_a_mesh(
            faces in prop::collection::vec(prop::array::uniform3(point(3)), 0..140), view in point(4), exponent in -60..30,
        ) {
            let scale = 2.0_f64.powi(exponent);
            let float = |p: [i32; 3]| Vec3::from(p.map(|c| (f64::from(c) * scale) as f32));
            let triangles = (0..faces.len() as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
            let mesh = TriangleMesh::new(faces.iter().flatten().map(|&p| float(p)).collect(), triangles).unwrap();
            for (is_point, viewpoint) in [
                (true, Viewpoint::Perspective { eye: float(view) }),
                (false, Viewpoint::Orthographic { toward_viewer: float(view) }),
            ] {
                let facings = FaceFacings::new(&mesh, &viewpoint);
                for (face, &corners) in faces.iter().enumerate() {
                    let expected = integer_sign(corners, view, is_point);
                    prop_assert_eq!(facings.is_front(FaceId::from_usize(face)), expected > 0);
                    let is_doubtful = facings.doubtful_faces().any(|doubtful| doubtful.index() == face);
                    prop_assert!(is_doubtful || expected != 0);
                }
            }
        }

        #[test]
        fn flipping_a_face_flips_a_certain_facing(corners in prop::array::uniform3(point(1000)), view in point(1000)) {
            let [a, b, c] = corners;
            let sign = integer_sign([a, b, c], view, true);
            prop_assert_eq!(sign, -integer_sign([a, c, b], view, true));
            check([a, c, b], view, 0);
        }
    }

    #[test]
    fn bits_hold_every_face() {
        let facings = FaceFacings::from_fn(130, |face| face.get() % 3 == 0);
        assert_eq!(facings.front_count(), 44);
        assert!((0..130).all(|face| facings.is_front(FaceId::new(face)) == (face % 3 == 0)));
        assert!(
            (0..192)
                .all(|face| facings.words()[face / 64] >> (face % 64) & 1 == u64::from(face < 130 && face % 3 == 0))
        );
    }
}
