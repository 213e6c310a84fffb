//! Movement that the truth does not have: how much the distance between drawn and true line changes from frame to frame.

use super::metrics::{Observation, Sequence};

/// Movement up to this counts as none, in reference pixels: a third of a pixel of a picture of 512. The raster of such a picture
/// moves 99 % of a line by 0.3 to 0.5 with four samples per pixel, that of a picture of 1024 by 0.2 to 0.4.
pub const GRAIN: f64 = 0.6;

/// Movement in reference pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Movement {
    /// What 99 % of the line, by length and over all frames, moves at most.
    pub p99: f64,
    /// The most that any place moves.
    pub max: f64,
}

/// Measures it at every place that is drawn in two consecutive frames, clear of other lines in both, and whose true line has
/// stayed. A line that keeps its distance from the true one does not move, however far off it is. 0 where there is no such place.
/// O(places).
pub fn movement(
    sequence: &Sequence,
    observations: &[Vec<Observation>],
    is_counted: impl Fn(usize, usize) -> bool,
) -> Movement {
    let mut moved: Vec<(f64, f64)> = Vec::new();
    for (frame, links) in sequence.links.iter().enumerate() {
        for (at, next) in links.forward.iter().enumerate() {
            let Some(next) = next.map(|next| next as usize) else { continue };
            let ends = [(frame, at), (frame + 1, next)];
            let places = ends.map(|(frame, at)| &sequence.frames[frame].places[at]);
            let is_clear = places.iter().all(|place| place.is_clear);
            if !is_clear || !ends.iter().all(|&(frame, at)| is_counted(frame, at)) {
                continue;
            }
            if let [Some(before), Some(after)] = ends.map(|(frame, at)| observations[frame][at].offset) {
                let distance = (after - before).abs();
                moved.push((if distance > GRAIN { distance } else { 0.0 }, places[0].length));
            }
        }
    }
    moved.sort_unstable_by(|one, other| one.0.total_cmp(&other.0));
    let whole: f64 = moved.iter().map(|(_, length)| length).sum();
    let mut reached = 0.0;
    let p99 = moved.iter().find(|(_, length)| {
        reached += length;
        reached >= 0.99 * whole
    });
    Movement {
        p99: p99.map_or(0.0, |(distance, _)| *distance),
        max: moved.last().map_or(0.0, |(distance, _)| *distance),
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample_sequence::{SampleSequence, exact, jittering, lagging, swimming};

    #[test]
    fn lines_that_are_exact_do_not_move() {
        for height in [512, 1024] {
            let metrics = SampleSequence::blob(height).measure(exact);
            assert!(metrics.movement_p99_rpx < 1e-9, "{height}: {metrics:?}");
        }
    }

    /// The control: every other frame is drawn a pixel of a 512 px high picture to the right.
    #[test]
    fn jittering_by_a_pixel_is_movement_by_that_pixel_at_any_size() {
        let [small, large] = [512, 1024].map(|height| SampleSequence::blob(height).measure(jittering).movement_p99_rpx);
        let pixel = 1000.0 / 512.0;
        assert!((small / pixel - 1.0).abs() < 0.2, "{small} of {pixel}");
        assert!((small / large - 1.0).abs() < 0.1, "{small} {large}");
    }

    /// A line that is wrong by a constant does not move; one that swims does.
    #[test]
    fn a_constant_error_is_no_movement_and_swimming_is() {
        let sequence = SampleSequence::blob(512);
        let lagging = sequence.measure(lagging);
        assert!(lagging.movement_p99_rpx < 1e-9, "{lagging:?}");
        let [small, large] = [512, 1024].map(|height| SampleSequence::blob(height).measure(swimming).movement_p99_rpx);
        assert!(small > 1.5 && (small / large - 1.0).abs() < 0.1, "{small} {large}");
    }
}
