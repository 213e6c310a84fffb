//! Step 4, join: paths of a layer that touch end to end become one.

use super::decimal::printed;
use super::paths::{Path, Paths};
use std::collections::HashMap;

/// An end of an open path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct End {
    path: usize,
    /// Whether it is the path's last point.
    last: bool,
}

impl End {
    fn other(self) -> Self {
        Self { path: self.path, last: !self.last }
    }
}

/// What meets in a point: its only end, its two ends, or too many to tell which goes on as which.
#[derive(Debug, Clone, Copy)]
enum Meeting {
    One(End),
    Two(End, End),
    Many,
}

/// Joins open paths where exactly two ends are printed alike: pieces of one line that differ in what the layer does not
/// show, such as by how much they are hidden. Three or more ends that meet stay apart, and so do straight lines and
/// curves. A path whose own ends meet becomes closed. Order: by the first path of each. O(points), expected.
pub fn join(paths: &Paths) -> Paths {
    let mut meetings: HashMap<(bool, [i64; 2]), Meeting> = HashMap::new();
    let place = |end: End| {
        let path = paths.get(end.path);
        (path.handles.is_empty(), printed(if end.last { path.end() } else { path.start() }))
    };
    for path in (0..paths.len()).filter(|&path| !paths.get(path).closed) {
        for last in [false, true] {
            let end = End { path, last };
            let meeting = meetings.entry(place(end)).or_insert(Meeting::One(end));
            *meeting = match *meeting {
                Meeting::One(one) if one == end => continue,
                Meeting::One(one) => Meeting::Two(one, end),
                Meeting::Two(..) | Meeting::Many => Meeting::Many,
            };
        }
    }
    let partner = |end: End| match meetings[&place(end)] {
        Meeting::Two(one, other) => Some(if one == end { other } else { one }),
        Meeting::One(_) | Meeting::Many => None,
    };

    let mut joined = Paths::default();
    let mut done = vec![false; paths.len()];
    for path in 0..paths.len() {
        if done[path] {
            continue;
        }
        if paths.get(path).closed {
            joined.push(paths.get(path));
            continue;
        }
        let (start, closed) = first_end(End { path, last: false }, partner);
        let run: Vec<End> =
            std::iter::successors(Some(start), |end| partner(end.other()).filter(|&next| next != start)).collect();
        run.iter().for_each(|end| done[end.path] = true);
        push_run(paths, &run, closed, &mut joined);
    }
    joined
}

/// Goes back from an end to where its line begins; to the same end where the line is closed.
fn first_end(end: End, partner: impl Fn(End) -> Option<End>) -> (End, bool) {
    let mut first = end;
    while let Some(before) = partner(first) {
        first = before.other();
        if first == end {
            return (end, true);
        }
    }
    (first, false)
}

/// Appends the paths that begin at these ends as one.
fn push_run(paths: &Paths, run: &[End], closed: bool, joined: &mut Paths) {
    let segments = |end: &End| {
        let path: Path<'_> = paths.get(end.path);
        let last = end.last;
        let count = path.segment_count();
        (0..count).map(move |index| if last { path.segment(count - 1 - index).reversed() } else { path.segment(index) })
    };
    let count: usize = run.iter().map(|end| paths.get(end.path).segment_count()).sum();
    // Out and back along one segment is no loop.
    let closed = closed && count > 2;
    joined.begin();
    run.iter().flat_map(segments).for_each(|segment| joined.extend(&segment));
    if closed {
        joined.drop_repeated_point();
    }
    joined.finish(closed);
}
