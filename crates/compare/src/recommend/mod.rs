//! Which method to use: the fastest that keeps to an error and a time on *this* mesh, by measurements on it.
//!
//! 1. [`goal`]: lines, fill or loops, and which error is limited. [`Request`]: the limits and the time that finding out may take.
//! 2. [`candidates`](mod@candidates): every method that can do it, with its defaults and with each swept option.
//! 3. [`views`]: directions drawn independently, each led up to by a few frames.
//! 4. [`race`]: all candidates in few views; those that cannot win are dropped.
//! 5. [`promise`]: how sure one can be after how many views.
//! 6. [`choice`]: the fastest candidates examined in more views until one holds, the runner-up, one step better, or what comes closest.
//! 7. [`check`](mod@check): the promise against views that nothing has seen.
//!
//! [`meter`]: what measures; [`notebook`]: what was measured; [`cache`]: the notebook between runs; [`text`]: the answer for people.
//!
//! ```no_run
//! use silhouette_compare::recommend::{Goal, Notebook, Request, Setting, candidates, recommend};
//! use silhouette_compare::recommend::{LoopMeter, Measurer};
//! use silhouette_compare::{NamedMesh, Profile, Registry};
//! use silhouette_core::{NoProgress, PreparedMesh, shapes};
//! use std::sync::Arc;
//!
//! let mesh = Arc::new(PreparedMesh::new(shapes::by_name("torus")?));
//! let named = NamedMesh { name: "torus".to_owned(), mesh };
//! let candidates = candidates(Goal::Loops, &Registry::builtin());
//! let setting = Setting::from(&Profile::Quick.scene());
//! let mut meter = LoopMeter::new(&named, &candidates, setting, &NoProgress)?;
//! let mut notebook = Notebook::default().arranged(&candidates);
//! let mut measurer = Measurer::new(&mut meter, &mut notebook);
//! let found = recommend(&mut measurer, &Request::new(Goal::Loops), &candidates)?;
//! println!("{}", found.chosen.expect("an extractor that is exact").method);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod cache;
pub mod candidates;
pub mod check;
pub mod choice;
pub mod goal;
pub mod loops;
pub mod meter;
pub mod notebook;
pub mod pictures;
pub mod promise;
pub mod race;
pub mod recommendation;
#[cfg(test)]
mod tests;
pub mod text;
mod true_pictures;
pub mod views;

pub use cache::{Cache, CacheKey};
pub use candidates::{Candidate, candidates};
pub use check::{Check, check};
pub use goal::{ErrorLimit, ErrorMetric, Goal, LimitFault};
pub use loops::LoopMeter;
pub use meter::Meter;
pub use notebook::{Measurer, Notebook};
pub use pictures::PictureMeter;
pub use recommendation::{Finding, Promise, Recommendation};
pub use views::Setting;

use crate::runner::CompareError;
use serde::Serialize;

/// Seconds that a calibration takes at most, but for the step that it is in.
pub const SECONDS: f64 = 20.0;

/// What is wanted, and what it may cost to find out.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Request {
    /// What the method is for.
    pub goal: Goal,
    /// How large an error may be.
    pub limit: ErrorLimit,
    /// Where the limited error stands among [`Goal::metrics`].
    #[serde(skip)]
    pub metric: usize,
    /// How long a frame may take, in milliseconds: a whole frame for pictures, the extraction for loops.
    pub max_ms: Option<f64>,
    /// How long the calibration may take.
    pub seconds: f64,
}

impl Request {
    /// The goal with its own limit of the error, none of the time, and [`SECONDS`].
    ///
    /// # Panics
    /// Never: a test looks up the limit of every goal.
    pub fn new(goal: Goal) -> Self {
        Self::limited(goal, goal.default_limit()).expect("every goal has its own metric")
    }

    /// The same with another limit of the error.
    ///
    /// # Errors
    /// [`LimitFault::Metric`].
    pub fn limited(goal: Goal, limit: ErrorLimit) -> Result<Self, LimitFault> {
        let metric = limit.place(goal)?;
        Ok(Self { goal, limit, metric, max_ms: None, seconds: SECONDS })
    }

    /// The error that is limited.
    pub fn error(&self) -> ErrorMetric {
        self.goal.metrics()[self.metric]
    }
}

/// Measures as far as the notebook lacks it, and recommends. `candidates` are those of the meter, each with a page in the notebook.
///
/// # Errors
/// [`CompareError`]: nothing can be measured, or the work was cancelled.
pub fn recommend<M: Meter>(
    measurer: &mut Measurer<'_, M>,
    request: &Request,
    candidates: &[Candidate],
) -> Result<Recommendation, CompareError> {
    measurer.ask(request);
    // Where the truth alone takes all of the time, the race finds none left and says so.
    measurer.set_up(request.seconds)?;
    let changed: Vec<bool> = candidates.iter().map(|candidate| candidate.changed.is_some()).collect();
    let standings = race::race(measurer, request, &changed)?;
    let choice = choice::choose(measurer, request, &standings)?;
    Ok(Recommendation::new(measurer, request, candidates, &standings, &choice))
}
