//! [`check`]: the promise against views that nothing saw before. A promise that was made from wrong measurements is found out here.

use super::meter::Meter;
use super::notebook::Measurer;
use super::promise::{CONFIDENCE, SHARE, doubt};
use super::recommendation::{Finding, Recommendation};
use super::views::{Purpose, ViewId};
use crate::runner::CompareError;
use serde::Serialize;

/// Most views of a check.
pub const MAX_VIEWS: u32 = 10_000;

/// How a promise fared.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Check {
    /// Number of views.
    pub views: u32,
    /// How many kept to the error that was promised.
    pub within_error: u32,
    /// How many kept to the time that was promised.
    pub within_ms: u32,
    /// How many kept to both.
    pub within_both: u32,
    /// Largest error.
    pub worst_error: f64,
    /// Longest time in milliseconds.
    pub worst_ms: f64,
}

impl Check {
    /// Whether at least [`SHARE`] of the views kept to both.
    pub fn is_kept(&self) -> bool {
        f64::from(self.within_both) >= SHARE * f64::from(self.views)
    }

    /// Whether so many views exceed it that this would happen to a promise which [`SHARE`] of all views keep in at most one check of
    /// twenty: fewer views than that share asks for are not enough, where few were looked at.
    pub fn is_refuted(&self) -> bool {
        let over = self.views - self.within_both;
        over > 0 && 1.0 - doubt(self.views, over - 1) <= 1.0 - CONFIDENCE
    }
}

/// Measures what is recommended in `views` more views; `None` where nothing is recommended, or it cannot be prepared any more. Takes as
/// long as that takes: the calibration's time plays no part.
///
/// # Errors
/// Nothing can be measured.
pub fn check<M: Meter>(
    measurer: &mut Measurer<'_, M>,
    recommendation: &Recommendation,
    views: u32,
) -> Result<Option<Check>, CompareError> {
    let Some(Finding { candidate, promise: Some(promise), .. }) = &recommendation.chosen else { return Ok(None) };
    let mut check = Check { views: 0, within_error: 0, within_ms: 0, within_both: 0, worst_error: 0.0, worst_ms: 0.0 };
    for index in 0..views.min(MAX_VIEWS) {
        let view = ViewId { purpose: Purpose::Check, index };
        let Some(sample) = measurer.sample(*candidate, view, f64::INFINITY, f64::INFINITY)? else { return Ok(None) };
        let (ms, error) = (sample.ms, sample.errors[recommendation.request.metric]);
        let within = [error <= promise.error, ms <= promise.ms];
        check.views += 1;
        check.within_error += u32::from(within[0]);
        check.within_ms += u32::from(within[1]);
        check.within_both += u32::from(within == [true; 2]);
        check.worst_error = check.worst_error.max(error);
        check.worst_ms = check.worst_ms.max(ms);
    }
    Ok((check.views > 0).then_some(check))
}
