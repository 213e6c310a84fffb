//! [`Hermite`]: the cubic of Eq. 5, with tangents as long as Eq. 4 has them.

use crate::rounding::rounded;
use silhouette_core::curves::{CurveKind, CurveSource, SmoothPiece};
use silhouette_core::glam::DVec3;

/// A cubic curve by its ends and its derivatives there (Eq. 5). Object space, 64 bits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hermite {
    /// Where it begins and ends.
    pub ends: [DVec3; 2],
    /// Derivatives by the parameter at both ends (the paper's T1 and T2).
    pub tangents: [DVec3; 2],
}

/// A direction whose share of the chord is below this is noise: the chord takes its place.
const LEAST_SHARE: f64 = 1e-6;

impl Hermite {
    /// The curve between two points that leaves and arrives along two directions of any length, close to an arc of a circle
    /// where both are tangents of one: Eq. 4 as 4 R tan(φ / 4), φ being the central angle.
    ///
    /// A direction of no length is replaced by the chord's. No direction may be opposite to the chord.
    #[inline]
    pub fn along(ends: [DVec3; 2], directions: [DVec3; 2]) -> Self {
        let chord = ends[1] - ends[0];
        // Pairs are written out here and in the other steps of a frame: mapped, they would be a call for each half, a tenth of the time.
        Self { ends, tangents: [tangent(chord, directions[0]), tangent(chord, directions[1])] }
    }

    /// The point at a parameter from 0 to 1. The ends are met exactly.
    #[inline]
    pub fn point(&self, u: f64) -> DVec3 {
        let ([from, to], [leaving, arriving]) = (self.ends, self.tangents);
        if u >= 1.0 {
            return to;
        }
        let chord = to - from;
        let bend = u * (1.0 - u) * ((1.0 - u) * (leaving - chord) - u * (arriving - chord));
        from + u * chord + bend
    }

    /// The derivative by the parameter.
    #[inline]
    pub fn derivative(&self, u: f64) -> DVec3 {
        let ([from, to], [leaving, arriving]) = (self.ends, self.tangents);
        let chord = to - from;
        let (a, b) = (leaving - chord, arriving - chord);
        chord + (1.0 - u) * (1.0 - 3.0 * u) * a + u * (3.0 * u - 2.0) * b
    }

    /// Control points of the same curve as a Bézier curve.
    pub fn control(&self) -> [DVec3; 4] {
        let ([from, to], [leaving, arriving]) = (self.ends, self.tangents);
        [from, from + leaving / 3.0, to - arriving / 3.0, to]
    }

    /// The same curve, traversed the other way.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let ([from, to], [leaving, arriving]) = (self.ends, self.tangents);
        Self { ends: [to, from], tangents: [-arriving, -leaving] }
    }

    /// The same curve as a piece of a chain, rounded to 32 bits.
    pub fn piece(&self, kind: CurveKind, source: CurveSource) -> SmoothPiece {
        SmoothPiece { control: self.control().map(rounded), kind, source }
    }
}

/// The tangent along a direction, in the length of Eq. 4.
#[inline]
fn tangent(chord: DVec3, direction: DVec3) -> DVec3 {
    let square = chord.length_squared();
    let size_squared = direction.length_squared();
    if size_squared.is_nan() || size_squared <= LEAST_SHARE * LEAST_SHARE * square {
        return chord;
    }
    // 2 |chord| / (1 + cosine) over the size of the direction, with one root and one division.
    let factor = 2.0 * square / ((size_squared * square).sqrt() + chord.dot(direction));
    // Away from a chord without length there is no cosine, and nothing to interpolate.
    if factor.is_nan() { chord } else { direction * factor }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An arc of the unit circle with a central angle in degrees.
    fn arc(degrees: f64) -> Hermite {
        let angle = degrees.to_radians();
        let at = |a: f64| DVec3::new(a.cos(), a.sin(), 0.0);
        Hermite::along([at(0.0), at(angle)], [DVec3::Y, DVec3::new(-angle.sin(), angle.cos(), 0.0)])
    }

    fn radius_error(curve: &Hermite) -> f64 {
        (0..=200).map(|i| (curve.point(f64::from(i) / 200.0).length() - 1.0).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn arcs_are_off_by_the_known_share_of_their_radius() {
        for (degrees, low, high) in [
            (30.0, 3e-7, 4e-7),
            (60.0, 2.3e-5, 2.5e-5),
            (90.0, 2.6e-4, 2.8e-4),
            (150.0, 5e-3, 7e-3),
            (180.0, 1.7e-2, 1.9e-2),
        ] {
            let error = radius_error(&arc(degrees));
            assert!((low..high).contains(&error), "{degrees} degrees: {error}");
        }
    }

    #[test]
    fn the_middle_of_an_arc_is_on_the_circle() {
        for degrees in [1.0, 45.0, 120.0, 179.0] {
            assert!((arc(degrees).point(0.5).length() - 1.0).abs() < 1e-12, "{degrees}");
        }
    }

    #[test]
    fn tangents_are_as_long_as_the_law_of_arcs_says() {
        let degrees: f64 = 70.0;
        let expected = 4.0 * (degrees.to_radians() / 4.0).tan();
        assert!(arc(degrees).tangents.iter().all(|tangent| (tangent.length() - expected).abs() < 1e-12));
    }

    #[test]
    fn control_points_and_derivatives_are_of_the_same_curve() {
        let curve = Hermite {
            ends: [DVec3::new(1.0, 0.0, 2.0), DVec3::new(-1.0, 3.0, 0.5)],
            tangents: [DVec3::new(0.0, 4.0, 1.0), DVec3::new(2.0, -1.0, 1.0)],
        };
        let [a, b, c, d] = curve.control();
        let back = curve.reversed();
        for u in [0.0, 0.2, 0.5, 0.9, 1.0] {
            let v = 1.0 - u;
            let bezier = v * v * v * a + 3.0 * v * v * u * b + 3.0 * v * u * u * c + u * u * u * d;
            assert!(bezier.distance(curve.point(u)) < 1e-12);
            assert!(back.point(v).distance(curve.point(u)) < 1e-12);
            let slope = (curve.point(u.min(1.0 - 1e-6) + 1e-6) - curve.point(u.min(1.0 - 1e-6))) / 1e-6;
            assert!(slope.distance(curve.derivative(u)) < 1e-4);
        }
        assert_eq!((curve.point(0.0), curve.point(1.0)), (curve.ends[0], curve.ends[1]));
    }

    #[test]
    fn no_direction_and_no_chord_make_no_nan() {
        let straight = Hermite::along([DVec3::ZERO, DVec3::X], [DVec3::ZERO; 2]);
        assert!(straight.point(0.25).distance(DVec3::new(0.25, 0.0, 0.0)) < 1e-15);
        let point = Hermite::along([DVec3::ONE; 2], [DVec3::X, DVec3::ZERO]);
        assert_eq!(point.point(0.3), DVec3::ONE);
    }
}
