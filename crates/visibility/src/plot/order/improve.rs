//! A better tour: parts are turned round or moved as long as that shortens the way.

use super::Stop;
use super::end_tree::EndTree;
use rayon::prelude::*;
use silhouette_core::glam::DVec2;
use silhouette_core::progress::{Cancelled, Progress};
use std::collections::VecDeque;

/// Nearest ends that an end may be tied to.
const CANDIDATES: usize = 5;
/// Paths that are moved together at most.
const MAX_RUN: usize = 3;
/// Stops between the places that a change involves, at most: what a change costs grows with it.
const MAX_SPAN: usize = 1000;
/// Visits of a path, on average over all, after which the search ends.
const MAX_VISITS: usize = 30;
/// Savings below this share of a page unit are rounding.
const LEAST_SAVING: f64 = 1e-9;
/// Visits between two reports of progress.
const STEP: usize = 1024;

/// Shortens a tour in place. Deterministic; O(n log n) with a bound on the work a path.
pub(super) fn improve(tour: &mut [Stop], progress: &dyn Progress) -> Result<(), Cancelled> {
    let count = tour.len();
    progress.stage("shortening the pen's way", count as u64);
    let mut search = Search::new(tour);
    let mut queue: VecDeque<u32> = (0..count as u32).collect();
    let mut waits = vec![true; count];
    let mut changed = Vec::new();
    for visit in 0..count.saturating_mul(MAX_VISITS) {
        let Some(stop) = queue.pop_front() else { break };
        waits[stop as usize] = false;
        search.improve_at(stop, &mut changed);
        for stop in changed.drain(..) {
            if !std::mem::replace(&mut waits[stop as usize], true) {
                queue.push_back(stop);
            }
        }
        if visit % STEP == STEP - 1 {
            progress.check()?;
            progress.advance(if visit < count { STEP as u64 } else { 0 });
        }
    }
    let stops: Vec<_> = search.tour.iter().map(|&at| search.stop(at, tour)).collect();
    tour.copy_from_slice(&stops);
    Ok(())
}

/// A stop of the first tour by its index, and whether it is turned round: packed, since changes move many.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Turned(u32);

impl Turned {
    fn new(stop: u32, turned: bool) -> Self {
        Self(stop << 1 | u32::from(turned))
    }
    fn stop(self) -> u32 {
        self.0 >> 1
    }
    fn is_turned(self) -> bool {
        self.0 & 1 == 1
    }
    fn around(self) -> Self {
        Self(self.0 ^ 1)
    }
    /// The end at which the pen is put down (0) or lifted (1), as an index of ends.
    fn end(self, lifted: usize) -> usize {
        2 * self.stop() as usize + (lifted ^ usize::from(self.is_turned()))
    }
}

struct Search {
    tour: Vec<Turned>,
    /// Where in the tour each stop lies.
    place_of: Vec<u32>,
    /// Both ends of each stop.
    ends: Vec<DVec2>,
    /// The nearest ends of each end, its own stop's left out.
    candidates: Vec<[u32; CANDIDATES]>,
}

/// Stands for no candidate.
const NONE: u32 = u32::MAX;

/// An end of a stop by its place in the tour.
#[derive(Debug, Clone, Copy)]
struct End {
    place: usize,
    /// Whether the pen is lifted there.
    lifted: bool,
}

/// A run of the tour that goes elsewhere.
#[derive(Debug, Clone, Copy)]
struct Run {
    first: usize,
    last: usize,
    /// The place of the stop that it goes before; the tour's length for its end.
    before: usize,
    reversed: bool,
}

impl Search {
    fn new(tour: &[Stop]) -> Self {
        let ends: Vec<_> = tour.iter().flat_map(|stop| [stop.from, stop.to]).collect();
        let tree = EndTree::new(ends.clone());
        let nearest = |found: &mut Vec<_>, end: usize| {
            // The stop's own two ends may be among them.
            tree.nearest(ends[end], CANDIDATES + 2, found);
            let others = found.iter().map(|near| near.id).filter(|&id| id as usize / 2 != end / 2);
            let mut candidates = [NONE; CANDIDATES];
            candidates.iter_mut().zip(others).for_each(|(candidate, id)| *candidate = id);
            candidates
        };
        let candidates = (0..ends.len()).into_par_iter().map_init(Vec::new, nearest).collect();
        let stops = 0..tour.len() as u32;
        Self {
            tour: stops.clone().map(|stop| Turned::new(stop, false)).collect(),
            place_of: stops.collect(),
            ends,
            candidates,
        }
    }

    fn stop(&self, at: Turned, tour: &[Stop]) -> Stop {
        let stop = tour[at.stop() as usize];
        if at.is_turned() { Stop { reversed: !stop.reversed, from: stop.to, to: stop.from, ..stop } } else { stop }
    }

    fn from(&self, place: usize) -> DVec2 {
        self.ends[self.tour[place].end(0)]
    }

    fn to(&self, place: usize) -> DVec2 {
        self.ends[self.tour[place].end(1)]
    }

    /// Way from the stop before a place to the stop there; 0 at the tour's beginning and end.
    fn gap(&self, place: usize) -> f64 {
        if place == 0 || place >= self.tour.len() { 0.0 } else { self.to(place - 1).distance(self.from(place)) }
    }

    /// Ties one of a stop's ends to an end nearby, in the first way found that saves some. Adds the stops at whose ends
    /// something changed to `changed`.
    fn improve_at(&mut self, stop: u32, changed: &mut Vec<u32>) {
        let place = self.place_of[stop as usize] as usize;
        for lifted in [false, true] {
            let end = self.tour[place].end(usize::from(lifted));
            let gap = self.gap(place + usize::from(lifted));
            for candidate in self.candidates[end] {
                // A tie as long as the one there now saves nothing here; what it saves elsewhere is found from there.
                if candidate == NONE || self.ends[end].distance(self.ends[candidate as usize]) >= gap {
                    break;
                }
                let other = self.place_of[candidate as usize / 2] as usize;
                let other_lifted = self.tour[other].end(1) == candidate as usize;
                if other.abs_diff(place) <= MAX_SPAN
                    && self.tie(End { place, lifted }, End { place: other, lifted: other_lifted }, changed)
                {
                    return;
                }
            }
        }
    }

    /// Makes two ends neighbours if that saves way. Whether it did.
    fn tie(&mut self, end: End, other: End, changed: &mut Vec<u32>) -> bool {
        if end.lifted == other.lifted {
            let (low, high) = (end.place.min(other.place), end.place.max(other.place));
            let (first, last) = if end.lifted { (low + 1, high) } else { (low, high - 1) };
            if self.saving_of_reversal(first, last) > LEAST_SAVING {
                self.reverse(first, last, changed);
                return true;
            }
        }
        for length in 1..=MAX_RUN {
            for [moved, target] in [[end, other], [other, end]] {
                let Some(run) = self.run(moved, target, length) else { continue };
                if self.saving_of_move(&run) > LEAST_SAVING {
                    self.make_move(&run, changed);
                    return true;
                }
            }
        }
        false
    }

    /// What turning round the stops from `first` to `last` saves.
    fn saving_of_reversal(&self, first: usize, last: usize) -> f64 {
        let mut saving = self.gap(first) + self.gap(last + 1);
        if first > 0 {
            saving -= self.to(first - 1).distance(self.to(last));
        }
        if last + 1 < self.tour.len() {
            saving -= self.from(first).distance(self.from(last + 1));
        }
        saving
    }

    fn reverse(&mut self, first: usize, last: usize, changed: &mut Vec<u32>) {
        self.note([first.checked_sub(1), Some(first), Some(last), Some(last + 1)], changed);
        turn_round(&mut self.tour[first..=last]);
        self.renumber(first, last);
    }

    /// The run of a length that begins or ends with the moved end, to be put next to the target; none where the two
    /// overlap.
    fn run(&self, moved: End, target: End, length: usize) -> Option<Run> {
        let (first, last) = if moved.lifted {
            ((moved.place + 1).checked_sub(length)?, moved.place)
        } else {
            (moved.place, moved.place + length - 1)
        };
        let before = target.place + usize::from(target.lifted);
        let apart = before < first || before > last + 1;
        let is_apart = apart && last < self.tour.len() && !(first..=last).contains(&target.place);
        is_apart.then_some(Run { first, last, before, reversed: moved.lifted == target.lifted })
    }

    fn saving_of_move(&self, run: &Run) -> f64 {
        let &Run { first, last, before, reversed } = run;
        let mut saving = self.gap(first) + self.gap(last + 1) + self.gap(before);
        if first > 0 && last + 1 < self.tour.len() {
            saving -= self.to(first - 1).distance(self.from(last + 1));
        }
        let (front, back) =
            if reversed { (self.to(last), self.from(first)) } else { (self.from(first), self.to(last)) };
        if before > 0 {
            saving -= self.to(before - 1).distance(front);
        }
        if before < self.tour.len() {
            saving -= back.distance(self.from(before));
        }
        saving
    }

    fn make_move(&mut self, run: &Run, changed: &mut Vec<u32>) {
        let &Run { first, last, before, reversed } = run;
        let length = last + 1 - first;
        self.note([first.checked_sub(1), Some(first), Some(last), Some(last + 1)], changed);
        self.note([before.checked_sub(1), Some(before), None, None], changed);
        let (low, high, moved) = if before > last {
            self.tour[first..before].rotate_left(length);
            (first, before - 1, before - length..before)
        } else {
            self.tour[before..=last].rotate_right(length);
            (before, last, before..before + length)
        };
        if reversed {
            turn_round(&mut self.tour[moved]);
        }
        self.renumber(low, high);
    }

    /// Adds the stops at these places, where there are some, to `changed`.
    fn note(&self, places: [Option<usize>; 4], changed: &mut Vec<u32>) {
        let stops = places.into_iter().flatten().filter_map(|place| self.tour.get(place));
        changed.extend(stops.map(|at| at.stop()));
    }

    fn renumber(&mut self, first: usize, last: usize) {
        for place in first..=last {
            self.place_of[self.tour[place].stop() as usize] = place as u32;
        }
    }
}

fn turn_round(tour: &mut [Turned]) {
    tour.reverse();
    tour.iter_mut().for_each(|at| *at = at.around());
}
