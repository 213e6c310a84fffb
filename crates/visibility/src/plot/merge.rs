//! Step 5, merge: points that lie on the line between others are dropped, and parts of one cubic become one again.

use super::paths::{Path, Paths, Segment};
use silhouette_core::glam::DVec2;

/// Drops points of straight paths, and keeps every dropped point within `tolerance` (page units, from 0) of the segment
/// that takes its place. Consecutive curves become one where the control points of its parts lie within `tolerance` of theirs;
/// a curve then strays no farther. O(points).
///
/// The rule for straight paths: from a kept point P, points are dropped as long as the next one lies no nearer to P than all of them, and
/// the straight segment from P to it passes every one of them within the tolerance. An open path keeps its ends, a
/// closed one the corner where it turns the most; a closed path that is thinner than the tolerance becomes open.
///
/// That the points recede from P makes them lie along the segment, not only along its line: nothing is dropped where a
/// path turns back. Directions that pass all dropped points closely enough form a sector, kept up to date point by point
/// (the sleeve of Zhao and Saalfeld, "Linear-time sleeve-fitting polyline simplification algorithms", 1997).
pub fn merge(paths: &Paths, tolerance: f64) -> Paths {
    let mut merged = Paths::default();
    for path in paths.iter() {
        if path.handles.is_empty() {
            merge_path(path, tolerance, &mut merged);
        } else {
            merge_curves(path, tolerance, &mut merged);
        }
    }
    merged
}

/// Most curves that become one, which bounds the work.
const MOST_CURVES: usize = 64;

fn merge_curves(path: Path<'_>, tolerance: f64, merged: &mut Paths) {
    let mut run = CurveRun::default();
    let mut kept = 0;
    merged.begin();
    for segment in path.segments() {
        if !run.takes(&segment, tolerance) {
            run.whole.iter().for_each(|whole| merged.extend(whole));
            kept += 1;
            run = CurveRun { whole: Some(segment), parts: vec![segment], ends: vec![1.0] };
        }
    }
    run.whole.iter().for_each(|whole| merged.extend(whole));
    // One curve that ends where it begins has two points all the same.
    let closed = path.closed && kept > 1;
    if closed {
        merged.drop_repeated_point();
    }
    merged.finish(closed);
}

/// Consecutive curves, and the one that stands for them.
#[derive(Default)]
struct CurveRun {
    whole: Option<Segment>,
    parts: Vec<Segment>,
    /// The parameter of the whole at which each part ends.
    ends: Vec<f64>,
}

impl CurveRun {
    /// Adds a curve, if one cubic can stand for it and all before it.
    fn takes(&mut self, next: &Segment, tolerance: f64) -> bool {
        let Some((whole, share)) = self.whole.and_then(|whole| united(&whole, next)) else { return false };
        if self.parts.len() == MOST_CURVES {
            return false;
        }
        let scaled = || self.ends.iter().map(|end| end * share);
        let begins = std::iter::once(0.0).chain(scaled());
        let ends = scaled().chain([1.0]);
        let parts = self.parts.iter().chain([next]);
        let follows = begins.zip(ends).zip(parts).all(|((begin, end), part)| {
            let [one, other] = [&whole.part(begin, end), part].map(control_points);
            one.iter().zip(other).all(|(one, other)| one.distance(other) <= tolerance)
        });
        if follows {
            self.ends = scaled().chain([1.0]).collect();
            self.parts.push(*next);
            self.whole = Some(whole);
        }
        follows
    }
}

/// The cubic that two consecutive ones are parts of, if they are, and the parameter at which they meet: it divides the line
/// through both handles where they meet, as de Casteljau's subdivision does.
fn united(one: &Segment, next: &Segment) -> Option<(Segment, f64)> {
    let ([leaving, before], [after, arriving]) = (one.handles?, next.handles?);
    let [to_meeting, from_meeting] = [one.to.distance(before), next.from.distance(after)];
    let share = to_meeting / (to_meeting + from_meeting);
    if !(share > 0.0 && share < 1.0) {
        return None;
    }
    let handles = [one.from + (leaving - one.from) / share, next.to + (arriving - next.to) / (1.0 - share)];
    Some((Segment { from: one.from, to: next.to, handles: Some(handles) }, share))
}

/// The ends and handles of a segment.
fn control_points(segment: &Segment) -> [DVec2; 4] {
    let [a, b] = segment.handles.unwrap_or([segment.from, segment.to]);
    [segment.from, a, b, segment.to]
}

fn merge_path(path: Path<'_>, tolerance: f64, merged: &mut Paths) {
    let count = path.points.len();
    let first = if path.closed { sharpest_corner(path.points) } else { 0 };
    let point = |index: usize| path.points[(first + index) % count];
    // Around a closed path the first point is met again as the last.
    let last = if path.closed { count } else { count - 1 };

    merged.begin();
    merged.extend_to(point(0));
    let mut kept = 1;
    let mut sleeve = Sleeve::new(point(0), tolerance);
    for index in 1..=last {
        if !sleeve.reaches(point(index)) {
            merged.extend_to(point(index - 1));
            kept += 1;
            sleeve = Sleeve::new(point(index - 1), tolerance);
        }
        sleeve.pass(point(index));
    }
    if path.closed && kept > 2 {
        merged.finish(true);
    } else if path.closed && kept == 2 {
        merged.finish(false);
    } else {
        merged.extend_to(point(last));
        merged.finish(false);
    }
}

/// The index of the point of a closed path at which it turns by the largest angle.
fn sharpest_corner(points: &[DVec2]) -> usize {
    let count = points.len();
    let turn = |index: usize| {
        let [before, after] = [points[(index + count - 1) % count], points[(index + 1) % count]];
        let [into, out_of] = [points[index] - before, after - points[index]].map(DVec2::normalize_or_zero);
        into.dot(out_of)
    };
    (0..count)
        .map(|index| (turn(index), index))
        .reduce(|sharp, next| if next.0 < sharp.0 { next } else { sharp })
        .map_or(0, |(_, index)| index)
}

/// The points that a segment from one point may reach when it is to pass others closely.
struct Sleeve {
    from: DVec2,
    tolerance: f64,
    /// Distance of the farthest point passed.
    far: f64,
    /// Directions of the sector's right and left side; `None` while every direction will do.
    sides: Option<[DVec2; 2]>,
}

impl Sleeve {
    fn new(from: DVec2, tolerance: f64) -> Self {
        Self { from, tolerance, far: 0.0, sides: None }
    }

    /// Whether the segment to `point` passes all points so far, and they lie along it.
    fn reaches(&self, point: DVec2) -> bool {
        let way = point - self.from;
        let inside = |[right, left]: [DVec2; 2]| {
            right.perp_dot(way) >= 0.0 && way.perp_dot(left) >= 0.0 && (right + left).dot(way) > 0.0
        };
        way.length() >= self.far && self.sides.is_none_or(inside)
    }

    /// Narrows the sector to directions that pass `point`, too.
    fn pass(&mut self, point: DVec2) {
        let way = point - self.from;
        let distance = way.length();
        self.far = self.far.max(distance);
        if distance <= self.tolerance {
            return;
        }
        let sine = self.tolerance / distance;
        let cosine = (1.0 - sine * sine).sqrt();
        let right = DVec2::new(cosine, -sine).rotate(way);
        let left = DVec2::new(cosine, sine).rotate(way);
        self.sides = Some(match self.sides {
            None => [right, left],
            Some([old_right, old_left]) => [
                if old_right.perp_dot(right) > 0.0 { right } else { old_right },
                if left.perp_dot(old_left) > 0.0 { left } else { old_left },
            ],
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WHOLE: Segment = Segment {
        from: DVec2::new(0.0, 0.0),
        to: DVec2::new(90.0, 10.0),
        handles: Some([DVec2::new(10.0, 60.0), DVec2::new(70.0, -40.0)]),
    };

    /// A path of these parts of [`WHOLE`], each of whose handles is moved by `off`.
    fn parts(ends: &[f64], off: DVec2) -> Paths {
        let mut paths = Paths::default();
        paths.begin();
        for pair in ends.windows(2) {
            let part = WHOLE.part(pair[0], pair[1]);
            paths.extend(&Segment { handles: part.handles.map(|[a, b]| [a + off, b - off]), ..part });
        }
        paths.finish(false);
        paths
    }

    #[test]
    fn parts_of_one_cubic_become_it_again() {
        let merged = merge(&parts(&[0.0, 0.1, 0.15, 0.5, 0.8, 1.0], DVec2::ZERO), 1e-6);
        assert_eq!(merged.get(0).segment_count(), 1);
        let distances = control_points(&merged.get(0).segment(0)).into_iter().zip(control_points(&WHOLE));
        assert!(distances.into_iter().all(|(one, other)| one.distance(other) < 1e-9));
    }

    #[test]
    fn what_is_no_part_of_one_cubic_stays_apart() {
        let ends = [0.0, 0.3, 0.6, 1.0];
        for (off, count) in [(0.0, 1), (1e-3, 1), (0.5, 3)] {
            let merged = merge(&parts(&ends, DVec2::new(off, -off)), 0.01);
            assert_eq!(merged.get(0).segment_count(), count, "handles moved by {off}");
        }
        // A corner.
        let mut paths = Paths::default();
        paths.begin();
        paths.extend(&WHOLE);
        paths.extend(&WHOLE.reversed());
        paths.finish(false);
        assert_eq!(merge(&paths, 0.01).get(0).segment_count(), 2);
    }

    #[test]
    fn united_curves_keep_within_the_tolerance() {
        let tolerance = 0.2;
        let paths = parts(&(0..=40).map(|i| f64::from(i) / 40.0).collect::<Vec<_>>(), DVec2::new(0.01, 0.02));
        let merged = merge(&paths, tolerance);
        let points = |paths: &Paths, steps: u32| -> Vec<DVec2> {
            let segments: Vec<Segment> = paths.get(0).segments().collect();
            segments.iter().flat_map(|s| (0..=steps).map(|i| s.at(f64::from(i) / f64::from(steps)))).collect()
        };
        assert!(merged.get(0).segment_count() < 10, "{}", merged.get(0).segment_count());
        let curve = points(&merged, 2000);
        for point in points(&paths, 10) {
            let nearest = curve.iter().map(|other| point.distance(*other)).fold(f64::INFINITY, f64::min);
            assert!(nearest <= tolerance + 0.1, "{nearest}");
        }
        assert_eq!(merged.get(0).start(), WHOLE.from);
        assert_eq!(merged.get(0).end(), WHOLE.to);
    }

    #[test]
    fn a_closed_path_of_one_cubic_is_an_open_one_that_ends_where_it_begins() {
        let drop = Segment { to: WHOLE.from, ..WHOLE };
        let mut paths = Paths::default();
        paths.begin();
        paths.extend(&drop.part(0.0, 0.5));
        paths.extend(&drop.part(0.5, 1.0));
        paths.drop_repeated_point();
        paths.finish(true);
        let merged = merge(&paths, 1e-6);
        assert_eq!((merged.get(0).segment_count(), merged.get(0).start()), (1, merged.get(0).end()));
    }
}
