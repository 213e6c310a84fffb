//! [`Recommendation`]: the answer, with everything that it rests on.

use super::Request;
use super::candidates::Candidate;
use super::choice::{Choice, Examined};
use super::meter::{Meter, Preparation, Sample};
use super::notebook::{Measurer, Page};
use super::promise::{LEAST_CONFIDENCE, bound, confidence, exceeded_by, rank};
use super::race::Standing;
use super::views::Purpose;
use serde::Serialize;

/// Which method to use, and why.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Recommendation {
    /// What was wanted.
    pub request: Request,
    /// The fastest candidate that keeps to the limits; `None` where none does. Without a promise where there was no time to examine
    /// it in enough views.
    pub chosen: Option<Finding>,
    /// The next one of another method that keeps to them.
    pub runner_up: Option<Finding>,
    /// The fastest one that errs at most half as much as the choice, or else less.
    pub one_step_better: Option<Better>,
    /// Where nothing is chosen: who errs least within the time.
    pub least_error_in_time: Option<Finding>,
    /// Where nothing is chosen: who is fastest within the error.
    pub fastest_within_error: Option<Finding>,
    /// What kept to the limits at first and then did not.
    pub failed: Vec<Finding>,
    /// Everything that was measured, the fastest first.
    pub measured: Vec<Finding>,
    /// What was not measured, and why.
    pub not_measured: Vec<NotMeasured>,
    /// Seconds that the calibration took.
    pub seconds: f64,
    /// Number of views measured now, beyond those that were cached.
    pub views_measured: u32,
}

/// What is known of a candidate.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Finding {
    /// Its number.
    #[serde(skip)]
    pub candidate: usize,
    /// The method.
    pub method: String,
    /// What is not at its default, as `--set` takes it.
    pub set: Option<String>,
    /// Whether the method always yields all silhouette edges and no others, whatever is measured.
    pub exact: bool,
    /// Number of views that the figures are of.
    pub views: u32,
    /// Median time in milliseconds.
    pub ms: f64,
    /// Longest time.
    pub worst_ms: f64,
    /// Largest error.
    pub worst_error: f64,
    /// What preparing it takes and makes.
    pub preparation: Option<Preparation>,
    /// What is promised of it, where it was examined.
    pub promise: Option<Promise>,
}

/// A candidate that errs less than the choice, both by the same views.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Better {
    /// That one.
    pub better: Finding,
    /// The choice.
    pub choice: Finding,
}

/// What is promised of [`SHARE`](super::promise::SHARE) of all views.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Promise {
    /// Largest error: what was asked for.
    pub error: f64,
    /// Longest time in milliseconds: what was asked for, or what was measured where nothing was.
    pub ms: f64,
    /// Number of views that back it, none of which the choice had seen.
    pub views: u32,
    /// How many of them exceeded it; where the time is found out from them, how many may.
    pub over: u32,
    /// Confidence, 0 to 1.
    pub confidence: f64,
    /// The error that the same share of views keeps to, by the same views.
    pub measured_error: f64,
    /// The time that the same share of views keeps to, by the same views.
    pub measured_ms: f64,
}

/// A candidate that was not measured.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct NotMeasured {
    /// The method.
    pub method: String,
    /// What is not at its default.
    pub set: Option<String>,
    /// Why.
    pub reason: Reason,
}

/// Why a candidate was not measured.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case", tag = "kind", content = "text")]
pub enum Reason {
    /// Its preparation takes longer than it may during a calibration.
    SlowPreparation,
    /// The method's default options could not be measured, so that others were not tried.
    AsItsDefaults,
    /// There was no time left.
    NoTime,
    /// It is not defined for the mesh, or the device lacks something.
    Refused(String),
}

impl Recommendation {
    /// What a choice means. O(candidates x views).
    pub(super) fn new<M: Meter>(
        measurer: &Measurer<'_, M>,
        request: &Request,
        candidates: &[Candidate],
        standings: &[Standing],
        choice: &Choice,
    ) -> Self {
        let of = |candidate: usize, purpose: Purpose, views: u32| {
            let samples = measurer.page(candidate).samples(purpose);
            let seen = &samples[..samples.len().min(views as usize)];
            finding(measurer.page(candidate), candidate, &candidates[candidate], request, seen)
        };
        let bare = |candidate: usize| of(candidate, Purpose::Choice, u32::MAX);
        let examined = |examined: &Examined| {
            let found = of(examined.candidate, Purpose::Promise, examined.views)?;
            let backing = &measurer.page(examined.candidate).samples(Purpose::Promise)[..examined.views as usize];
            Some(Finding { promise: promise(backing, request, examined), ..found })
        };
        let runner_up = choice.runner_up.as_ref();
        let is_measured = |candidate: usize| standings.iter().any(|standing| standing.candidate == candidate);
        let left_out = (0..candidates.len()).filter(|&candidate| !is_measured(candidate));
        let not_measured = left_out.map(|candidate| NotMeasured {
            method: candidates[candidate].method().to_owned(),
            set: candidates[candidate].set(),
            reason: reason(measurer, candidate, candidates),
        });
        Self {
            request: request.clone(),
            chosen: choice.chosen.as_ref().and_then(|chosen| examined(chosen).or_else(|| bare(chosen.candidate))),
            runner_up: runner_up.and_then(|(candidate, e)| e.as_ref().map_or_else(|| bare(*candidate), examined)),
            one_step_better: choice.better.zip(choice.chosen).and_then(|((candidate, views), chosen)| {
                let better = of(candidate, Purpose::Choice, views)?;
                Some(Better { better, choice: of(chosen.candidate, Purpose::Choice, views)? })
            }),
            least_error_in_time: choice.nearest[0].and_then(bare),
            fastest_within_error: choice.nearest[1].and_then(bare),
            failed: choice.failed.iter().filter_map(examined).collect(),
            measured: standings.iter().filter_map(|standing| bare(standing.candidate)).collect(),
            not_measured: not_measured.collect(),
            seconds: measurer.elapsed_s(),
            views_measured: measurer.measured(),
        }
    }
}

/// What some views say of a candidate; `None` of none.
fn finding(page: &Page, candidate: usize, of: &Candidate, request: &Request, seen: &[Sample]) -> Option<Finding> {
    let Standing { ms, error, views, .. } = Standing::of(candidate, seen, request.metric)?;
    Some(Finding {
        candidate,
        method: of.method().to_owned(),
        set: of.set(),
        exact: of.entry.info().exact && of.entry.capabilities().edges,
        views,
        ms,
        worst_ms: seen.iter().map(|sample| sample.ms).fold(0.0, f64::max),
        worst_error: error,
        preparation: page.preparation.clone(),
        promise: None,
    })
}

/// What an examination that holds lets promise.
fn promise(backing: &[Sample], request: &Request, examined: &Examined) -> Option<Promise> {
    let within = |sample: &&Sample| sample.errors[request.metric] <= request.limit.max;
    // A time that the same views show is exceeded by as many of them as it leaves out: they count.
    let (over, ms) = match request.max_ms {
        Some(ms) => (examined.over, ms),
        None => {
            let over = rank(examined.views, examined.over, examined.examined);
            let left_out = backing.iter().filter(|sample| !within(sample)).count() as u32;
            (over, exceeded_by(backing.iter().filter(within).map(|sample| sample.ms), over.saturating_sub(left_out))?)
        }
    };
    let confidence = confidence(examined.views, over, examined.examined);
    if !examined.holds || confidence < LEAST_CONFIDENCE {
        return None;
    }
    let measured_error = bound(backing.iter().map(|sample| sample.errors[request.metric]), examined.examined)?;
    let measured_ms = bound(backing.iter().map(|sample| sample.ms), examined.examined)?;
    Some(Promise { error: request.limit.max, ms, views: examined.views, over, confidence, measured_error, measured_ms })
}

fn reason<M: Meter>(measurer: &Measurer<'_, M>, candidate: usize, candidates: &[Candidate]) -> Reason {
    let page = measurer.page(candidate);
    if let Some(refused) = &page.refused {
        return Reason::Refused(refused.clone());
    }
    if page.too_slow_s.is_some() {
        return Reason::SlowPreparation;
    }
    let is_default = |other: &Candidate| other.changed.is_none() && other.method() == candidates[candidate].method();
    let default = candidates.iter().position(is_default).map(|default| measurer.page(default));
    match default {
        Some(page) if page.refused.is_some() || page.too_slow_s.is_some() => Reason::AsItsDefaults,
        _ => Reason::NoTime,
    }
}
