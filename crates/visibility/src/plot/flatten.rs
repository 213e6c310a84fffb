//! Paths as points alone, for formats without curves.

use super::paths::{Path, Segment};
use silhouette_core::glam::DVec2;

/// Calls back with the points of a path in order, the first again at the end of a closed one. Chords lie within `tolerance`
/// (page units, above 0) of their curves. O(points + chords).
///
/// On a chord over a share `1 / n` of the parameter, a curve strays by at most `1 / (8 n^2)` of its largest second derivative,
/// which is 6 times the larger second difference of its control points.
pub fn flatten(path: Path<'_>, tolerance: f64, mut point: impl FnMut(DVec2)) {
    point(path.start());
    for segment in path.segments() {
        let chords = chords(&segment, tolerance);
        (1..=chords).for_each(|chord| point(segment.at(f64::from(chord) / f64::from(chords))));
    }
}

/// How many chords of equal shares of its parameter keep within `tolerance` of a segment: 1 of a straight one.
pub fn chords(segment: &Segment, tolerance: f64) -> u32 {
    let Some([a, b]) = segment.handles else { return 1 };
    let second = |one: DVec2, middle: DVec2, other: DVec2| (one - 2.0 * middle + other).length();
    let bend = second(segment.from, a, b).max(second(a, b, segment.to));
    // Saturates; a NaN is 0.
    ((6.0 * bend / (8.0 * tolerance)).sqrt().ceil() as u32).clamp(1, MOST_CHORDS)
}

/// More would be shorter than a plotter's step even on a page of ten metres.
const MOST_CHORDS: u32 = 4096;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chords_keep_to_their_curve() {
        let points = [DVec2::ZERO, DVec2::new(100.0, 0.0), DVec2::new(50.0, 50.0)];
        let handles = [
            [DVec2::new(0.0, 80.0), DVec2::new(90.0, -70.0)],
            [DVec2::new(100.0, 0.0), DVec2::new(50.0, 50.0)],
            [DVec2::new(10.0, 300.0), DVec2::new(-40.0, 1.0)],
        ];
        let path = Path { closed: true, points: &points, handles: &handles };
        for tolerance in [1.0, 0.0125] {
            let mut flat = Vec::new();
            flatten(path, tolerance, |point| flat.push(point));
            assert_eq!((flat[0], flat[flat.len() - 1]), (points[0], points[0]));
            assert!(points.iter().all(|point| flat.contains(point)));
            for segment in path.segments() {
                for share in (0..=1000).map(|step| f64::from(step) / 1000.0) {
                    let on_curve = segment.at(share);
                    let distance = |ends: &[DVec2]| {
                        let way = ends[1] - ends[0];
                        let t = ((on_curve - ends[0]).dot(way) / way.length_squared()).clamp(0.0, 1.0);
                        on_curve.distance(ends[0] + t * way)
                    };
                    let nearest = flat.windows(2).map(distance).fold(f64::INFINITY, f64::min);
                    assert!(nearest <= tolerance * 1.001, "{nearest} above {tolerance}");
                }
            }
        }
    }

    #[test]
    fn straight_paths_keep_their_points() {
        let points = [DVec2::ZERO, DVec2::X, DVec2::Y];
        let mut flat = Vec::new();
        flatten(Path { closed: false, points: &points, handles: &[] }, 0.01, |point| flat.push(point));
        assert_eq!(flat, points);
    }
}
