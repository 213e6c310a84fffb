//! Progress on a terminal: a bar with the stage and the remaining time, once the work has taken a second; cancelled by Ctrl-C. Where a
//! command is observed, the observer sees and cancels it instead.

use crate::interrupt;
use crate::observer::{self, Observer};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use silhouette_core::Progress;
use std::io::IsTerminal;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Work that is done within this time shows no bar.
const QUIET: Duration = Duration::from_secs(1);

/// A bar on stderr where that is a terminal, silent elsewhere.
pub struct TerminalProgress {
    start: Instant,
    bar: Option<ProgressBar>,
    shown: Mutex<bool>,
    observer: Option<Arc<dyn Observer>>,
}

impl TerminalProgress {
    /// A bar that appears after a second of work.
    pub fn new() -> Self {
        let observer = observer::current();
        let bar = (observer.is_none() && std::io::stderr().is_terminal()).then(|| {
            let style = ProgressStyle::with_template("{msg} [{bar:40}] {pos}/{len}, {eta} left")
                .expect("the template is a constant and tested")
                .progress_chars("=> ");
            ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden()).with_style(style)
        });
        Self { start: Instant::now(), bar, shown: Mutex::new(false), observer }
    }

    fn show_when_due(&self, bar: &ProgressBar) {
        if self.start.elapsed() < QUIET {
            return;
        }
        let mut shown = self.shown.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if !*shown {
            bar.set_draw_target(ProgressDrawTarget::stderr());
            *shown = true;
        }
    }
}

impl Progress for TerminalProgress {
    fn stage(&self, name: &str, total: u64) {
        if let Some(observer) = &self.observer {
            observer.stage(name, total);
        }
        if let Some(bar) = &self.bar {
            bar.reset();
            bar.set_length(total);
            bar.set_message(name.to_owned());
            self.show_when_due(bar);
        }
    }

    fn advance(&self, steps: u64) {
        if let Some(observer) = &self.observer {
            observer.advance(steps);
        }
        if let Some(bar) = &self.bar {
            bar.inc(steps);
            self.show_when_due(bar);
        }
    }

    fn is_cancelled(&self) -> bool {
        interrupt::is_asked() || self.observer.as_ref().is_some_and(|observer| observer.is_cancelled())
    }
}

impl Drop for TerminalProgress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
