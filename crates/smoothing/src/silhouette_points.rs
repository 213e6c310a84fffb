//! Section III-D: on each bridge between a visible and an invisible vertex, the point at which the interpolated normal is
//! perpendicular to the view.
//!
//! Departures:
//!
//! 1. Eq. 7 leads to a quadratic equation, whose textbook solution loses all digits where the eye is far away. It is solved for
//!    u / (1 - u), of which exactly one root is positive and free of cancellation.
//! 2. Unless the option `newton` is 0, steps of Newton's method on (S(u) - E) . N(u) = 0 with the bridge S itself, guarded by bisection, replace
//!    the approximation of Eq. 7.
//! 3. Where the interpolated normal vanishes, the direction across the chord in the plane of the view takes its place.
//! 4. With Newton's method points emerge from the ends of bridges and do not appear away from them ([`emerging_points`]).
//!
//! [`emerging_points`]: crate::emerging_points

use crate::emerging_points::{beside_bridge, evened};
use crate::eye::Eye;
use crate::feature_segments::FeatureSegment;
use crate::hermite::Hermite;
use silhouette_core::glam::DVec3;

/// A curve with a silhouette point on it.
pub trait Bridge {
    /// Whether faces meet in it at an angle, so that no point may lie beside it.
    const IS_SHARP: bool;

    /// The point at a parameter from 0 to 1.
    fn point(&self, u: f64) -> DVec3;

    /// The derivative by the parameter.
    fn derivative(&self, u: f64) -> DVec3;
}

impl Bridge for Hermite {
    const IS_SHARP: bool = false;

    fn point(&self, u: f64) -> DVec3 {
        self.point(u)
    }

    fn derivative(&self, u: f64) -> DVec3 {
        self.derivative(u)
    }
}

impl Bridge for FeatureSegment {
    const IS_SHARP: bool = true;

    fn point(&self, u: f64) -> DVec3 {
        self.point(u)
    }

    fn derivative(&self, u: f64) -> DVec3 {
        self.derivative(u)
    }
}

/// A point of the silhouette, on a bridge or close to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SilhouettePoint {
    /// Parameter on the bridge, from 0 to 1.
    pub u: f64,
    /// Where it is.
    pub position: DVec3,
    /// Unit normal of the surface there.
    pub normal: DVec3,
}

/// An interpolated normal shorter than this has no direction.
const LEAST_NORMAL: f64 = 1e-6;

/// A residual angle, in radians, below the rounding of positions to 32 bits: Newton's method has nothing left to improve.
const CONVERGED: f64 = 1e-8;

/// A step after which no other is needed: it leaves about half its square, which is below [`CONVERGED`].
const SHORT_STEP: f64 = 1e-4;

/// The silhouette point of a bridge, given the vertices below its ends with their unit normals, of which exactly one is visible,
/// and the number of Newton steps. O(1).
pub fn silhouette_point(
    positions: [DVec3; 2],
    normals: [DVec3; 2],
    bridge: &impl Bridge,
    eye: Eye,
    newton_steps: u32,
) -> SilhouettePoint {
    let toward = [eye.toward(positions[0]), eye.toward(positions[1])];
    let signs = [toward[0].dot(normals[0]), toward[1].dot(normals[1])];
    let mut u = if eye.position().is_none() {
        linear_root(signs)
    } else {
        quadratic_root(signs[0], toward[0].dot(normals[1]) + toward[1].dot(normals[0]), signs[1])
    };
    if eye.position().is_some() && newton_steps > 0 {
        u = refined(u, signs[0] >= 0.0, normals, bridge, eye, newton_steps);
        if let Some(even) = evened(u, signs) {
            return beside_bridge(even, positions, normals, bridge, eye);
        }
    }
    let position = bridge.point(u);
    let mut normal = normals[0].lerp(normals[1], u);
    if normal.length_squared() < LEAST_NORMAL * LEAST_NORMAL {
        normal = eye.toward(position).cross(positions[1] - positions[0]);
    }
    SilhouettePoint { u, position, normal: normal.normalize_or_zero() }
}

/// The root of a function that is linear between two values of opposite signs.
#[inline]
fn linear_root([from, to]: [f64; 2]) -> f64 {
    let u = from / (from - to);
    if u.is_nan() { 0.5 } else { u.clamp(0.0, 1.0) }
}

/// The root in [0, 1] of (1 - u)² a + u (1 - u) b + u² c, where a and c have opposite signs and an `a` of 0 counts as positive.
///
/// With s = u / (1 - u) this is c s² + b s + a = 0, whose roots have opposite signs.
#[inline]
fn quadratic_root(a: f64, b: f64, c: f64) -> f64 {
    let root = (b * b - 4.0 * a * c).max(0.0).sqrt();
    let q = -0.5 * (b + root.copysign(b));
    let u = if q == 0.0 {
        // b is 0 and one of the others too.
        if a == 0.0 { 0.0 } else { 1.0 }
    } else if (q > 0.0) == (a < 0.0) {
        q / (q + c)
    } else {
        a / (a + q)
    };
    if u.is_nan() { 0.5 } else { u.clamp(0.0, 1.0) }
}

/// The root of (E - S(u)) . N(u), which is positive at 0 iff `begins_visible` and has the other sign at 1.
fn refined(mut u: f64, begins_visible: bool, normals: [DVec3; 2], bridge: &impl Bridge, eye: Eye, steps: u32) -> f64 {
    let turn = normals[1] - normals[0];
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..steps {
        let (toward, normal) = (eye.toward(bridge.point(u)), normals[0] + u * turn);
        let value = toward.dot(normal);
        if value * value <= CONVERGED * CONVERGED * toward.length_squared() {
            break;
        }
        if (value > 0.0) == begins_visible {
            low = u;
        } else {
            high = u;
        }
        // The eye stands still, the point moves.
        let slope = toward.dot(turn) - bridge.derivative(u).dot(normal);
        let next = u - value / slope;
        let from = u;
        u = if next > low && next < high { next } else { 0.5 * (low + high) };
        if (u - from).abs() <= SHORT_STEP {
            break;
        }
    }
    u
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bridges::bridge;
    use proptest::prelude::*;
    use silhouette_core::glam::Vec3;
    use silhouette_core::view::Viewpoint;

    fn sphere_ends() -> [DVec3; 2] {
        [DVec3::new(0.3, 0.1, 1.0).normalize(), DVec3::new(0.1, 0.95, -0.1).normalize()]
    }

    /// Degrees by which the normal of a point is off the perpendicular to the view.
    fn residual_deg(point: &SilhouettePoint, eye: Eye) -> f64 {
        eye.toward(point.position).normalize().dot(point.normal).asin().to_degrees().abs()
    }

    #[test]
    fn each_newton_step_comes_closer() {
        let ends = sphere_ends();
        let eye = Eye::from(Viewpoint::Perspective { eye: Vec3::new(0.0, 0.0, 1.3) });
        let found = [0, 1, 2, 3, 5]
            .map(|steps| residual_deg(&silhouette_point(ends, ends, &bridge(ends, ends), eye, steps), eye));
        assert!(found[0] > 0.5 && found.is_sorted_by(|a, b| a >= b) && found[4] < 1e-6, "{found:?}");
    }

    #[test]
    fn in_parallel_projection_the_equation_is_linear_and_exact() {
        let ends = sphere_ends();
        let eye = Eye::from(Viewpoint::Orthographic { toward_viewer: Vec3::Z });
        let point = silhouette_point(ends, ends, &bridge(ends, ends), eye, 0);
        assert!(point.normal.z.abs() < 1e-12);
    }

    #[test]
    fn ties_pick_the_limit() {
        for ([a, b, c], expected) in
            [([0.0, -1.0, -1.0], 0.0), ([0.0, 1.0, -1.0], 0.5), ([-1.0, 0.0, 0.0], 1.0), ([0.0, 0.0, -1.0], 0.0)]
        {
            assert!((quadratic_root(a, b, c) - expected).abs() < 1e-15, "{a} {b} {c}");
        }
        assert!(
            (quadratic_root(1e-14, 1.0, -1.0) - 0.5).abs() < 1e-12,
            "the limit from the side where both signs differ"
        );
    }

    #[test]
    fn normals_that_cancel_leave_a_direction_across_the_view() {
        let positions = [DVec3::ZERO, DVec3::X];
        let normals = [DVec3::Z, DVec3::NEG_Z];
        let eye = Eye::from(Viewpoint::Orthographic { toward_viewer: Vec3::Z });
        let point = silhouette_point(positions, normals, &bridge(positions, [DVec3::ZERO; 2]), eye, 0);
        assert!((point.normal.length() - 1.0).abs() < 1e-12 && point.normal.z.abs() < 1e-12);
    }

    proptest! {
        #[test]
        fn the_root_is_one_and_does_not_depend_on_the_direction(
            a in 0.0..1.0_f64, b in -2.0..2.0_f64, c in -1.0..0.0_f64, size in -12..12_i32,
        ) {
            let scale = 10_f64.powi(size);
            let u = quadratic_root(a * scale, b * scale, c * scale);
            let value = (1.0 - u).powi(2) * a + u * (1.0 - u) * b + u * u * c;
            prop_assert!((0.0..=1.0).contains(&u) && value.abs() < 1e-12, "{u}: {value}");
            if a > 0.0 {
                prop_assert!((quadratic_root(c * scale, b * scale, a * scale) - (1.0 - u)).abs() < 1e-9);
            }
        }

        /// Far eyes must not cost digits: the textbook formula is unusable from about 1e7 radii.
        #[test]
        fn far_eyes_are_the_limit_of_parallel_projection(distance in 4.0..12.0_f64) {
            let ends = sphere_ends();
            let eye = Eye::new((DVec3::Z * 10_f64.powf(distance)).extend(1.0));
            let parallel = Eye::new(DVec3::Z.extend(0.0));
            let [far, limit] = [eye, parallel].map(|eye| silhouette_point(ends, ends, &bridge(ends, ends), eye, 0).u);
            prop_assert!((far - limit).abs() < 2.0 * 10_f64.powf(-distance) + 1e-12, "{far} {limit}");
        }
    }
}
