//! Step 4, merge: points that lie on the line between others are dropped.

use super::paths::{Path, Paths};
use silhouette_core::glam::DVec2;

/// Drops points of straight paths, and keeps every dropped point within `tolerance` (page units, from 0) of the segment
/// that takes its place. Curves are left as they are. O(points).
///
/// The rule: from a kept point P, points are dropped as long as the next one lies no nearer to P than all of them, and
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
            merged.push(path);
        }
    }
    merged
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
