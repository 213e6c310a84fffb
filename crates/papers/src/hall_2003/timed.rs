//! Frame times: variants fly the path in turn, so that a change of the machine's speed affects all alike.

use super::circles::Frame;
use super::variants::Flier;
use silhouette_core::{Cancelled, Progress};
use std::hint::black_box;
use std::time::Instant;

/// How often each variant flies the path.
pub const ROUNDS: u32 = 5;

/// Least microseconds of each measured frame, for each flier, which first returns to the state that it kept.
///
/// # Errors
/// [`Cancelled`].
pub fn time_frames(
    fliers: &mut [Flier],
    frames: &[Frame],
    progress: &dyn Progress,
) -> Result<Vec<Vec<f64>>, Cancelled> {
    let measured = frames.iter().filter(|frame| frame.is_measured).count();
    let mut least_us = vec![vec![f64::INFINITY; measured]; fliers.len()];
    for _ in 0..ROUNDS {
        for (flier, least_us) in fliers.iter_mut().zip(&mut least_us) {
            progress.check()?;
            flier.restore();
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
