//! Progress that cancels, and records what was reported.

use silhouette_core::Progress;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

/// Cancels from a given poll or step on.
#[derive(Debug)]
pub struct Cancelling {
    polls_left_alone: u64,
    steps_left_alone: u64,
    polls: AtomicU64,
    steps: AtomicU64,
    stages: Mutex<Vec<(String, u64)>>,
}

impl Cancelling {
    /// Cancels as soon as it is asked.
    pub fn at_once() -> Self {
        Self::at_poll(0)
    }

    /// Answers the first `polls` polls with "go on", and all later ones with "stop".
    pub fn at_poll(polls: u64) -> Self {
        Self::new(polls, u64::MAX)
    }

    /// Cancels once `steps` steps are reported; `u64::MAX` never cancels.
    pub fn at_step(steps: u64) -> Self {
        Self::new(u64::MAX, steps)
    }

    fn new(polls_left_alone: u64, steps_left_alone: u64) -> Self {
        Self {
            polls_left_alone,
            steps_left_alone,
            polls: AtomicU64::new(0),
            steps: AtomicU64::new(0),
            stages: Mutex::new(Vec::new()),
        }
    }

    /// Steps reported, over all stages.
    pub fn steps(&self) -> u64 {
        self.steps.load(Ordering::Relaxed)
    }

    /// Stages reported, each with its number of steps.
    pub fn stages(&self) -> Vec<(String, u64)> {
        self.stages.lock().unwrap().clone()
    }
}

impl Progress for Cancelling {
    fn stage(&self, name: &str, total: u64) {
        self.stages.lock().unwrap().push((name.to_owned(), total));
    }

    fn advance(&self, steps: u64) {
        self.steps.fetch_add(steps, Ordering::Relaxed);
    }

    fn is_cancelled(&self) -> bool {
        self.polls.fetch_add(1, Ordering::Relaxed) >= self.polls_left_alone || self.steps() >= self.steps_left_alone
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polls_and_steps_cancel_when_they_should() {
        let polled = Cancelling::at_poll(2);
        assert_eq!([0; 4].map(|_| polled.is_cancelled()), [false, false, true, true]);
        assert!(Cancelling::at_once().check().is_err());
        let stepped = Cancelling::at_step(10);
        stepped.stage("first", 12);
        stepped.advance(9);
        assert!(!stepped.is_cancelled());
        stepped.advance(3);
        assert!(stepped.is_cancelled());
        assert_eq!((stepped.steps(), stepped.stages()), (12, vec![("first".to_owned(), 12)]));
    }
}
