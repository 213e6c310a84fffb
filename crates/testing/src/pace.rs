//! [`Pace`]: how long work goes on without checking for cancellation.

use silhouette_core::Progress;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Never cancels; records the longest time between two checks, and in which stage it began.
#[derive(Debug)]
pub struct Pace(Mutex<State>);

#[derive(Debug)]
struct State {
    last: Instant,
    stage: String,
    longest: Duration,
    longest_in: String,
    checks: u64,
}

impl Pace {
    /// Begins now.
    pub fn begin() -> Self {
        let (last, longest) = (Instant::now(), Duration::ZERO);
        Self(Mutex::new(State { last, stage: "start".to_owned(), longest, longest_in: String::new(), checks: 0 }))
    }

    /// Ends now: the longest time, the stage in which it began, and the number of checks.
    pub fn end(self) -> (Duration, String, u64) {
        self.check_now();
        let State { longest, longest_in, checks, .. } = self.0.into_inner().unwrap();
        (longest, longest_in, checks - 1)
    }

    fn check_now(&self) {
        let mut state = self.0.lock().unwrap();
        let gap = state.last.elapsed();
        if gap > state.longest {
            (state.longest, state.longest_in) = (gap, state.stage.clone());
        }
        state.checks += 1;
        state.last = Instant::now();
    }
}

impl Progress for Pace {
    fn stage(&self, name: &str, _total: u64) {
        name.clone_into(&mut self.0.lock().unwrap().stage);
    }

    fn advance(&self, _steps: u64) {}

    fn is_cancelled(&self) -> bool {
        self.check_now();
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_gap_is_found_with_its_stage() {
        let pace = Pace::begin();
        pace.is_cancelled();
        pace.stage("slow", 1);
        std::thread::sleep(Duration::from_millis(30));
        pace.is_cancelled();
        pace.stage("quick", 1);
        let (longest, stage, checks) = pace.end();
        assert!(longest >= Duration::from_millis(30) && stage == "slow" && checks == 2, "{longest:?} {stage} {checks}");
    }
}
