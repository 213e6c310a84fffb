//! Step 2, dedupe: a segment that lies exactly on another is drawn once.

use super::paths::{Path, Paths, Segment};
use super::svg::printed;
use std::collections::HashSet;

/// A segment as the file would print it, whichever way it runs: both ends and both handles.
type Key = [[i64; 2]; 4];

/// Removes segments that lie on an earlier one of the same or of an earlier layer: both ends, and the handles of a curve,
/// are printed alike, in either direction. What remains of a path that loses some becomes several open paths. `layers`
/// come in the order of precedence. Yields how many were removed. O(segments), expected.
///
/// Segments that overlap in part are left alone. So are segments too short to print.
pub fn dedupe(layers: &mut [&mut Paths]) -> u64 {
    let mut drawn = HashSet::new();
    let mut removed = 0;
    for paths in layers {
        let mut kept = Paths::default();
        for path in paths.iter() {
            let before = removed;
            let mut repeats = Vec::with_capacity(path.segment_count());
            for segment in path.segments() {
                let key = key(&segment);
                repeats.push(key[0] != key[1] && !drawn.insert(key));
                removed += u64::from(repeats[repeats.len() - 1]);
            }
            if removed == before {
                kept.push(path);
            } else {
                push_runs(path, &repeats, &mut kept);
            }
        }
        **paths = kept;
    }
    removed
}

/// Appends the runs of segments that are no repeats.
fn push_runs(path: Path<'_>, repeats: &[bool], kept: &mut Paths) {
    let count = repeats.len();
    // A closed path is opened at a repeat, so that no run is cut at the path's first point.
    let first = if path.closed { repeats.iter().position(|&repeat| repeat).unwrap_or(0) } else { 0 };
    let mut under_way = false;
    for index in (first..count).chain(0..first) {
        if repeats[index] {
            if std::mem::take(&mut under_way) {
                kept.finish(false);
            }
            continue;
        }
        if !under_way {
            kept.begin();
            under_way = true;
        }
        kept.extend(&path.segment(index));
    }
    if under_way {
        kept.finish(false);
    }
}

fn key(segment: &Segment) -> Key {
    let [from, to] = [segment.from, segment.to].map(printed);
    let [a, b] = segment.handles.unwrap_or([segment.from, segment.to]).map(printed);
    if (from, a) <= (to, b) { [from, to, a, b] } else { [to, from, b, a] }
}
