//! [`Meter`]: measures candidates in views. [`PictureMeter`](super::PictureMeter) and [`LoopMeter`](super::LoopMeter) do so with real
//! frames; tests put one with known distributions in their place.

use super::views::ViewId;
use crate::cost::PrepareCost;
use crate::record::ArtefactRecord;
use crate::runner::CompareError;
use serde::{Deserialize, Serialize};
use silhouette_core::Progress;
use std::time::{Duration, Instant};

/// What preparing a candidate took and made.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Preparation {
    /// Time and bytes.
    pub cost: PrepareCost,
    /// The artefacts that were built, in the order of completion.
    pub artefacts: Vec<ArtefactRecord>,
    /// Bytes that the method holds beyond them.
    pub own_bytes: u64,
}

/// A view measured.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Sample {
    /// Wall time in milliseconds: of the whole frame for pictures, of the extraction for loops.
    pub ms: f64,
    /// The errors, in the order of [`Goal::metrics`](super::Goal::metrics).
    pub errors: Vec<f64>,
}

/// Why something was not measured.
#[derive(Debug)]
pub enum Fault {
    /// There was no time left.
    OutOfTime,
    /// The candidate cannot be measured on this mesh or this device, for this reason.
    Refused(String),
    /// Nothing can be measured.
    Failed(CompareError),
}

impl From<CompareError> for Fault {
    fn from(error: CompareError) -> Self {
        Self::Failed(error)
    }
}

/// Measures candidates, which it knows by their number.
pub trait Meter {
    /// Prepares what does not depend on a candidate, such as the truth, so that its time is not taken from the first one.
    ///
    /// # Errors
    /// [`Fault`], as for [`prepare`](Self::prepare).
    fn set_up(&mut self, _until_s: f64) -> Result<(), Fault> {
        Ok(())
    }

    /// Prepares a candidate, the one whose views are measured next.
    ///
    /// # Errors
    /// [`Fault`]; out of time where it is not done when [`elapsed_s`](Self::elapsed_s) passes `until_s`.
    fn prepare(&mut self, candidate: usize, until_s: f64) -> Result<Preparation, Fault>;

    /// Measures a view of the candidate prepared last.
    ///
    /// # Errors
    /// [`Fault`], as for [`prepare`](Self::prepare).
    fn sample(&mut self, candidate: usize, view: ViewId, until_s: f64) -> Result<Sample, Fault>;

    /// Seconds since measuring began.
    fn elapsed_s(&self) -> f64;
}

/// Progress that also stops at a time, and keeps the stages of preparations to itself.
pub(super) struct Until<'a> {
    pub progress: &'a dyn Progress,
    pub end: Instant,
}

impl<'a> Until<'a> {
    /// Stops `until_s` seconds after `start`.
    pub fn new(progress: &'a dyn Progress, start: Instant, until_s: f64) -> Self {
        let duration = Duration::try_from_secs_f64(until_s.max(0.0)).unwrap_or(Duration::MAX);
        let end = start.checked_add(duration).unwrap_or_else(|| start + Duration::from_hours(24));
        Self { progress, end }
    }

    /// A cancelled step's fault: out of time unless the user asked to stop.
    pub fn fault(&self, cancelled: silhouette_core::Cancelled) -> Fault {
        if self.progress.is_cancelled() { CompareError::from(cancelled).into() } else { Fault::OutOfTime }
    }
}

impl Progress for Until<'_> {
    fn stage(&self, _name: &str, _total: u64) {}
    fn advance(&self, _steps: u64) {}
    fn is_cancelled(&self) -> bool {
        self.progress.is_cancelled() || Instant::now() >= self.end
    }
}
