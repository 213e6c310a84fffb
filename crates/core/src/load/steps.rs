//! Progress by bytes: cheap enough to report every row to.

use crate::progress::{Cancelled, Progress};

/// Bytes between two reports: about a millisecond of parsing, so that cancelling feels immediate and costs nothing.
const REPORT_EVERY: usize = 256 * 1024;

/// Turns an offset that grows row by row into few calls of a [`Progress`].
pub(super) struct Steps<'a> {
    progress: &'a dyn Progress,
    reported: usize,
}

impl<'a> Steps<'a> {
    /// Begins a stage of `total` bytes.
    pub(super) fn begin(progress: &'a dyn Progress, stage: &str, total: usize) -> Self {
        progress.stage(stage, total as u64);
        Self { progress, reported: 0 }
    }

    /// Everything before `offset` is done.
    pub(super) fn reach(&mut self, offset: usize) -> Result<(), Cancelled> {
        if offset < self.reported.saturating_add(REPORT_EVERY) { Ok(()) } else { self.report(offset) }
    }

    /// Reports now, and asks whether to go on.
    pub(super) fn report(&mut self, offset: usize) -> Result<(), Cancelled> {
        self.progress.advance(offset.saturating_sub(self.reported) as u64);
        self.reported = self.reported.max(offset);
        self.progress.check()
    }
}
