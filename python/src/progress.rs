//! Work without the interpreter's lock: other Python threads run meanwhile, Ctrl-C cancels, and a callback hears how far it is.

use crate::errors::{bad_input, exception};
use pyo3::exceptions::PyUserWarning;
use pyo3::prelude::*;
use silhouette_core::Progress;
use silhouettes::application::Failure;
use silhouettes::calls;
use std::ffi::CString;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// How often pending signals are checked and the callback is called.
const INTERVAL: Duration = Duration::from_millis(50);

/// How far the work is.
#[derive(Default)]
struct Report {
    is_cancelled: AtomicBool,
    done: AtomicU64,
    stage: Mutex<(String, u64)>,
}

impl Report {
    fn stage_and_total(&self) -> (String, u64) {
        self.stage.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

impl Progress for Report {
    fn stage(&self, name: &str, total: u64) {
        *self.stage.lock().unwrap_or_else(PoisonError::into_inner) = (name.to_owned(), total);
        self.done.store(0, Ordering::Relaxed);
    }

    fn advance(&self, steps: u64) {
        self.done.fetch_add(steps, Ordering::Relaxed);
    }

    fn is_cancelled(&self) -> bool {
        self.is_cancelled.load(Ordering::Relaxed)
    }
}

/// Does work on a thread of its own. This thread, on which alone Python delivers signals, waits for it, and cancels it when a signal
/// or `callback(stage, done, total)` raises; the work's result is then dropped.
///
/// Notes of the work become warnings once it is done.
///
/// # Errors
/// What the signal or the callback raised, or else the failure of the work.
pub fn run<T: Send>(
    py: Python<'_>,
    callback: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&dyn Progress) -> Result<T, Failure> + Send,
) -> PyResult<T> {
    let callback = callback.map(|callback| callback.clone().unbind());
    let report = Report::default();
    let raised = Mutex::new(None);
    let result = py.detach(|| {
        std::thread::scope(|scope| {
            let (sender, receiver) = channel();
            let report = &report;
            let worker = scope.spawn(move || {
                let result = calls::with_notes(|| work(report));
                // Where nobody receives, the scope waits for this thread itself.
                let _ = sender.send(());
                result
            });
            while receiver.recv_timeout(INTERVAL) == Err(RecvTimeoutError::Timeout) {
                if report.is_cancelled() {
                    continue;
                }
                let heard = Python::attach(|py| {
                    py.check_signals()?;
                    let Some(callback) = &callback else { return Ok(()) };
                    let (stage, total) = report.stage_and_total();
                    callback.call1(py, (stage, report.done.load(Ordering::Relaxed), total)).map(drop)
                });
                if let Err(error) = heard {
                    *raised.lock().unwrap_or_else(PoisonError::into_inner) = Some(error);
                    report.is_cancelled.store(true, Ordering::Relaxed);
                }
            }
            worker.join()
        })
    });
    if let Some(error) = raised.into_inner().unwrap_or_else(PoisonError::into_inner) {
        return Err(error);
    }
    match result {
        Ok((result, notes)) => {
            let result = result.map_err(|failure| exception(&failure))?;
            notes.iter().try_for_each(|note| warn(py, note))?;
            Ok(result)
        }
        // pyo3 makes an exception of it.
        Err(panic) => std::panic::resume_unwind(panic),
    }
}

/// Warns of what does not stop a call, but its user has to know.
pub fn warn(py: Python<'_>, text: &str) -> PyResult<()> {
    let text = CString::new(text).map_err(bad_input)?;
    PyErr::warn(py, &py.get_type::<PyUserWarning>(), &text, 1)
}
