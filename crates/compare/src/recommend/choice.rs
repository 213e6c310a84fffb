//! Step 6: the choice, and what stands beside it.
//!
//! 1. Candidates that kept to the limits in the race are examined, the fastest first, in views that the race did not see, until one
//!    keeps to them often enough for the [promise](super::promise).
//! 2. The runner-up is the next of another method, examined likewise if there is time.
//! 3. One step better is the fastest that errs at most half as much as the choice in the same views of the race, or else the fastest
//!    that errs clearly less.
//! 4. Where nothing keeps to the limits, what comes closest: the least error in the time, and the fastest within the error.

use super::Request;
use super::meter::{Meter, Sample};
use super::notebook::Measurer;
use super::promise::allowed;
use super::race::Standing;
use super::views::{Purpose, ViewId};
use crate::runner::CompareError;

/// Views that a candidate is examined in: two of them may exceed a limit by chance, as frames on a machine that does other work
/// as well do.
pub const VIEWS: u32 = 124;

/// Share of the time left that an examination may take before it is known to go well, so that another candidate has a chance.
const EXAMINATION: f64 = 0.75;

/// Share of the calibration's time after which the runner-up is not examined any more.
const RUNNER_UP_END: f64 = 0.9;

/// How much less an error must be to count as less.
const LESS: f64 = 0.95;

/// What was examined, and how it went.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Examined {
    /// The candidate.
    pub candidate: usize,
    /// Number of views.
    pub views: u32,
    /// How many of them exceeded a limit.
    pub over: u32,
    /// How many candidates were examined up to and with this one.
    pub examined: u32,
    /// Whether it may be promised.
    pub holds: bool,
}

/// Numbers of the candidates that matter.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Choice {
    /// The fastest that keeps to the limits.
    pub chosen: Option<Examined>,
    /// The next of another method; without an examination where there was no time for it.
    pub runner_up: Option<(usize, Option<Examined>)>,
    /// The fastest that errs clearly less than the choice, and in how many views it does.
    pub better: Option<(usize, u32)>,
    /// Where nothing is chosen: who errs least within the time, then who is fastest within the error.
    pub nearest: [Option<usize>; 2],
    /// Everything that was examined and did not keep to the limits.
    pub failed: Vec<Examined>,
}

/// Chooses among the standings of a race, the fastest first.
///
/// # Errors
/// Nothing can be measured.
pub fn choose<M: Meter>(
    measurer: &mut Measurer<'_, M>,
    request: &Request,
    standings: &[Standing],
) -> Result<Choice, CompareError> {
    let mut choice = Choice::default();
    let mut eligible = standings.iter().filter(|standing| request.is_kept(standing.ms, standing.error));
    for standing in eligible.by_ref() {
        let count = choice.failed.len() as u32 + 1;
        let elapsed_s = measurer.elapsed_s();
        let until_s = elapsed_s + (request.seconds - elapsed_s) * EXAMINATION;
        let mut examined = examine(measurer, request, standing.candidate, count, until_s)?;
        if examined.holds {
            examined = examine(measurer, request, standing.candidate, count, request.seconds)?;
        }
        // Where there is no time for a single view, there is a choice, but no promise.
        if examined.holds || examined.views == 0 {
            choice.chosen = Some(examined);
            break;
        }
        choice.failed.push(examined);
    }
    let Some(chosen) = choice.chosen else {
        choice.nearest = nearest(request, standings);
        return Ok(choice);
    };
    let method = |candidate: usize| measurer.page(candidate).method.clone();
    let own = method(chosen.candidate);
    let next = eligible.find(|standing| method(standing.candidate) != own);
    if let Some(next) = next.map(|standing| standing.candidate) {
        let until_s = request.seconds * RUNNER_UP_END;
        let examined = examine(measurer, request, next, chosen.examined + 1, until_s)?;
        choice.runner_up = Some((next, (examined.views > 0).then_some(examined)));
    }
    choice.better = better(measurer, request, chosen.candidate, standings);
    Ok(choice)
}

/// Measures views until there are enough, too many exceed a limit, or the time is over.
fn examine<M: Meter>(
    measurer: &mut Measurer<'_, M>,
    request: &Request,
    candidate: usize,
    examined: u32,
    until_s: f64,
) -> Result<Examined, CompareError> {
    let most_over = allowed(VIEWS, examined).unwrap_or(0);
    let (mut views, mut over) = (0, 0);
    while views < VIEWS && over <= most_over {
        let view = ViewId { purpose: Purpose::Promise, index: views };
        let Some(sample) = measurer.sample(candidate, view, until_s, until_s)? else { break };
        over += u32::from(!request.keeps(sample));
        views += 1;
    }
    // With fewer views than wanted, a promise is made with less confidence, and it says so.
    let holds = views > 0 && over <= most_over && over <= views / 20;
    Ok(Examined { candidate, views, over, examined, holds })
}

fn better<M: Meter>(
    measurer: &Measurer<'_, M>,
    request: &Request,
    chosen: usize,
    standings: &[Standing],
) -> Option<(usize, u32)> {
    let own = measurer.page(chosen).samples(Purpose::Choice);
    let errs_less = |standing: &&Standing, share: f64| {
        // A candidate that was dropped early has been seen in fewer views.
        let common = own.len().min(standing.views as usize);
        let own = Standing::of(chosen, &own[..common], request.metric);
        let samples = &measurer.page(standing.candidate).samples(Purpose::Choice)[..common];
        let other = Standing::of(standing.candidate, samples, request.metric);
        own.zip(other).is_some_and(|(own, other)| other.error <= own.error * share && other.error < own.error)
    };
    let found = [0.5, LESS].into_iter().find_map(|share| standings.iter().find(|standing| errs_less(standing, share)));
    found.map(|standing| (standing.candidate, standing.views.min(own.len() as u32)))
}

fn nearest(request: &Request, standings: &[Standing]) -> [Option<usize>; 2] {
    let in_time = standings.iter().filter(|standing| request.max_ms.is_none_or(|max_ms| standing.ms <= max_ms));
    let least = in_time.min_by(|one, other| one.error.total_cmp(&other.error).then(one.before(other)));
    let in_error = standings.iter().find(|standing| standing.error <= request.limit.max);
    [least, in_error].map(|standing| standing.map(|standing| standing.candidate))
}

impl Request {
    /// Whether a time and an error are within the limits.
    pub fn is_kept(&self, ms: f64, error: f64) -> bool {
        error <= self.limit.max && self.max_ms.is_none_or(|max_ms| ms <= max_ms)
    }

    /// Whether a view is within the limits.
    pub fn keeps(&self, sample: &Sample) -> bool {
        self.is_kept(sample.ms, sample.errors[self.metric])
    }
}
