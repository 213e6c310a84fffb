//! Eq. 8, the number of samples: as printed it misses its tolerance.

use silhouette_core::glam::{DMat4, DVec2, DVec3};
use silhouette_smoothing::sampling::{MAX_SEGMENTS, Sampling, segments};
use silhouette_smoothing::{Eye, Hermite, SmoothingView};

/// Central angles of arcs in degrees.
pub const ARCS_DEG: [f64; 8] = [1.0, 10.0, 30.0, 60.0, 90.0, 120.0, 150.0, 170.0];

/// Smallest and largest chord in pixels, and how many lie between.
pub const CHORDS_PX: [f64; 2] = [0.6, 2000.0];
const CHORDS: u32 = 120;

/// Tolerance in pixels.
const TOLERANCE_PX: f64 = 1.0;

/// Points per straight segment that are compared with the curve.
const POINTS: u32 = 16;

/// What a law does with arcs of one angle, over all chords.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampled {
    /// Largest distance between curve and polyline, over the tolerance.
    pub worst: f64,
    /// Most segments more than the least number that keeps the tolerance.
    pub most_spare: u32,
}

/// Samples arcs of an angle, whose image is not foreshortened, by a law.
pub fn sampled(arc_deg: f64, law: Sampling) -> Sampled {
    let angle = arc_deg.to_radians();
    let mut found = Sampled { worst: 0.0, most_spare: 0 };
    for index in 0..=CHORDS {
        let chord = CHORDS_PX[0] * (CHORDS_PX[1] / CHORDS_PX[0]).powf(f64::from(index) / f64::from(CHORDS));
        let radius = chord / (2.0 * (0.5 * angle).sin());
        let [from, to] = [0.0, angle].map(|angle| DVec2::from_angle(angle).extend(0.0));
        let curve = Hermite::along([radius * from, radius * to], [from, to].map(|radial| DVec3::Z.cross(radial)));
        let count = segments(&curve, [from, to], &pixels(), TOLERANCE_PX, law);
        found.worst = found.worst.max(farthest(&curve, count) / TOLERANCE_PX);
        let least = (1..=MAX_SEGMENTS).find(|&count| farthest(&curve, count) <= TOLERANCE_PX).unwrap_or(MAX_SEGMENTS);
        found.most_spare = found.most_spare.max(count.saturating_sub(least));
    }
    found
}

/// A view along z in which one unit is one pixel.
fn pixels() -> SmoothingView {
    SmoothingView::new(Eye::new(DVec3::Z.extend(0.0)), DMat4::IDENTITY, [2; 2])
}

/// Largest distance of a curve from its polyline of `count` segments.
fn farthest(curve: &Hermite, count: u32) -> f64 {
    let at = |step: u32| curve.point(f64::from(step) / f64::from(count * POINTS));
    let mut farthest = 0.0_f64;
    for segment in 0..count {
        let [from, to] = [segment, segment + 1].map(|end| at(end * POINTS));
        let Some(along) = (to - from).try_normalize() else { continue };
        for point in 1..POINTS {
            farthest = farthest.max((at(segment * POINTS + point) - from).reject_from(along).length());
        }
    }
    farthest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_printed_law_misses_its_tolerance_and_the_bound_keeps_it() {
        for arc_deg in ARCS_DEG {
            let [guaranteed, printed] = [Sampling::Guaranteed, Sampling::AsPrinted].map(|law| sampled(arc_deg, law));
            assert!(guaranteed.worst <= 1.0 + 1e-9 && guaranteed.most_spare <= 8, "{arc_deg}: {guaranteed:?}");
            assert!(printed.worst > 4.0, "{arc_deg}: {printed:?}");
        }
    }

    /// A third of a unit circle by one segment is off by its sagitta.
    #[test]
    fn distances_are_those_of_the_sagitta() {
        let ends = [0.0, 2.0 * std::f64::consts::FRAC_PI_3].map(|angle| DVec2::from_angle(angle).extend(0.0));
        let curve = Hermite::along(ends, ends.map(|radial| DVec3::Z.cross(radial)));
        assert!((farthest(&curve, 1) - 0.5).abs() < 1e-9);
    }
}
