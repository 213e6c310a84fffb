//! Step 2, dedupe: what lies on another line is drawn once.

use super::decimal::printed;
use super::drawn::DrawnSegments;
use super::paths::{Path, Paths, Segment};
use std::collections::HashSet;

/// A segment as the file would print it, whichever way it runs: both ends and both handles.
type Key = [[i64; 2]; 4];

/// Lines this close are one in any file, in page units: twice the last decimal that is printed.
const LEAST_TOLERANCE: f64 = 0.002;

/// Removes what lies on an earlier segment of the same or of an earlier layer: of a straight segment the stretches that run
/// along others within `tolerance`, in page units; of a curve all of it where both ends and both handles are printed alike,
/// in either direction. What remains of a path that loses some becomes several open paths. `layers` come in the order of
/// precedence. Yields the number of segments from which something was removed. O(segments + pairs that pass the same
/// place), expected.
///
/// Segments too short to print stay.
pub fn dedupe(layers: &mut [&mut Paths], tolerance: f64) -> u64 {
    let mut seen = HashSet::new();
    let mut drawn = DrawnSegments::over(layers.iter().map(|paths| &**paths), tolerance.max(LEAST_TOLERANCE));
    let mut kept_of_segment = Vec::new();
    let mut removed = 0;
    for paths in layers {
        let mut kept = Paths::default();
        for path in paths.iter() {
            let before = removed;
            kept_of_segment.clear();
            for segment in path.segments() {
                let key = key(&segment);
                let begin = kept_of_segment.len();
                if key[0] == key[1] {
                    kept_of_segment.push([0.0, 1.0]);
                } else if seen.insert(key) {
                    if segment.handles.is_some() {
                        kept_of_segment.push([0.0, 1.0]);
                    } else {
                        drawn.push_uncovered([segment.from, segment.to], &mut kept_of_segment);
                    }
                    if kept_of_segment.len() > begin && segment.handles.is_none() {
                        drawn.insert([segment.from, segment.to]);
                    }
                }
                removed += u64::from(kept_of_segment[begin..] != [[0.0, 1.0]]);
                kept_of_segment.push(END_OF_SEGMENT);
            }
            if removed == before {
                kept.push(path);
            } else {
                push_runs(path, &kept_of_segment, &mut kept);
            }
        }
        **paths = kept;
    }
    removed
}

/// Follows what is kept of a segment.
const END_OF_SEGMENT: [f64; 2] = [2.0; 2];

/// Appends the runs of what is kept of a path's segments: for each its stretches, then [`END_OF_SEGMENT`].
fn push_runs(path: Path<'_>, kept_of_segment: &[[f64; 2]], kept: &mut Paths) {
    let stretches: Vec<&[[f64; 2]]> = kept_of_segment.split(|stretch| *stretch == END_OF_SEGMENT).collect();
    let count = path.segment_count();
    // A closed path is opened where something is missing, so that no run is cut at the path's first point.
    let is_whole = |index: &usize| *stretches[*index] == [[0.0, 1.0]];
    let first = if path.closed { (0..count).position(|index| !is_whole(&index)).unwrap_or(0) } else { 0 };
    let order = (first..count).chain(0..first);
    let mut parts: Vec<Segment> = Vec::new();
    let mut flush = |parts: &mut Vec<Segment>| {
        if !parts.is_empty() {
            kept.begin();
            parts.drain(..).for_each(|part| kept.extend(&part));
            kept.finish(false);
        }
    };
    // The first segment comes last once more, up to where its first stretch is missing.
    let mut tail: Vec<Segment> = Vec::new();
    for (place, index) in order.enumerate() {
        let segment = path.segment(index);
        for &[from, to] in stretches[index] {
            if from > 0.0 {
                flush(&mut parts);
            }
            let part = if from <= 0.0 && to >= 1.0 { segment } else { segment.part(from, to) };
            if path.closed && place == 0 && from <= 0.0 && to < 1.0 {
                tail.push(part);
                continue;
            }
            parts.push(part);
            if to < 1.0 {
                flush(&mut parts);
            }
        }
        if stretches[index].last().is_none_or(|last| last[1] < 1.0) {
            flush(&mut parts);
        }
    }
    parts.append(&mut tail);
    flush(&mut parts);
}

fn key(segment: &Segment) -> Key {
    let [from, to] = [segment.from, segment.to].map(printed);
    let [a, b] = segment.handles.unwrap_or([segment.from, segment.to]).map(printed);
    if (from, a) <= (to, b) { [from, to, a, b] } else { [to, from, b, a] }
}
