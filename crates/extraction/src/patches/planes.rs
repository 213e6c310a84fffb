//! Face planes in 16-bit integers, and a facing test over 64 of them whose error is bounded by proof.
//!
//! # Numbers
//!
//! A [`Frame`] moves a centre `c` (a point of 32-bit floats) to the origin and scales by `1/r`, so that every corner `q`
//! of a face has length at most 1. There a face with unit normal `n` has the plane `n.x + d`, `d = -n.q`, `|d| <= 1`, and
//! an eye at `p` sees it from the front iff `n.p + d > 0`. Multiplying by a positive number changes no sign, so the
//! homogeneous viewpoint `(p, 1)` (`(w, 0)` for a direction `w`) is scaled to length 1: `(x, q)`. Both sides are rounded
//! to multiples of `1/K`, `K = 32767`:
//!
//! `N = K n + e_n`, `D = K d + e_d`, `X = K x + e_x`, `Q = K q + e_q`.
//!
//! # Bound
//!
//! `s = N.X + D Q` is computed without error: by Cauchy-Schwarz `|s| < sqrt(2) (K + 1)^2 < 2^31`, and so is either partial
//! sum of two products. Subtracting the true value,
//!
//! `s - K^2 (n.x + d q) = e_n.X + e_d Q + K (n.e_x + d e_q)`.
//!
//! Each component of `e_n` and `e_d` is at most `h =` [`PLANE_ROUNDING`] in magnitude, `|n| = 1` and `|d| <= 1`, hence the
//! difference is at most
//!
//! `B = h (|X_1| + |X_2| + |X_3| + |Q|) + K (|e_x| + |e_q|)`,
//!
//! one number per view, in which everything is known. `s > B` proves front, `s < -B` proves back. Nothing else is ever
//! concluded: the other faces, about one in twenty thousand, go to [`silhouette_core::facing::judge`].
//!
//! Where `h` comes from: half a step of rounding, plus the error of `n` and `d` in `f64`. With `u = 2^-53`, the cross
//! product `a x b` of two side vectors is off by at most `8 u |a| |b|`. Only a face with `|a x b| >= 2^-24 |a| |b|` gets a
//! plane, so the direction of `n` is off by at most `2^-26`, and `n.q` by little more since `|q| <= 1`; `K 2^-25 < 0.001`.
//!
//! # Cases
//!
//! - *Needles*, whose cross product is smaller: the plane is zero. `s = 0` is within every bound, so they go to `judge`.
//! - *Zero area*: where it is certain (two equal corners; or side vectors exact in 24 bits, so that all six products are
//!   exact, and a cross product of exactly zero) the face is back from everywhere and is not evaluated; otherwise it is a
//!   needle.
//! - *Eye far away*: `(x, q)` tends to `(direction, 0)` without overflow, since `f64` holds the square of any ratio of two
//!   `f32`. *Eye in the centre*: `(0, 1)`.
//! - *Eye or direction that is not finite, direction zero*: the bound is infinite ([`i32::MAX`]), and `judge` decides.
//! - *Tiny and huge meshes*: only ratios enter; products of two differences of `f32` neither overflow nor vanish in `f64`.

use glam::{DVec3, DVec4, Vec3};
use silhouette_core::{Viewpoint, glam};

/// Faces in a block: one machine word of facings.
pub(crate) const LANES: usize = 64;

/// `K` of the [module](self).
const SCALE: f64 = 32767.0;

/// `h` of the [module](self): half a step, and `f64` errors of less than a hundredth.
const PLANE_ROUNDING: f64 = 0.51;

/// Smallest `|a x b|`, in units of `|a| |b|`, that yields a plane: `2^-24`. The squares are compared.
const LEAST_SINE_SQUARED: f64 = 1.0 / (1_u64 << 48) as f64;

/// Where 16-bit coordinates live: object space, moved and scaled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Frame {
    center: DVec3,
    inverse_radius: f64,
}

impl Frame {
    /// Takes the box `min..=max` into the unit ball.
    pub(crate) fn of(min: Vec3, max: Vec3) -> Self {
        let (min, max) = (min.as_dvec3(), max.as_dvec3());
        // A centre in f32 keeps `position - center` a difference of two f32, with one rounding in f64.
        let center = ((min + max) * 0.5).as_vec3().as_dvec3();
        let radius = (max - center).abs().max((center - min).abs()).length() * (1.0 + 1e-9);
        Self { center, inverse_radius: if radius > 0.0 { radius.recip() } else { 1.0 } }
    }

    /// A point of object space, or of its surroundings, in this frame.
    pub(crate) fn local(&self, point: Vec3) -> DVec3 {
        (point.as_dvec3() - self.center) * self.inverse_radius
    }
}

/// `(x, q)` of the [module](self), of length 1; `None` where a viewpoint is not finite or no direction.
pub(crate) fn homogeneous(viewpoint: &Viewpoint, frame: &Frame) -> Option<DVec4> {
    let point = match *viewpoint {
        Viewpoint::Perspective { eye } => frame.local(eye).extend(1.0),
        Viewpoint::Orthographic { toward_viewer } => toward_viewer.as_dvec3().extend(0.0),
    };
    let length = point.length();
    (length > 0.0 && length.is_finite()).then(|| point / length)
}

/// Unit normal, off by at most `2^-26`; `None` for needles and faces of zero area.
pub(crate) fn unit_normal([v0, v1, v2]: [Vec3; 3]) -> Option<DVec3> {
    let origin = v0.as_dvec3();
    let (a, b) = (v1.as_dvec3() - origin, v2.as_dvec3() - origin);
    let normal = a.cross(b);
    let squared = normal.length_squared();
    let is_certain = squared > 0.0 && squared >= LEAST_SINE_SQUARED * a.length_squared() * b.length_squared();
    is_certain.then(|| normal / squared.sqrt())
}

/// Whether a face has zero area beyond doubt; never true for any other face.
fn is_surely_flat([v0, v1, v2]: [Vec3; 3]) -> bool {
    let origin = v0.as_dvec3();
    let (a, b) = (v1.as_dvec3() - origin, v2.as_dvec3() - origin);
    let collapsed = v0 == v1 || v0 == v2 || v1 == v2;
    collapsed || a.cross(b) == DVec3::ZERO && is_exact_in_24_bits(a, v0, v1) && is_exact_in_24_bits(b, v0, v2)
}

/// Plane of a face in integers. `None`: the face has zero area for certain, so it is back from everywhere. All zero: no
/// viewpoint's facing follows from this plane.
pub(crate) fn quantize(corners: [Vec3; 3], frame: &Frame) -> Option<[i16; 4]> {
    match unit_normal(corners) {
        Some(normal) => {
            let offset = -normal.dot(frame.local(corners[0]));
            Some([normal.x, normal.y, normal.z, offset].map(round))
        }
        None => (!is_surely_flat(corners)).then_some([0; 4]),
    }
}

/// Whether `side`, the rounded `to - from`, carries no rounding error (both differences that Knuth's TwoDiff forms are
/// zero) and fits `f32`, so that products of two such sides are exact.
fn is_exact_in_24_bits(side: DVec3, from: Vec3, to: Vec3) -> bool {
    let (from, to) = (from.as_dvec3(), to.as_dvec3());
    side.as_vec3().as_dvec3() == side && to - side == from && side + from == to
}

/// Nearest multiple of `1/K`, in such units.
fn round(value: f64) -> i16 {
    (value * SCALE + 0.5_f64.copysign(value)) as i16
}

/// Faces in a group: their pairs of numbers fill a cache line, and the widest vector of any processor.
pub(crate) const GROUP: usize = 16;

/// Planes of 64 faces, in groups: `N_1 N_2` of sixteen faces, then `N_3 D` of the same sixteen. That is the shape that
/// multiply-add instructions take, and a pass reads memory strictly forwards.
#[derive(Debug, Clone)]
#[repr(align(64))]
pub(crate) struct PlaneBlock([[[i16; 2 * GROUP]; 2]; LANES / GROUP]);

impl Default for PlaneBlock {
    fn default() -> Self {
        Self([[[0; 2 * GROUP]; 2]; LANES / GROUP])
    }
}

impl PlaneBlock {
    pub(crate) fn set(&mut self, lane: usize, [x, y, z, offset]: [i16; 4]) {
        let ([xy, zd], place) = (&mut self.0[lane / GROUP], 2 * (lane % GROUP));
        (xy[place], xy[place + 1], zd[place], zd[place + 1]) = (x, y, z, offset);
    }

    /// `N_1 N_2` and `N_3 D` of each group: a cache line each.
    #[inline(always)]
    pub(crate) fn groups(&self) -> &[[[i16; 2 * GROUP]; 2]; LANES / GROUP] {
        &self.0
    }
}

/// A viewpoint in integers and the bound that goes with it.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub(crate) struct PlaneTest {
    /// `X_1 X_2`, again and again: as many as a group has.
    pub(crate) first: [i16; 2 * GROUP],
    /// `X_3 Q`, likewise.
    pub(crate) second: [i16; 2 * GROUP],
    pub(crate) bound: i32,
}

impl PlaneTest {
    pub(crate) fn new(viewpoint: &Viewpoint, frame: &Frame) -> Self {
        let Some(homogeneous) = homogeneous(viewpoint, frame) else {
            return Self { first: [0; 2 * GROUP], second: [0; 2 * GROUP], bound: i32::MAX };
        };
        let scaled = homogeneous * SCALE;
        let rounded = scaled.round();
        let residual = scaled - rounded;
        let bound = PLANE_ROUNDING * rounded.abs().element_sum()
            + SCALE * (residual.truncate().length() + residual.w.abs())
            + 1.0;
        let [x, y, z, q] = rounded.to_array().map(|value| value as i16);
        let pairs = |a, b| std::array::from_fn(|index| if index % 2 == 0 { a } else { b });
        Self { first: pairs(x, y), second: pairs(z, q), bound: bound.ceil() as i32 }
    }

    /// The same test with another bound, to show what the bound is for.
    #[cfg(test)]
    pub(crate) fn with_bound(self, bound: i32) -> Self {
        Self { bound, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernels::{Baseline, Kernel};
    use proptest::prelude::*;
    use silhouette_core::facing::{Facing, judge};

    const CUBE: [Vec3; 2] = [Vec3::splat(-2.0), Vec3::splat(2.0)];

    /// Facing of one face as far as the test is certain of it.
    fn certain(corners: [Vec3; 3], viewpoint: &Viewpoint, bound: Option<i32>) -> Option<Facing> {
        let frame = Frame::of(CUBE[0], CUBE[1]);
        let test = PlaneTest::new(viewpoint, &frame);
        let test = bound.map_or(test, |bound| test.with_bound(bound));
        let mut block = PlaneBlock::default();
        match quantize(corners, &frame) {
            Some(plane) => block.set(37, plane),
            None => return Some(Facing::Back),
        }
        let [front, back] = Baseline.front_and_back(&test, &block);
        let unsure = !(front | back);
        assert_eq!((front & !(1 << 37), unsure & !(1 << 37)), (0, !(1 << 37)), "lanes are independent");
        (unsure >> 37 & 1 == 0).then_some(if front >> 37 & 1 == 1 { Facing::Front } else { Facing::Back })
    }

    /// Eyes a hair's breadth above and below planes that 16 bits cannot hold: how many certain facings are wrong.
    fn wrong_facings(bound: Option<i32>) -> usize {
        let mut wrong = 0;
        for index in 0..4000_u16 {
            let angle = f64::from(index);
            let corner = |k: f64| DVec3::new((angle + k).sin(), (angle * 0.7 + 2.0 * k).cos(), (angle * 1.3 - k).sin());
            let corners = [corner(0.0), corner(1.0), corner(2.5)].map(DVec3::as_vec3);
            let [a, b, c] = corners.map(Vec3::as_dvec3);
            let normal = (b - a).cross(c - a).normalize_or_zero();
            let height = (f64::from(index % 17) - 8.0) * 1e-6;
            let eye = (a * 2.0 - b + (c - a) * 1.5 + normal * height).as_vec3();
            let viewpoint = Viewpoint::Perspective { eye };
            let facing = certain(corners, &viewpoint, bound);
            wrong += usize::from(facing.is_some_and(|facing| facing != judge(corners, &viewpoint).facing));
        }
        wrong
    }

    #[test]
    fn the_bound_is_what_makes_it_exact() {
        assert_eq!(wrong_facings(None), 0);
        assert!(wrong_facings(Some(0)) > 100, "without a bound these eyes must be misjudged");
    }

    #[test]
    fn zero_area_is_back_only_where_that_is_certain() {
        let frame = Frame::of(CUBE[0], CUBE[1]);
        let (p, q) = (Vec3::new(0.1, 0.7, -0.3), Vec3::new(0.5, 0.25, 0.125));
        assert_eq!(quantize([p, p, q], &frame), None);
        assert_eq!(quantize([Vec3::ZERO, q, q * 2.0], &frame), None);
        let slightly_off = Vec3::new(1.0, 0.5, f32::from_bits(0.25_f32.to_bits() + 1));
        assert_eq!(quantize([Vec3::ZERO, q, slightly_off], &frame), Some([0; 4]), "a needle");
        // The second corner's distance from the first is lost in f64, and with it the area.
        let far = [Vec3::new(1e-30, 0.0, 0.0), Vec3::new(1.0, 0.0, 0.0), Vec3::new(1.0, 1e-30, 0.0)];
        assert_eq!(quantize(far, &frame), Some([0; 4]));
    }

    proptest! {
        #[test]
        fn what_is_certain_is_right(
            corners in prop::array::uniform3(prop::array::uniform3(-2.0_f32..2.0)),
            weights in prop::array::uniform2(-3.0_f32..3.0),
            nudge in prop::array::uniform3(-1e-4_f32..1e-4),
            reach in 0_i32..12,
        ) {
            let corners = corners.map(Vec3::from);
            let [a, b, c] = corners;
            let in_plane = (b - a) * weights[0] + (c - a) * weights[1];
            let eye = a + in_plane * 10.0_f32.powi(reach) + Vec3::from(nudge);
            let direction = in_plane + Vec3::from(nudge);
            for viewpoint in [Viewpoint::Perspective { eye }, Viewpoint::Orthographic { toward_viewer: direction }] {
                if let Some(facing) = certain(corners, &viewpoint, None) {
                    prop_assert_eq!(facing, judge(corners, &viewpoint).facing);
                }
            }
        }
    }
}
