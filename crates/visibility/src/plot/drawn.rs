//! [`DrawnSegments`]: which straight segments lie where on the page, and what of another runs along them.

use super::paths::Paths;
use silhouette_core::glam::DVec2;

/// Segments that run side by side for less than this many tolerances do not lie on each other: those that meet in a sharp
/// corner do, too.
const LEAST_STRETCH: f64 = 10.0;

/// The same for segments that part before either ends. Two that cross at half a degree run side by side for that long.
const LEAST_CROSSING: f64 = 250.0;

/// Most cells along an axis.
const MOST_CELLS: f64 = 2048.0;

/// No entry follows.
const LAST: u32 = u32::MAX;

/// Segments by cell of a grid over the page.
pub struct DrawnSegments {
    /// How far from a segment another may run and still lie on it, in page units.
    tolerance: f64,
    low: DVec2,
    /// Cells per page unit.
    scale: f64,
    columns: usize,
    rows: usize,
    /// The newest entry of each cell.
    head: Vec<u32>,
    /// A segment, and the entry before it in the same cell.
    entries: Vec<(u32, u32)>,
    segments: Vec<[DVec2; 2]>,
    /// The last question in which each segment came up.
    asked: Vec<u32>,
    questions: u32,
}

impl DrawnSegments {
    /// Room for the straight segments of these paths; there are none yet. O(points + cells).
    pub fn over<'a>(layers: impl Iterator<Item = &'a Paths>, tolerance: f64) -> Self {
        let (mut low, mut high, mut length, mut count) = (DVec2::INFINITY, DVec2::NEG_INFINITY, 0.0, 0.0);
        for path in layers.flat_map(Paths::iter) {
            for &point in path.points {
                (low, high) = (low.min(point), high.max(point));
            }
            length += path.length();
            count += path.segment_count() as f64;
        }
        let size = (high - low).max(DVec2::ZERO) + 4.0 * tolerance;
        let wanted: f64 = if count > 0.0 { length / count } else { 1.0 };
        // No more cells than twice the segments, so that the grid is no larger than they are.
        let least = (size.max_element() / MOST_CELLS).max((size.x * size.y / (2.0 * count + 16.0)).sqrt());
        let side = wanted.max(least);
        let finite = side.is_finite() && size.is_finite();
        let (scale, size) = if finite { (1.0 / side, size) } else { (0.0, DVec2::ZERO) };
        let [columns, rows] = (size * scale).to_array().map(|cells| cells.ceil().max(1.0) as usize);
        Self {
            tolerance,
            low: if finite { low - 2.0 * tolerance } else { DVec2::ZERO },
            scale,
            columns,
            rows,
            head: vec![LAST; columns * rows],
            entries: Vec::new(),
            segments: Vec::new(),
            asked: Vec::new(),
            questions: 0,
        }
    }

    /// Adds a segment. O(cells that it passes).
    pub fn insert(&mut self, segment: [DVec2; 2]) {
        let index = self.segments.len() as u32;
        self.segments.push(segment);
        self.asked.push(0);
        for cell in self.cells(segment) {
            self.entries.push((index, self.head[cell]));
            self.head[cell] = self.entries.len() as u32 - 1;
        }
    }

    /// The segment that was inserted as the `index`-th, from 0.
    ///
    /// # Panics
    /// If there is no such segment.
    pub fn segment(&self, index: u32) -> [DVec2; 2] {
        self.segments[index as usize]
    }

    /// Appends the stretches of a segment that run along one of those inserted, as parameters, each with the index of that one,
    /// ordered by where they begin. O(cells that it passes + segments in them).
    pub fn push_covered(&mut self, segment: [DVec2; 2], out: &mut Vec<([f64; 2], u32)>) {
        self.questions += 1;
        let first = out.len();
        for cell in self.cells(segment) {
            let mut entry = self.head[cell];
            while entry != LAST {
                let (index, before) = self.entries[entry as usize];
                entry = before;
                if std::mem::replace(&mut self.asked[index as usize], self.questions) != self.questions {
                    let stretch = along(segment, self.segments[index as usize], self.tolerance);
                    out.extend(stretch.map(|stretch| (stretch, index)));
                }
            }
        }
        out[first..]
            .sort_unstable_by(|(one, index), (other, of_other)| one[0].total_cmp(&other[0]).then(index.cmp(of_other)));
    }

    /// Appends the stretches of a segment that run along none of those inserted, as parameters, in order. O(cells that it
    /// passes + segments in them).
    pub fn push_uncovered(&mut self, segment: [DVec2; 2], out: &mut Vec<[f64; 2]>) {
        let mut covered = Vec::new();
        self.push_covered(segment, &mut covered);
        let least = self.tolerance / segment[0].distance(segment[1]);
        let mut from = 0.0;
        for [begin, end] in covered.into_iter().map(|(stretch, _)| stretch).chain([[1.0, 1.0]]) {
            // What is shorter than the tolerance is not worth lifting the pen for.
            if begin - from > least {
                out.push([from, begin]);
            }
            from = f64::max(from, end);
        }
    }

    /// The cells that a segment, grown by the tolerance, may pass.
    fn cells(&self, [from, to]: [DVec2; 2]) -> impl Iterator<Item = usize> + use<> {
        let slack = self.tolerance * self.scale;
        let [from, to] = [from, to].map(|point| (point - self.low) * self.scale);
        let (left, right) = if from.x <= to.x { (from, to) } else { (to, from) };
        let slope = if right.x > left.x { (right.y - left.y) / (right.x - left.x) } else { 0.0 };
        let bound = |value: f64, cells: usize| (value.max(0.0) as usize).min(cells - 1);
        let (columns, rows) = (self.columns, self.rows);
        (bound(left.x - slack, columns)..=bound(right.x + slack, columns)).flat_map(move |column| {
            let height = |x: f64| left.y + slope * (x - left.x).clamp(0.0, right.x - left.x);
            let (enter, leave) = (height(column as f64 - slack), height(column as f64 + 1.0 + slack));
            let is_steep = right.x - left.x <= slack;
            let (low, high) = if is_steep {
                (left.y.min(right.y), left.y.max(right.y))
            } else {
                (enter.min(leave), enter.max(leave))
            };
            (bound(low - slack, rows)..=bound(high + slack, rows)).map(move |row| row * columns + column)
        })
    }
}

/// The stretch of a segment that runs along another one, as parameters.
fn along([a, b]: [DVec2; 2], [p, q]: [DVec2; 2], tolerance: f64) -> Option<[f64; 2]> {
    let direction = b - a;
    let square = direction.length_squared();
    let share = |point: DVec2| (point - a).dot(direction) / square;
    let (of_p, of_q) = (share(p), share(q));
    let [from, to] = [of_p.min(of_q).max(0.0), of_p.max(of_q).min(1.0)];
    if square <= 0.0 || from >= to {
        return None;
    }
    let length = square.sqrt();
    // Next to each other, their distance is affine.
    let off = |t: f64| {
        let on_other = p.lerp(q, (t - of_p) / (of_q - of_p));
        direction.perp_dot(on_other - a) / length
    };
    let (at_from, at_to) = (off(from), off(to));
    let near = |t: f64| from + (to - from) * t.clamp(0.0, 1.0);
    let reaches = |distance: f64| (distance - at_from) / (at_to - at_from);
    let stays = at_from.abs() <= tolerance && at_to.abs() <= tolerance;
    let [begin, end] = if stays {
        [from, to]
    } else {
        let (one, other) = (reaches(-tolerance), reaches(tolerance));
        [near(one.min(other)), near(one.max(other))]
    };
    // All of a short segment may be covered, or all of a short one may cover.
    let least = if stays {
        (LEAST_STRETCH * tolerance).min(length * 0.5).min(p.distance(q) * 0.5)
    } else {
        LEAST_CROSSING * tolerance
    };
    ((end - begin) * length >= least).then(|| {
        // Ends that are the same place in the file.
        let least = tolerance / length;
        [if begin < least { 0.0 } else { begin }, if end > 1.0 - least { 1.0 } else { end }]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn uncovered(others: &[[[f64; 2]; 2]], segment: [[f64; 2]; 2]) -> Vec<[f64; 2]> {
        let place = |ends: [[f64; 2]; 2]| ends.map(DVec2::from);
        let mut paths = Paths::default();
        for &ends in others.iter().chain(&[segment]) {
            paths.push(super::super::paths::Path { closed: false, points: &place(ends), handles: &[] });
        }
        let mut drawn = DrawnSegments::over([&paths].into_iter(), 0.002);
        others.iter().for_each(|&ends| drawn.insert(place(ends)));
        let mut out = Vec::new();
        drawn.push_uncovered(place(segment), &mut out);
        out
    }

    #[test]
    fn what_runs_along_others_is_covered_and_what_crosses_them_is_not() {
        let line = [[0.0, 0.0], [10.0, 0.0]];
        assert_eq!(uncovered(&[], line), [[0.0, 1.0]]);
        assert_eq!(uncovered(&[line], line), [] as [[f64; 2]; 0]);
        assert_eq!(uncovered(&[[[6.0, 0.0], [2.0, 0.0]]], line), [[0.0, 0.2], [0.6, 1.0]]);
        assert_eq!(uncovered(&[[[-5.0, 0.001], [4.0, 0.001]], [[3.0, 0.0], [20.0, 0.0]]], line), [] as [[f64; 2]; 0]);
        // Across, at an angle of a degree, beside it, and beyond its end.
        for other in [
            [[5.0, -1.0], [5.0, 1.0]],
            [[0.0, -0.1], [10.0, 0.1]],
            [[0.0, 0.01], [10.0, 0.01]],
            [[10.0, 0.0], [12.0, 0.0]],
        ] {
            assert_eq!(uncovered(&[other], line), [[0.0, 1.0]], "{other:?}");
        }
    }

    #[test]
    fn lines_that_cross_at_a_very_small_angle_are_one_for_a_while() {
        let found = uncovered(&[[[0.0, -0.01], [10.0, 0.01]]], [[0.0, 0.0], [10.0, 0.0]]);
        assert_eq!(found.len(), 2, "{found:?}");
        assert!((found[0][1] - 0.4).abs() < 1e-9 && (found[1][0] - 0.6).abs() < 1e-9, "{found:?}");
    }

    #[test]
    fn a_sharp_corner_is_no_overlap() {
        let line = [[0.0, 0.0], [10.0, 0.0]];
        assert_eq!(uncovered(&[[[0.0, 0.0], [5.0, 0.1]]], line), [[0.0, 1.0]]);
    }
}
