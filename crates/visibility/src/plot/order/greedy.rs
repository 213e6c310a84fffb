//! The first tour: always on to the nearest end.

use super::Stop;
use super::end_tree::EndTree;
use crate::plot::paths::Paths;
use silhouette_core::glam::DVec2;
use silhouette_core::progress::{Cancelled, Progress};

/// Points at which a closed path may begin.
const ENTRIES: usize = 32;
/// Paths between two reports of progress.
const STEP: usize = 1024;

/// A place at which the pen may be put down for a path.
struct Entry {
    path: u32,
    point: u32,
}

/// All paths, from the page's top left on, each next one that with the nearest end. O(n log n) where ends do not crowd.
pub(super) fn tour(paths: &Paths, progress: &dyn Progress) -> Result<Vec<Stop>, Cancelled> {
    progress.stage("ordering paths", paths.len() as u64);
    let (entries, places, entries_of) = entries(paths);
    let mut tree = EndTree::new(places);
    let mut tour = Vec::with_capacity(paths.len());
    let mut pen = DVec2::ZERO;
    let mut found = Vec::with_capacity(1);
    while tour.len() < paths.len() {
        tree.nearest(pen, 1, &mut found);
        let entry = &entries[found[0].id as usize];
        let path = paths.get(entry.path as usize);
        let at = path.points[entry.point as usize];
        let stop = if path.closed {
            Stop { path: entry.path, first: entry.point, reversed: false, from: at, to: at }
        } else {
            let reversed = entry.point > 0;
            let to = if reversed { path.start() } else { path.end() };
            Stop { path: entry.path, first: 0, reversed, from: at, to }
        };
        (entries_of[entry.path as usize]..entries_of[entry.path as usize + 1]).for_each(|id| tree.take(id));
        pen = stop.to;
        tour.push(stop);
        if tour.len().is_multiple_of(STEP) {
            progress.check()?;
            progress.advance(STEP as u64);
        }
    }
    Ok(tour)
}

/// All entries, where they lie, and at which of them those of each path begin (with one number more, the end).
fn entries(paths: &Paths) -> (Vec<Entry>, Vec<DVec2>, Vec<u32>) {
    let (mut entries, mut places, mut entries_of) = (Vec::new(), Vec::new(), vec![0]);
    for (index, path) in paths.iter().enumerate() {
        let last = path.points.len() - 1;
        let step = if path.closed { path.points.len().div_ceil(ENTRIES) } else { last };
        for point in (0..=last).step_by(step) {
            entries.push(Entry { path: index as u32, point: point as u32 });
            places.push(path.points[point]);
        }
        entries_of.push(entries.len() as u32);
    }
    (entries, places, entries_of)
}
