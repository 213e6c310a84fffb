//! What a frame takes in time.
//!
//! One thread. Each variant flies the whole path before the next one does, so that caches hold what they would in an
//! application, and all do so several times in turn, so that a change of the machine's speed meets all alike. A frame's
//! time is its least over these rounds; the median over frames is what is told.

use super::circles::Frame;
use super::variants::Flier;
use silhouette_core::{Cancelled, Progress};
use silhouette_tracking::Tracker;
use std::hint::black_box;
use std::time::Instant;

/// How often each variant flies the path.
pub const ROUNDS: u32 = 5;

/// Least microseconds of each measured frame, for each flier, which first returns to its state.
///
/// # Errors
/// [`Cancelled`].
pub fn time_frames(
    fliers: &mut [Flier],
    states: &[Option<Box<Tracker>>],
    frames: &[Frame],
    progress: &dyn Progress,
) -> Result<Vec<Vec<f64>>, Cancelled> {
    let measured = frames.iter().filter(|frame| frame.is_measured).count();
    let mut least_us = vec![vec![f64::INFINITY; measured]; fliers.len()];
    for _ in 0..ROUNDS {
        for ((flier, state), least_us) in fliers.iter_mut().zip(states).zip(&mut least_us) {
            progress.check()?;
            flier.restore(state);
            let mut least_us = least_us.iter_mut();
            for frame in frames {
                let start = Instant::now();
                flier.frame(black_box(&frame.view));
                let us = start.elapsed().as_secs_f64() * 1e6;
                if let Some(least) = frame.is_measured.then(|| least_us.next()).flatten() {
                    *least = least.min(us);
                }
            }
            progress.advance(1);
        }
    }
    Ok(least_us)
}
