//! Progress and cancellation of long work, without a terminal in sight: a command line draws a bar, a server cancels.

/// Told how far a long piece of work has come, asked whether to go on.
///
/// Called from any thread, a few hundred times a second at most; implementations should be cheap.
pub trait Progress: Sync {
    /// A new stage begins, of `total` steps (0 where the number is not known beforehand).
    fn stage(&self, name: &str, total: u64);
    /// `steps` more steps of the current stage are done.
    fn advance(&self, steps: u64);
    /// Whether the work should stop; polled between steps.
    fn is_cancelled(&self) -> bool {
        false
    }

    /// `Err` once the work should stop, for use with `?`.
    ///
    /// # Errors
    /// [`Cancelled`] exactly when [`is_cancelled`](Self::is_cancelled).
    fn check(&self) -> Result<(), Cancelled> {
        if self.is_cancelled() { Err(Cancelled) } else { Ok(()) }
    }
}

/// Listens to nothing and never cancels.
#[derive(Debug, Clone, Copy, Default)]
pub struct NoProgress;

impl Progress for NoProgress {
    fn stage(&self, _name: &str, _total: u64) {}
    fn advance(&self, _steps: u64) {}
}

/// Asks another one whether to stop, and reports nothing to it: for work that is a step of a stage, and has stages of its own.
#[derive(Clone, Copy)]
pub struct Quiet<'a>(
    /// The one that is asked.
    pub &'a dyn Progress,
);

impl Progress for Quiet<'_> {
    fn stage(&self, _name: &str, _total: u64) {}
    fn advance(&self, _steps: u64) {}

    fn is_cancelled(&self) -> bool {
        self.0.is_cancelled()
    }
}

/// The work was stopped by its [`Progress`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("cancelled")]
pub struct Cancelled;
