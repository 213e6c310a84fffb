//! Loops lost: how many of the silhouette's loops are not drawn.

use super::drawn::State;
use super::metrics::{Observation, Sequence};

/// Loops of which less is seen, in reference pixels, do not count.
pub const SHORTEST_SEEN: f64 = 10.0;

/// Share of the loops, 0 to 1, over all frames, of whose visible length less than half is drawn. A loop is a connected set of
/// silhouette edges of the frame; it counts if [`SHORTEST_SEEN`] of it is visible. 0 where there is none. O(places).
///
/// Loops count the same whatever their length: read this beside the missed share.
pub fn loops_lost(sequence: &Sequence, observations: &[Vec<Observation>]) -> f64 {
    let (mut loops, mut lost) = (0_u64, 0_u64);
    for (frame, observed) in sequence.frames.iter().zip(observations) {
        let mut lengths = vec![[0.0, 0.0]; frame.loops as usize];
        for (place, observation) in frame.places.iter().zip(observed) {
            let [seen, drawn] = &mut lengths[place.loop_id as usize];
            *seen += place.length;
            *drawn += if observation.state == State::Drawn { place.length } else { 0.0 };
        }
        for [seen, drawn] in lengths {
            if seen >= SHORTEST_SEEN {
                loops += 1;
                lost += u64::from(drawn < 0.5 * seen);
            }
        }
    }
    if loops > 0 { lost as f64 / loops as f64 } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::super::sample_sequence::{SampleSequence, dropping, exact, never_drawn};

    #[test]
    fn a_quarter_of_the_loops_left_out_is_lost_at_any_size() {
        let [small, large] = [512, 1024].map(SampleSequence::blob);
        let lost = [&small, &large].map(|sequence| sequence.measure(dropping).loops_lost.unwrap());
        assert!((0.1..0.3).contains(&lost[0]) && (lost[0] / lost[1] - 1.0).abs() < 0.1, "{lost:?}");
        assert!(small.measure(exact).loops_lost.unwrap() < 1e-12);
        assert!(small.measure(never_drawn).loops_lost.unwrap() > 0.9);
    }
}
