//! [`Notebook`]: everything that was measured, by candidate, so that no view is measured twice: not for another purpose, and, as it is
//! [cached](super::cache), not for another budget.

use super::Request;
use super::candidates::Candidate;
use super::goal::ErrorLimit;
use super::meter::{Fault, Meter, Preparation, Sample};
use super::views::{Purpose, ViewId};
use crate::runner::CompareError;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Measurements of all candidates of a goal.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Notebook {
    /// A page per candidate.
    pub pages: Vec<Page>,
    /// What was answered from it, so that the same question has the same answer.
    pub answered: Vec<Question>,
}

/// What a recommendation depends on beside the measurements.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Question {
    /// Largest error.
    pub limit: ErrorLimit,
    /// Longest time in milliseconds.
    pub max_ms: Option<f64>,
    /// Seconds that measuring might take.
    pub seconds: f64,
}

/// Most questions that are remembered, the last ones.
const QUESTIONS: usize = 64;

/// Measurements of one candidate.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Page {
    /// Name of the method.
    pub method: String,
    /// All options.
    pub options: String,
    /// What its preparation took and made, once it was prepared.
    pub preparation: Option<Preparation>,
    /// Why it cannot be measured.
    pub refused: Option<String>,
    /// Seconds that its preparation was given, where they did not suffice.
    pub too_slow_s: Option<f64>,
    /// Views in the order of their index, the first without a gap.
    pub samples: BTreeMap<Purpose, Vec<Sample>>,
}

impl Page {
    /// The views of a purpose.
    pub fn samples(&self, purpose: Purpose) -> &[Sample] {
        self.samples.get(&purpose).map_or(&[], Vec::as_slice)
    }
}

impl Notebook {
    /// Whether each sample has so many errors and all numbers are finite. O(samples).
    pub fn is_sound(&self, errors: usize) -> bool {
        let is_sound = |sample: &Sample| {
            sample.errors.len() == errors && sample.errors.iter().chain([&sample.ms]).all(|value| value.is_finite())
        };
        self.pages.iter().flat_map(|page| page.samples.values().flatten()).all(is_sound)
    }

    /// The same measurements, with a page for each candidate in their order.
    #[must_use]
    pub fn arranged(mut self, candidates: &[Candidate]) -> Self {
        let page = |candidate: &Candidate| {
            let (method, options) = (candidate.method(), candidate.options.to_string());
            let known = self.pages.iter_mut().find(|page| page.method == method && page.options == options);
            known.map_or_else(|| Page { method: method.to_owned(), options, ..Page::default() }, std::mem::take)
        };
        Self { pages: candidates.iter().map(page).collect(), ..self }
    }
}

/// A meter with the notebook that it fills.
pub struct Measurer<'a, M> {
    meter: &'a mut M,
    notebook: &'a mut Notebook,
    prepared: Option<usize>,
    measured: u32,
    /// Seconds that the last view of the prepared candidate took: what its next one is expected to take.
    view_s: f64,
    is_closed: bool,
}

impl<'a, M: Meter> Measurer<'a, M> {
    /// A meter with a notebook that has a page for each of its candidates.
    pub fn new(meter: &'a mut M, notebook: &'a mut Notebook) -> Self {
        Self { meter, notebook, prepared: None, measured: 0, view_s: 0.0, is_closed: false }
    }

    /// Whether a question was answered before. It is then answered from the notebook alone: but for [checks](Purpose::Check) nothing
    /// is measured from now on.
    pub(super) fn ask(&mut self, request: &Request) {
        let Request { limit, max_ms, seconds, .. } = request;
        let question = Question { limit: limit.clone(), max_ms: *max_ms, seconds: *seconds };
        let answered = &mut self.notebook.answered;
        self.is_closed = answered.contains(&question);
        if !self.is_closed {
            answered.push(question);
            let surplus = answered.len().saturating_sub(QUESTIONS);
            answered.drain(..surplus);
        }
    }

    /// Sets the meter up, as far as there is time, unless nothing is going to be measured.
    ///
    /// # Errors
    /// Nothing can be measured.
    pub(super) fn set_up(&mut self, until_s: f64) -> Result<(), CompareError> {
        if self.is_closed {
            return Ok(());
        }
        match self.meter.set_up(until_s) {
            Ok(()) | Err(Fault::OutOfTime | Fault::Refused(_)) => Ok(()),
            Err(Fault::Failed(error)) => Err(error),
        }
    }

    /// The page of a candidate.
    pub fn page(&self, candidate: usize) -> &Page {
        &self.notebook.pages[candidate]
    }

    /// Number of candidates.
    pub fn count(&self) -> usize {
        self.notebook.pages.len()
    }

    /// Seconds since measuring began.
    pub fn elapsed_s(&self) -> f64 {
        self.meter.elapsed_s()
    }

    /// Number of views that were not in the notebook.
    pub fn measured(&self) -> u32 {
        self.measured
    }

    /// Makes sure that views of a candidate can be measured. What does not work is noted; `false` where it does not.
    ///
    /// # Errors
    /// Nothing can be measured.
    fn prepare(&mut self, candidate: usize, until_s: f64) -> Result<bool, CompareError> {
        if self.prepared == Some(candidate) {
            return Ok(true);
        }
        let given_s = until_s - self.elapsed_s();
        let page = &mut self.notebook.pages[candidate];
        if page.refused.is_some() || page.too_slow_s.is_some_and(|tried_s| given_s <= tried_s) {
            return Ok(false);
        }
        self.prepared = None;
        self.view_s = 0.0;
        match self.meter.prepare(candidate, until_s) {
            Ok(preparation) => {
                // The first is kept: later ones find the pipelines in the driver's cache.
                page.preparation.get_or_insert(preparation);
                page.too_slow_s = None;
                self.prepared = Some(candidate);
                return Ok(true);
            }
            Err(Fault::OutOfTime) => page.too_slow_s = Some(given_s.max(0.0)),
            Err(Fault::Refused(reason)) => page.refused = Some(reason),
            Err(Fault::Failed(error)) => return Err(error),
        }
        Ok(false)
    }

    /// The view of a candidate, measured unless it was before; preparing may take until `prepare_until_s` only. `None` where there
    /// is no time, or the candidate cannot be measured.
    ///
    /// # Errors
    /// Nothing can be measured.
    pub fn sample(
        &mut self,
        candidate: usize,
        view: ViewId,
        prepare_until_s: f64,
        until_s: f64,
    ) -> Result<Option<&Sample>, CompareError> {
        let known = self.page(candidate).samples(view.purpose).len();
        if (view.index as usize) < known {
            return Ok(self.page(candidate).samples(view.purpose).get(view.index as usize));
        }
        debug_assert_eq!(view.index as usize, known, "views are measured in order");
        let is_closed = self.is_closed && view.purpose != Purpose::Check;
        if is_closed || self.elapsed_s() >= until_s || !self.prepare(candidate, prepare_until_s.min(until_s))? {
            return Ok(None);
        }
        let start_s = self.elapsed_s();
        if start_s + self.view_s > until_s {
            return Ok(None);
        }
        let measured = self.meter.sample(candidate, view, until_s);
        self.view_s = self.elapsed_s() - start_s;
        match measured {
            Ok(sample) => {
                self.measured += 1;
                let samples = self.notebook.pages[candidate].samples.entry(view.purpose).or_default();
                samples.push(sample);
                Ok(samples.last())
            }
            Err(Fault::OutOfTime) => Ok(None),
            Err(Fault::Refused(reason)) => {
                self.notebook.pages[candidate].refused = Some(reason);
                Ok(None)
            }
            Err(Fault::Failed(error)) => Err(error),
        }
    }
}
