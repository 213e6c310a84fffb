//! [`PlaneBound`]: what all planes of a set of faces have in common, and what follows for a viewpoint.
//!
//! # Bound
//!
//! In the frame of the mesh, let `n_i` be the unit normal of face i and `q_i` a point of it. For any anchor `c`,
//!
//! `s_i = n_i.(p - q_i) = n_i.(p - c) + o_i`, `o_i = n_i.(c - q_i)`.
//!
//! The normals lie in a ball about `m` of radius `rho`, the offsets `o_i` in `low..=high`. With `v = p - c`, and since
//! `|(n_i - m).v| <= rho |v|`,
//!
//! `m.v + low - rho |v| <= s_i <= m.v + high + rho |v|`,
//!
//! so that the sign of all `s_i` is known at once where the left side is above or the right side below zero. This is the
//! anchored cone of Sander et al. (2000) with a ball in place of the cone: every cone about unit normals with half-angle
//! `alpha <= 90` degrees lies in the ball about `cos(alpha) a` of radius `sin(alpha)`, near the silhouette (`m.v` small)
//! both give the same answer, and a ball needs neither the case of obtuse cones nor a second square root.
//!
//! As in the planes' 16-bit test, the viewpoint is homogeneous, `(x, q)` of length 1, which multiplies everything by a
//! positive number and makes one formula of both projections: `v = x - q c`, offsets times `q`.
//!
//! # Rounding
//!
//! `c` and `m` are rounded to `f32` before `rho`, `low` and `high` are found, in `f64`; these are then widened by
//! [`WIDENING`], more than the error of `n_i` (`2^-26`, see the planes), and rounded outwards. Evaluation in `f32` with
//! `|x|, q, |m|, rho, |c| <= 1` and so `|v| <= 2`: `v` is off by at most `4 u` (`u = 2^-24`) and enters with
//! `|m| + rho <= 2`; the scalar product adds `3 u |v|`, the length and its product `5 u |v|`, the sums `6 u`, the product of
//! `q` and an offset `3 u`; 33 u in all, below [`EVALUATION_ERROR`] `= 64 u`.
//!
//! Sets with a face whose plane is not known well enough (needles) have an infinite range of offsets and are never
//! skipped. The outside of a boundary edge and faces of zero area are back from everywhere: `low` is negative infinity.

use glam::DVec3;
use silhouette_core::glam;

/// Added to radius and range before they are rounded; covers the errors of normals and of `f64`.
const WIDENING: f64 = 1e-7;

/// Largest error of an evaluation in `f32`: `2^-18`.
pub(crate) const EVALUATION_ERROR: f32 = 1.0 / (1 << 18) as f32;

/// Steps towards the smallest ball around the normals (Badoiu and Clarkson 2003): the radius is then at most a tenth
/// above the smallest, at a cost well below that of finding the normals.
const BALL_STEPS: u32 = 16;

/// One face, seen from the frame of its mesh.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Side {
    /// A plane.
    Plane {
        /// Unit normal.
        normal: DVec3,
        /// A point of the plane.
        point: DVec3,
    },
    /// Back from everywhere.
    AlwaysBack,
    /// Anything.
    Unknown,
}

/// Bound of the planes of a set of faces. See the [module](self).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PlaneBound {
    pub(crate) anchor: [f32; 3],
    pub(crate) normal: [f32; 3],
    pub(crate) radius: f32,
    pub(crate) low: f32,
    pub(crate) high: f32,
}

impl PlaneBound {
    /// Bound of these faces.
    pub(crate) fn of(sides: &[Side]) -> Self {
        let planes = || {
            sides.iter().filter_map(|side| match *side {
                Side::Plane { normal, point } => Some((normal, point)),
                Side::AlwaysBack | Side::Unknown => None,
            })
        };
        let count = planes().count().max(1) as f64;
        let anchor = (planes().map(|(_, point)| point).sum::<DVec3>() / count).as_vec3();
        let normal = ball_center(&planes().map(|(normal, _)| normal)).as_vec3();
        let (center, about) = (anchor.as_dvec3(), normal.as_dvec3());
        let (mut radius, mut low, mut high) = (0.0_f64, 0.0_f64, 0.0_f64);
        for (normal, point) in planes() {
            let offset = normal.dot(center - point);
            radius = radius.max((normal - about).length());
            (low, high) = (low.min(offset), high.max(offset));
        }
        for side in sides {
            match side {
                Side::Plane { .. } => {}
                Side::AlwaysBack => low = f64::NEG_INFINITY,
                Side::Unknown => (low, high) = (f64::NEG_INFINITY, f64::INFINITY),
            }
        }
        Self::outward(anchor, normal, radius, low, high)
    }

    /// A bound of everything that any of `bounds` holds.
    pub(crate) fn union(bounds: &[Self]) -> Self {
        let anchors = || bounds.iter().map(|bound| glam::Vec3::from(bound.anchor).as_dvec3());
        let normals = || bounds.iter().map(|bound| glam::Vec3::from(bound.normal).as_dvec3());
        let anchor = (anchors().sum::<DVec3>() / bounds.len().max(1) as f64).as_vec3();
        let normal = ball_center(&normals()).as_vec3();
        let (mut radius, mut low, mut high) = (0.0_f64, 0.0_f64, 0.0_f64);
        for ((bound, its_anchor), its_normal) in bounds.iter().zip(anchors()).zip(normals()) {
            // n.(C - q) = n.(c - q) + n.(C - c), and n is in the ball about its own m.
            let shift = anchor.as_dvec3() - its_anchor;
            let (middle, spread) = (its_normal.dot(shift), f64::from(bound.radius) * shift.length());
            radius = radius.max((its_normal - normal.as_dvec3()).length() + f64::from(bound.radius));
            low = low.min(f64::from(bound.low) + middle - spread);
            high = high.max(f64::from(bound.high) + middle + spread);
        }
        Self::outward(anchor, normal, radius, low, high)
    }

    /// Rounds away from the set. A ball that says nothing makes the range infinite, so that `radius <= 1` always.
    fn outward(anchor: glam::Vec3, normal: glam::Vec3, radius: f64, low: f64, high: f64) -> Self {
        let says_nothing = radius + WIDENING >= 1.0;
        let (low, high) = if says_nothing { (f64::NEG_INFINITY, f64::INFINITY) } else { (low, high) };
        Self {
            anchor: anchor.into(),
            normal: normal.into(),
            radius: if says_nothing { 1.0 } else { ((radius + WIDENING) as f32).next_up() },
            low: ((low - WIDENING) as f32).next_down(),
            high: ((high + WIDENING) as f32).next_up(),
        }
    }
}

/// A point from which the farthest of some points is hardly farther than need be.
fn ball_center<I: Iterator<Item = DVec3> + Clone>(points: &I) -> DVec3 {
    let count = points.clone().count().max(1) as f64;
    let mut center = points.clone().sum::<DVec3>() / count;
    for step in 0..BALL_STEPS {
        let farthest =
            points.clone().max_by(|a, b| center.distance_squared(*a).total_cmp(&center.distance_squared(*b)));
        center += (farthest.unwrap_or(center) - center) / f64::from(step + 2);
    }
    center
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Whether `bound` claims all faces front, or all back, from a viewpoint of length 1.
    fn claims(bound: &PlaneBound, direction: DVec3, weight: f64) -> [bool; 2] {
        let v = direction - weight * glam::Vec3::from(bound.anchor).as_dvec3();
        let along = glam::Vec3::from(bound.normal).as_dvec3().dot(v);
        let reach = f64::from(bound.radius) * v.length();
        let offset = |value: f32| weight * f64::from(value);
        [along + offset(bound.low) - reach > 0.0, along + offset(bound.high) + reach < 0.0]
    }

    fn unit_vector() -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-1.0..1.0_f64).prop_map(|v| (DVec3::from(v) + DVec3::X * 1e-9).normalize())
    }

    fn bundle() -> impl Strategy<Value = Vec<(DVec3, DVec3)>> {
        let plane = (unit_vector(), unit_vector(), 0.0..1.0_f64);
        (unit_vector(), prop::collection::vec(plane, 1..12), 0.0..0.9_f64).prop_map(|(axis, planes, spread)| {
            let near =
                |(n, q, r): (DVec3, DVec3, f64)| ((axis + n * spread).normalize(), (axis + q * spread) * 0.5 * r);
            planes.into_iter().map(near).collect()
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        #[test]
        fn what_a_bound_claims_holds_for_every_face(
            bundles in prop::collection::vec(bundle(), 1..4), point in prop::array::uniform3(-4.0..4.0_f64), weight in 0.0..1.0_f64,
        ) {
            let homogeneous = DVec3::from(point).extend(weight).normalize();
            let (direction, weight) = (homogeneous.truncate(), homogeneous.w);
            let sides = |bundle: &[(DVec3, DVec3)]| -> Vec<Side> {
                bundle.iter().map(|&(normal, point)| Side::Plane { normal, point }).collect()
            };
            let bounds: Vec<_> = bundles.iter().map(|bundle| PlaneBound::of(&sides(bundle))).collect();
            let whole = PlaneBound::union(&bounds);
            for (bundle, bound) in bundles.iter().zip(&bounds) {
                for &(normal, point) in bundle {
                    let value = normal.dot(direction) - weight * normal.dot(point);
                    for [all_front, all_back] in [claims(bound, direction, weight), claims(&whole, direction, weight)] {
                        prop_assert!(!all_front || value > 0.0, "{value}");
                        prop_assert!(!all_back || value < 0.0, "{value}");
                    }
                }
            }
        }
    }

    #[test]
    fn faces_that_can_be_anything_and_faces_that_never_are_front() {
        let plane = Side::Plane { normal: DVec3::Z, point: DVec3::ZERO };
        let above = |bound: &PlaneBound| claims(bound, DVec3::Z, 0.1);
        let below = |bound: &PlaneBound| claims(bound, DVec3::NEG_Z, 0.1);
        let plain = PlaneBound::of(&[plane]);
        assert_eq!((above(&plain), below(&plain)), ([true, false], [false, true]));
        let edge_of_surface = PlaneBound::of(&[plane, Side::AlwaysBack]);
        assert_eq!((above(&edge_of_surface), below(&edge_of_surface)), ([false, false], [false, true]));
        for doubtful in
            [PlaneBound::of(&[plane, Side::Unknown]), PlaneBound::union(&[plain, PlaneBound::of(&[Side::Unknown])])]
        {
            assert_eq!((above(&doubtful), below(&doubtful)), ([false, false], [false, false]));
        }
    }
}
