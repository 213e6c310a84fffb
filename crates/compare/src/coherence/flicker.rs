//! Flicker: lines that appear and are gone again at once though the truth stays, and lines that are gone and appear again.

use super::drawn::State;
use super::metrics::{Observation, Sequence};

/// In how many frames at most a line is drawn, or bare, for it to flicker.
pub const LONGEST_FRAMES: usize = 3;

/// Shares from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flicker {
    /// Share of the drawn length.
    pub flashes: f64,
    /// Share of the true length.
    pub dropouts: f64,
}

/// Measures it along the true line: a place is followed to the frames before and after while its true line stays.
///
/// - A drawn place *flashes* if it is bare in a frame before and in a frame after, and at most [`LONGEST_FRAMES`] frames lie
///   between the two.
/// - A bare place *drops out* if it is drawn in a frame before and in a frame after, and as few frames lie between.
///
/// The first and the last frame count for neither, having no frame before or after. O(places).
pub fn flicker(
    sequence: &Sequence,
    observations: &[Vec<Observation>],
    is_counted: impl Fn(usize, usize) -> bool,
) -> Flicker {
    let (mut drawn, mut flashes, mut whole, mut dropouts) = (0.0, 0.0, 0.0, 0.0);
    let last = sequence.frames.len().saturating_sub(1);
    for frame in 1..last {
        for (at, place) in sequence.frames[frame].places.iter().enumerate() {
            if !is_counted(frame, at) {
                continue;
            }
            whole += place.length;
            let state = observations[frame][at].state;
            let is_short = |ending: State| is_short(sequence, observations, frame, at, ending);
            match state {
                State::Drawn => {
                    drawn += place.length;
                    flashes += if is_short(State::Bare) { place.length } else { 0.0 };
                }
                State::Bare => dropouts += if is_short(State::Drawn) { place.length } else { 0.0 },
                State::Doubtful => {}
            }
        }
    }
    let share = |part: f64, whole: f64| if whole > 0.0 { part / whole } else { 0.0 };
    Flicker { flashes: share(flashes, drawn), dropouts: share(dropouts, whole) }
}

/// Whether a place is in the state `ending` both before and after, with at most [`LONGEST_FRAMES`] frames between.
fn is_short(sequence: &Sequence, observations: &[Vec<Observation>], frame: usize, at: usize, ending: State) -> bool {
    // How many frames further the ending is, if it is near enough to count.
    let distance = |is_forward: bool| {
        let mut here = (frame, at);
        for steps in 1..=LONGEST_FRAMES {
            let (frame, at) = here;
            let link = if is_forward {
                sequence.links.get(frame).and_then(|links| links.forward[at])
            } else {
                frame.checked_sub(1).and_then(|before| sequence.links[before].backward[at])
            };
            here = (if is_forward { frame + 1 } else { frame.wrapping_sub(1) }, link? as usize);
            if observations[here.0][here.1].state == ending {
                return Some(steps);
            }
        }
        None
    };
    let [before, after] = [false, true].map(distance);
    before.zip(after).is_some_and(|(before, after)| before + after - 1 <= LONGEST_FRAMES)
}

#[cfg(test)]
mod tests {
    use super::super::sample_sequence::{SampleSequence, dropping, exact, flashing, never_drawn};

    #[test]
    fn exact_lines_neither_flash_nor_drop_out() {
        for height in [512, 1024] {
            let metrics = SampleSequence::blob(height).measure(exact);
            assert!(metrics.flicker < 1e-12 && metrics.dropouts < 1e-12, "{metrics:?}");
        }
    }

    /// The controls: in every frame other loops are left out at random; and loops are drawn in one frame of six.
    #[test]
    fn loops_dropped_at_random_drop_out_and_loops_drawn_now_and_then_flash() {
        let [small, large] = [512, 1024].map(|height| SampleSequence::blob(height).measure(dropping));
        assert!(small.dropouts > 0.02 && (small.dropouts / large.dropouts - 1.0).abs() < 0.1, "{small:?} {large:?}");
        let [small, large] = [512, 1024].map(|height| SampleSequence::blob(height).measure(flashing));
        assert!(small.flicker > 0.2 && (small.flicker / large.flicker - 1.0).abs() < 0.1, "{small:?} {large:?}");
    }

    #[test]
    fn what_is_never_drawn_does_not_flicker() {
        let metrics = SampleSequence::blob(512).measure(never_drawn);
        assert!(metrics.flicker < 1e-12 && metrics.dropouts < 1e-12, "{metrics:?}");
    }
}
