//! Step 10, order: paths are put in an order, and each in a direction, that leave little way to the lifted pen.

mod end_tree;
mod greedy;
mod improve;

use super::paths::Paths;
use silhouette_core::glam::DVec2;
use silhouette_core::progress::{Cancelled, Progress};

/// Way of the lifted pen, from the end of each path to the start of the next, in page units.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize)]
pub struct Travel {
    /// In the order of the lines.
    pub before: f64,
    /// In the file.
    pub after: f64,
}

/// A path as a stop of the pen's tour.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Stop {
    path: u32,
    /// The point at which a closed path begins; 0 for an open one.
    first: u32,
    /// Whether it runs backwards.
    reversed: bool,
    /// Where the pen is put down.
    from: DVec2,
    /// Where it is lifted.
    to: DVec2,
}

/// Puts paths in order.
///
/// 1. `greedy`: from the page's top left to the nearest end of a path, along it, to the nearest end of those left, and
///    so on; a closed path may begin at any of its points (of many: at any of 32).
/// 2. `improve`: parts of the tour are reversed (2-opt, Croes 1958) or short runs moved elsewhere (or-opt, Or 1976) as
///    long as that shortens the way, with the nearest five ends as candidates and a bound on the work.
///
/// No longer than the order given: that is kept where nothing better is found. The same result on every machine and for
/// any number of threads. About O(n log n) for n paths.
///
/// # Errors
/// [`Cancelled`] when `progress` asks to stop; one step per path and stage is reported to it.
pub fn order(paths: &Paths, progress: &dyn Progress) -> Result<(Paths, Travel), Cancelled> {
    let before = paths.pen_up_travel();
    let mut tour = greedy::tour(paths, progress)?;
    improve::improve(&mut tour, progress)?;
    let after: f64 = tour.windows(2).map(|pair| pair[0].to.distance(pair[1].from)).sum();
    if after >= before {
        return Ok((paths.clone(), Travel { before, after: before }));
    }
    let mut ordered = Paths::default();
    for stop in &tour {
        let path = paths.get(stop.path as usize);
        match (path.closed, stop.reversed) {
            (true, _) => ordered.push_rotated(path, stop.first as usize),
            (false, true) => ordered.push_reversed(path),
            (false, false) => ordered.push(path),
        }
    }
    Ok((ordered, Travel { before, after }))
}
