//! Progress and cancellation of long work, without a terminal in sight: a command line draws a bar, a server cancels.

/// Receives how far a long piece of work has come, and decides whether it goes on.
///
/// Called from any thread and often, in some stages once per ray or texel; implementations should be cheap. While a mesh of a million
/// faces is prepared, calls of [`is_cancelled`](Self::is_cancelled) are at most about 80 ms apart on two cores; the time grows with the mesh.
pub trait Progress: Sync {
    /// A new stage begins, of `total` steps (0 where the number is not known beforehand).
    fn stage(&self, name: &str, total: u64);
    /// `steps` more steps of the current stage are done.
    fn advance(&self, steps: u64);
    /// Whether the work should stop; polled between and within steps.
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

/// Ignores all reports and never cancels.
#[derive(Debug, Clone, Copy, Default)]
pub struct NoProgress;

impl Progress for NoProgress {
    fn stage(&self, _name: &str, _total: u64) {}
    fn advance(&self, _steps: u64) {}
}

/// Passes on whether to stop, but no reports: for work that is one step of a stage and has stages of its own.
#[derive(Clone, Copy)]
pub struct Quiet<'a>(
    /// The one that decides.
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
