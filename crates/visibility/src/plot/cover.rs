//! Step 6, cover: a path whose line longer ones have inked already is left out.
//!
//! Where a surface folds, two contours run side by side, closer together than a pen is wide, and short ends stand in the ink of
//! longer lines. Both are lines of the picture, and neither shows on paper.

use super::drop_short::Dropped;
use super::paths::{Path, Paths};
use silhouette_core::glam::DVec2;
use std::collections::HashMap;

/// Samples of a path per width of its pen.
const SAMPLES_PER_WIDTH: f64 = 4.0;

/// Chords that a curve is looked at by.
const CHORDS: u32 = 8;

/// Most cells that a segment is entered into, and most segments in a cell, which bound memory and work: what is beyond covers nothing.
const MOST_CELLS: f64 = 4096.0;
const MOST_SEGMENTS: usize = 64;

/// Drops paths of which every point lies within half the pen's `width` (page units, above 0) of longer ones that stay: to draw them
/// would add a fringe of less than half that width. O(length / width), expected, where paths do not crowd.
pub fn drop_covered(paths: &Paths, width: f64) -> (Paths, Dropped) {
    let lengths: Vec<f64> = paths.iter().map(|path| path.length()).collect();
    let mut order: Vec<usize> = (0..paths.len()).collect();
    // Equal ones in their order.
    order.sort_by(|&one, &other| lengths[other].total_cmp(&lengths[one]));
    let mut ink = Ink { reach: width * 0.5, cells: HashMap::new() };
    let mut is_kept = vec![true; paths.len()];
    for index in order {
        let path = paths.get(index);
        if samples(path, width / SAMPLES_PER_WIDTH).all(|point| ink.covers(point)) {
            is_kept[index] = false;
        } else {
            chords(path).for_each(|chord| ink.add(chord));
        }
    }
    let (mut kept, mut dropped) = (Paths::default(), Dropped::default());
    for (index, path) in paths.iter().enumerate() {
        if is_kept[index] {
            kept.push(path);
        } else {
            dropped.paths += 1;
            dropped.length += lengths[index];
        }
    }
    (kept, dropped)
}

/// Segments by the cells that they pass, which are as wide as the pen.
struct Ink {
    reach: f64,
    cells: HashMap<[i64; 2], Vec<[DVec2; 2]>>,
}

impl Ink {
    fn cell(&self, point: DVec2) -> [i64; 2] {
        // Saturates far beyond any page.
        (point / (2.0 * self.reach)).floor().to_array().map(|coordinate| coordinate as i64)
    }

    /// Adds a segment to the cells of points along it, half a cell apart: what lies within the reach of it lies in a cell beside one
    /// of them.
    fn add(&mut self, segment: [DVec2; 2]) {
        let [from, to] = segment;
        let steps = (from.distance(to) / self.reach).ceil().max(1.0);
        if steps > MOST_CELLS {
            return;
        }
        let mut last = None;
        for step in 0..=steps as u32 {
            let cell = self.cell(from.lerp(to, f64::from(step) / steps));
            if last.replace(cell) != Some(cell) {
                let entries = self.cells.entry(cell).or_default();
                if entries.len() < MOST_SEGMENTS {
                    entries.push(segment);
                }
            }
        }
    }

    fn covers(&self, point: DVec2) -> bool {
        let [column, row] = self.cell(point);
        let around = (-1..=1).flat_map(|x| (-1..=1).map(move |y| [column.saturating_add(x), row.saturating_add(y)]));
        let mut near = around.filter_map(|cell| self.cells.get(&cell)).flatten();
        near.any(|&[from, to]| distance(point, from, to) <= self.reach)
    }
}

/// How far a point lies from a straight segment.
pub(super) fn distance(point: DVec2, from: DVec2, to: DVec2) -> f64 {
    let way = to - from;
    let share = ((point - from).dot(way) / way.length_squared()).clamp(0.0, 1.0);
    point.distance(if share.is_finite() { from + way * share } else { from })
}

fn chords(path: Path<'_>) -> impl Iterator<Item = [DVec2; 2]> {
    (0..path.segment_count()).map(move |index| path.segment(index)).flat_map(|segment| {
        let count = if segment.handles.is_some() { CHORDS } else { 1 };
        (0..count).map(move |chord| [chord, chord + 1].map(|end| segment.at(f64::from(end) / f64::from(count))))
    })
}

/// Points along a path, both ends among them.
fn samples(path: Path<'_>, spacing: f64) -> impl Iterator<Item = DVec2> {
    chords(path).flat_map(move |[from, to]| {
        let steps = (from.distance(to) / spacing).ceil().max(1.0);
        // What is longer than the count holds is not covered anyway.
        (0..=steps as u32).map(move |step| from.lerp(to, f64::from(step) / steps))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kept(lines: &[&[[f64; 2]]]) -> Vec<usize> {
        let mut paths = Paths::default();
        for line in lines {
            let points: Vec<DVec2> = line.iter().copied().map(DVec2::from).collect();
            paths.push(Path { closed: false, points: &points, handles: &[] });
        }
        let (kept, dropped) = drop_covered(&paths, 1.0);
        assert_eq!(dropped.paths as usize + kept.len(), lines.len());
        assert!((kept.length() + dropped.length - paths.length()).abs() < 1e-9);
        let is_kept = |index: &usize| kept.iter().any(|path| path == paths.get(*index));
        (0..lines.len()).filter(is_kept).collect()
    }

    #[test]
    fn what_lies_in_the_ink_of_longer_lines_is_left_out() {
        let long: &[[f64; 2]] = &[[0.0, 0.0], [100.0, 0.0]];
        for (other, stays) in [
            (&[[10.0, 0.4], [20.0, 0.4]][..], false),
            (&[[10.0, 0.4], [20.0, 0.6]], true),
            (&[[10.0, 0.0], [10.0, 0.45]], false),
            (&[[10.0, 0.0], [10.0, 2.0]], true),
            (&[[99.0, 0.0], [100.4, 0.0]], false),
            (&[[99.0, 0.0], [100.6, 0.0]], true),
            (&[[10.0, 5.0], [12.0, 5.0]], true),
        ] {
            for lines in [[long, other], [other, long]] {
                assert_eq!(kept(&lines).len(), if stays { 2 } else { 1 }, "{other:?}");
            }
        }
        // Several lines together may cover one.
        assert_eq!(
            kept(&[&[[0.0, 0.0], [9.0, 0.0]], &[[9.0, 0.0], [9.0, 9.0]], &[[8.0, 0.3], [8.7, 0.3], [8.7, 1.0]]]),
            [0, 1]
        );
        // Of two alike one stays.
        assert_eq!(kept(&[&[[0.0, 0.0], [3.0, 0.0]], &[[0.0, 0.1], [3.0, 0.1]]]).len(), 1);
    }
}
