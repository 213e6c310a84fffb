//! Step 4: the race. Candidates are measured in few views each, and those that cannot win are dropped as soon as that shows.
//!
//! 1. Every method with its default options in one view, in the order of the registry; a preparation that takes long is broken off.
//! 2. Those of them that are still in the race in some more views, the fastest first.
//! 3. Options at the values of their sweeps, those of fast methods first, until the race's share of the time is spent.
//! 4. Methods whose preparation was broken off, with more time for it.
//! 5. While nobody keeps the limits, and so there is nobody to examine, the options that are left, in the time that was the
//!    examinations'.
//!
//! A candidate is dropped by another that errs no more and is at least twice as fast, or where it misses a limit by that
//! factor while another keeps to both: single frames vary by less, on a machine that is not overloaded.

use super::Request;
use super::meter::{Meter, Sample};
use super::notebook::Measurer;
use super::views::{Purpose, ViewId};
use crate::runner::CompareError;

/// Views that a candidate is measured in unless it is dropped.
pub const VIEWS: u32 = 4;

/// Share of the race's and the examinations' time after which no other method is tried.
const METHODS_END: f64 = 0.5;

/// Share of that time after which no other option is tried.
const SWEEPS_END: f64 = 0.35;

/// Share of that time up to which options are tried while nobody keeps the limits; the rest is for examining one that does after all.
const SEARCH_END: f64 = 0.75;

/// Share of the calibration's time that one preparation may take at first: half a second of 20.
const PREPARATION: f64 = 0.025;

/// The same where nothing else is left to be tried: 2 seconds of 20, so that the method, if it is the one, can be prepared again to
/// be examined.
const LONG_PREPARATION: f64 = 0.1;

/// How much slower, or farther beyond a limit, a candidate is dropped.
const MARGIN: f64 = 2.0;

/// Where a candidate stands after the views that it was chosen by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Standing {
    /// Which one.
    pub candidate: usize,
    /// Median time in milliseconds.
    pub ms: f64,
    /// Largest error.
    pub error: f64,
    /// Number of views.
    pub views: u32,
}

impl Standing {
    /// Where samples put a candidate; `None` of none. O(n log n).
    pub fn of(candidate: usize, samples: &[Sample], metric: usize) -> Option<Self> {
        let mut times: Vec<f64> = samples.iter().map(|sample| sample.ms).collect();
        times.sort_by(f64::total_cmp);
        let error = samples.iter().map(|sample| sample.errors[metric]).fold(f64::NEG_INFINITY, f64::max);
        let ms = *times.get(times.len() / 2)?;
        Some(Self { candidate, ms, error, views: samples.len() as u32 })
    }

    /// By time, then error, then number.
    pub fn before(&self, other: &Self) -> std::cmp::Ordering {
        let by_cost = self.ms.total_cmp(&other.ms).then(self.error.total_cmp(&other.error));
        by_cost.then(self.candidate.cmp(&other.candidate))
    }
}

/// Runs the race over the candidates, of which those in `changed` have an option that is not at its default. Yields who was measured,
/// the fastest first.
///
/// # Errors
/// Nothing can be measured.
pub fn race<M: Meter>(
    measurer: &mut Measurer<'_, M>,
    request: &Request,
    changed: &[bool],
) -> Result<Vec<Standing>, CompareError> {
    let start_s = measurer.elapsed_s();
    let mut race = Race { measurer, request, start_s, standings: vec![None; changed.len()] };
    let [mut defaults, mut sweeps] = [false, true]
        .map(|of_sweep| (0..changed.len()).filter(|&candidate| changed[candidate] == of_sweep).collect::<Vec<_>>());
    for &candidate in &defaults {
        race.enter(candidate, 1, PREPARATION, METHODS_END)?;
    }
    race.sort_by_time(&mut defaults, |race, candidate| race.standings[candidate]);
    for &candidate in &defaults {
        if race.standings[candidate].is_some_and(|standing| !race.is_dropped(&standing)) {
            race.enter(candidate, VIEWS, PREPARATION, METHODS_END)?;
        }
    }
    // A method whose defaults refuse the mesh or take too long to prepare is not tried with other options.
    sweeps.retain(|&candidate| race.default_of(candidate).is_some());
    race.sort_by_time(&mut sweeps, Race::default_of);
    for &candidate in &sweeps {
        race.enter(candidate, VIEWS, PREPARATION, SWEEPS_END)?;
    }
    for &candidate in &defaults {
        if race.measurer.page(candidate).too_slow_s.is_some() {
            race.enter(candidate, VIEWS, LONG_PREPARATION, METHODS_END)?;
        }
    }
    for candidate in sweeps {
        if !race.is_anybody_kept() {
            race.enter(candidate, VIEWS, PREPARATION, SEARCH_END)?;
        }
    }
    let mut standings: Vec<Standing> = race.standings.into_iter().flatten().collect();
    standings.sort_by(Standing::before);
    Ok(standings)
}

struct Race<'a, 'b, M> {
    measurer: &'a mut Measurer<'b, M>,
    request: &'a Request,
    /// When it began.
    start_s: f64,
    /// By candidate; `None` where it was not measured.
    standings: Vec<Option<Standing>>,
}

impl<M: Meter> Race<'_, '_, M> {
    /// Measures a candidate until it has so many views or is dropped. What was measured before counts whenever it was.
    fn enter(&mut self, candidate: usize, views: u32, preparation: f64, share: f64) -> Result<(), CompareError> {
        let until_s = self.start_s + (self.request.seconds - self.start_s) * share;
        let prepare_until_s = self.measurer.elapsed_s() + self.request.seconds * preparation;
        for index in 0..views {
            let view = ViewId { purpose: Purpose::Choice, index };
            if self.measurer.sample(candidate, view, prepare_until_s, until_s)?.is_none() {
                break;
            }
            let samples = &self.measurer.page(candidate).samples(Purpose::Choice)[..=index as usize];
            let standing = Standing::of(candidate, samples, self.request.metric);
            self.standings[candidate] = standing;
            if standing.is_some_and(|standing| self.is_dropped(&standing)) {
                break;
            }
        }
        Ok(())
    }

    /// Whether somebody keeps the limits.
    fn is_anybody_kept(&self) -> bool {
        self.standings.iter().flatten().any(|standing| self.request.is_kept(standing.ms, standing.error))
    }

    fn is_dropped(&self, standing: &Standing) -> bool {
        let others = || self.standings.iter().flatten();
        let is_beaten = others().any(|other| other.error <= standing.error && other.ms * MARGIN <= standing.ms);
        let Request { limit, max_ms, .. } = self.request;
        let is_late = max_ms.is_some_and(|max_ms| standing.ms > MARGIN * max_ms);
        let is_beyond = is_late || standing.error > MARGIN * limit.max;
        is_beaten || is_beyond && self.is_anybody_kept()
    }

    /// Where the method of a candidate stands with its default options.
    fn default_of(&self, candidate: usize) -> Option<Standing> {
        let method = |candidate: usize| self.measurer.page(candidate).method.as_str();
        self.standings.iter().flatten().find(|other| method(other.candidate) == method(candidate)).copied()
    }

    /// Sorts candidates by the time of a standing, those without one last.
    fn sort_by_time(&self, candidates: &mut [usize], of: impl Fn(&Self, usize) -> Option<Standing>) {
        let ms = |candidate: usize| of(self, candidate).map_or(f64::INFINITY, |standing| standing.ms);
        candidates.sort_by(|&one, &other| ms(one).total_cmp(&ms(other)).then(one.cmp(&other)));
    }
}
