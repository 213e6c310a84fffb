//! Step 8, fit: cubic Bezier curves take the place of straight segments that turn little.
//!
//! The silhouette of a mesh is a polygon, even where the thing is round. Between corners, which stay, a curve is led past its points,
//! the quadratic B-spline that touches its segments, and as few cubics as follow that curve are fitted to it: R. Levien's fit of
//! tangents, area and moment, by the crate `kurbo`. What does not keep to the tolerance, measured in both directions, stays a polygon.

use super::paths::{Path, Paths, Segment};
use kurbo::simplify::SimplifyBezPath;
use kurbo::{BezPath, PathSeg, Point, fit_to_bezpath};
use silhouette_core::glam::DVec2;

/// Most segments that are fitted at once, which bounds the work of measuring.
const MOST_SEGMENTS: usize = 128;

/// Chords per cubic along which distances are measured.
const CHORDS: u32 = 16;

/// The shares of the tolerance that the curve past the points and the fit to it may use.
const LED_SHARE: f64 = 0.5;
const FIT_SHARE: f64 = 0.5;

/// Largest angle at which a path turns in a point that is no corner.
const SHARPEST: f64 = std::f64::consts::FRAC_PI_2;

/// Least tolerance in page units: a thousandth of a millimetre, the last decimal of files.
const LEAST_TOLERANCE: f64 = 0.001;

/// Fits curves to straight paths: no point of a curve lies farther than `tolerance` (page units) from the path, and no point of the
/// path farther from the curve. Paths of which nothing is curved stay as they are. O(points), expected.
pub fn fit(paths: &Paths, tolerance: f64) -> Paths {
    let tolerance = tolerance.max(LEAST_TOLERANCE);
    let mut fitted = Paths::default();
    for path in paths.iter() {
        let curves = if path.handles.is_empty() { fit_path(path, tolerance) } else { None };
        match curves {
            Some(segments) => {
                fitted.begin();
                segments.iter().for_each(|segment| fitted.extend(segment));
                // One curve that ends where it begins has two points all the same.
                let closed = path.closed && segments.len() > 1;
                if closed {
                    fitted.drop_repeated_point();
                }
                fitted.finish(closed);
            }
            None => fitted.push(path),
        }
    }
    fitted
}

/// The curves that take the place of a path; `None` where nothing of it is curved.
fn fit_path(path: Path<'_>, tolerance: f64) -> Option<Vec<Segment>> {
    let mut points: Vec<DVec2> = path.points.to_vec();
    points.dedup();
    let count = points.len();
    let around = |index: usize| [(index + count - 1) % count, index, (index + 1) % count].map(|index| points[index]);
    let is_end = |index: usize| !path.closed && (index == 0 || index + 1 == count);
    let is_corner: Vec<bool> = (0..count).map(|index| is_end(index) || is_corner(around(index), tolerance)).collect();
    if count < 3 || !is_corner.contains(&false) {
        return None;
    }
    // From a corner on, if there is one; around a closed path the first point is met again as the last.
    let first = is_corner.iter().position(|is_corner| *is_corner);
    let begin = first.unwrap_or(0);
    let last = if path.closed { count } else { count - 1 };
    let at = |step: usize| points[(begin + step) % count];
    let mut curves = Vec::new();
    let mut run = if first.is_some() { vec![at(0)] } else { vec![at(0).midpoint(at(1))] };
    for step in 1..last {
        run.push(at(step));
        let middle = at(step).midpoint(at(step + 1));
        if is_corner[(begin + step) % count] {
            fit_run(&run, tolerance, &mut curves);
            run = vec![at(step)];
        } else if run.len() > MOST_SEGMENTS {
            run.push(middle);
            fit_run(&run, tolerance, &mut curves);
            run = vec![middle];
        }
    }
    run.push(at(last));
    if first.is_none() {
        run.push(at(0).midpoint(at(1)));
    }
    fit_run(&run, tolerance, &mut curves);
    Some(curves)
}

/// Whether a curve that is led past a point from the middle of the segment before to that of the segment after would stray too far.
fn is_corner([before, at, after]: [DVec2; 3], tolerance: f64) -> bool {
    let [from, to] = [before.midpoint(at), at.midpoint(after)];
    let is_sharp = (at - before).angle_to(after - at).abs() > SHARPEST;
    is_sharp || at.distance(from.midpoint(to)) * 0.5 > tolerance * LED_SHARE
}

/// Appends curves for a run of points, the first and the last of which they keep.
fn fit_run(run: &[DVec2], tolerance: f64, out: &mut Vec<Segment>) {
    let straight: Vec<[DVec2; 2]> = run.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let led = led_past(run);
    if let [only] = led[..] {
        return out.push(only);
    }
    let mut path = BezPath::new();
    path.move_to(point(led[0].from));
    for segment in &led {
        let [a, b] = segment.handles.unwrap_or([segment.from, segment.to]);
        path.curve_to(point(a), point(b), point(segment.to));
    }
    let fitted = fit_to_bezpath(&SimplifyBezPath::new(&path), tolerance * FIT_SHARE);
    let mut fitted: Vec<Segment> = fitted.segments().map(from_kurbo).collect();
    // The fit turns its curves, which rounds their ends.
    if let (Some(first), Some(&begin)) = (fitted.first_mut(), run.first()) {
        first.from = begin;
    }
    if let (Some(last), Some(&end)) = (fitted.last_mut(), run.last()) {
        last.to = end;
    }
    if !fitted.is_empty() && is_near(&fitted, &straight, tolerance) {
        out.extend(fitted);
    } else if is_near(&led, &straight, tolerance) {
        out.extend(led);
    } else {
        out.extend(straight.iter().map(|&[from, to]| through(from, from.midpoint(to), to)));
    }
}

/// The quadratic B-spline of a run: it touches each segment in its middle, and does not turn where the run does not.
fn led_past(run: &[DVec2]) -> Vec<Segment> {
    let middle = |index: usize| run[index].midpoint(run[index + 1]);
    let last = run.len() - 1;
    if last == 1 {
        return vec![through(run[0], middle(0), run[1])];
    }
    let inner = (1..last).map(|index| {
        let from = if index == 1 { run[0] } else { middle(index - 1) };
        let to = if index + 1 == last { run[last] } else { middle(index) };
        through(from, run[index], to)
    });
    inner.collect()
}

/// A quadratic curve as a cubic.
fn through(from: DVec2, control: DVec2, to: DVec2) -> Segment {
    Segment { from, to, handles: Some([from, to].map(|end| end.lerp(control, 2.0 / 3.0))) }
}

/// Whether curves and straight segments between the same ends lie within a tolerance of each other, in both directions.
fn is_near(curves: &[Segment], straight: &[[DVec2; 2]], tolerance: f64) -> bool {
    let samples = curves.iter().flat_map(|curve| {
        (0..CHORDS).map(move |chord| [chord, chord + 1].map(|end| curve.at(f64::from(end) / f64::from(CHORDS))))
    });
    let chords: Vec<[DVec2; 2]> = samples.collect();
    let is_covered = |points: &[[DVec2; 2]], by: &[[DVec2; 2]]| {
        points
            .iter()
            .flat_map(|&[from, to]| [from, from.midpoint(to), to])
            .all(|at| at.is_finite() && by.iter().any(|&[from, to]| super::cover::distance(at, from, to) <= tolerance))
    };
    is_covered(&chords, straight) && is_covered(straight, &chords)
}

fn point(at: DVec2) -> Point {
    Point::new(at.x, at.y)
}

fn from_kurbo(segment: PathSeg) -> Segment {
    let cubic = segment.to_cubic();
    let [from, a, b, to] = [cubic.p0, cubic.p1, cubic.p2, cubic.p3].map(|at| DVec2::new(at.x, at.y));
    Segment { from, to, handles: Some([a, b]) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn polygon(points: &[DVec2], closed: bool) -> Paths {
        let mut paths = Paths::default();
        paths.push(Path { closed, points, handles: &[] });
        paths
    }

    fn circle(count: u32) -> Vec<DVec2> {
        (0..count)
            .map(|at| DVec2::from_angle(f64::from(at) / f64::from(count) * std::f64::consts::TAU) * 50.0)
            .collect()
    }

    #[test]
    fn a_fine_polygon_around_a_circle_becomes_a_few_curves() {
        let fitted = fit(&polygon(&circle(180), true), 0.05);
        let path = fitted.get(0);
        assert!(path.closed && path.segment_count() <= 16, "{}", path.segment_count());
        let radii = path.segments().flat_map(|curve| (0..=20).map(move |at| curve.at(f64::from(at) / 20.0).length()));
        assert!(radii.into_iter().all(|radius| (radius - 50.0).abs() < 0.05));
        // Where they meet, they have one direction.
        for (index, one) in path.segments().enumerate() {
            let other = path.segment((index + 1) % path.segment_count());
            let [leaving, arriving] = [other.handles.unwrap()[0] - other.from, one.to - one.handles.unwrap()[1]];
            assert!(leaving.angle_to(arriving).abs() < 1e-3);
        }
    }

    #[test]
    fn corners_stay_and_what_has_only_corners_stays_straight() {
        let square = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]].map(DVec2::from);
        assert_eq!(fit(&polygon(&square, true), 0.1), polygon(&square, true));
        let half: Vec<DVec2> = circle(120)[..61].to_vec();
        let fitted = fit(&polygon(&half, true), 0.05);
        let path = fitted.get(0);
        let ends = [half[0], half[60]];
        assert!(ends.iter().all(|end| path.points.contains(end)), "the half disc keeps both its corners");
    }

    proptest! {
        #[test]
        fn curves_keep_to_the_tolerance(
            turns in prop::collection::vec(-0.6..0.6_f64, 2..60), steps in prop::collection::vec(0.01..3.0_f64, 60),
            tolerance in 0.001..0.5_f64, closed in any::<bool>(),
        ) {
            let (mut at, mut angle) = (DVec2::ZERO, 0.0);
            let mut points = vec![at];
            for (turn, step) in turns.iter().zip(&steps) {
                angle += turn;
                at += DVec2::from_angle(angle) * *step;
                points.push(at);
            }
            let fitted = fit(&polygon(&points, closed), tolerance);
            let path = fitted.get(0);
            prop_assert_eq!(path.closed, closed);
            prop_assert!(closed || (path.start(), path.end()) == (points[0], points[points.len() - 1]));
            let original = polygon(&points, closed);
            let straight: Vec<[DVec2; 2]> = original.get(0).segments().map(|segment| [segment.from, segment.to]).collect();
            let curves: Vec<Segment> = path.segments().collect();
            prop_assert!(is_near(&curves, &straight, tolerance * (1.0 + 1e-9)));
        }
    }
}
