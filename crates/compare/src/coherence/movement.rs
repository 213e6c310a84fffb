//! Movement that the truth does not have: how much the distance between drawn and true line changes from frame to frame.

use super::metrics::{Observation, Sequence};

/// Movement up to this counts as none, in reference pixels: a third of a pixel of a picture of 512. The raster of such a picture
/// moves 99 % of a line by 0.3 to 0.5 with four samples per pixel, that of a picture of 1024 by 0.2 to 0.4.
pub const GRAIN: f64 = 0.6;

/// How many places in a row must move for their least movement to count as that of a stretch: about 20 reference pixels.
const STRETCH_PLACES: usize = 10;

/// Movement in reference pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Movement {
    /// What 99 % of the line, by length and over all frames, moves at most.
    pub p99: f64,
    /// The most that a stretch of about 20 reference pixels moves, every place of it.
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
    let mut max = 0.0_f64;
    for (frame, links) in sequence.links.iter().enumerate() {
        let places = &sequence.frames[frame].places;
        let distance = |at: usize| {
            let next = links.forward[at]? as usize;
            let is_clear = places[at].is_clear && sequence.frames[frame + 1].places[next].is_clear;
            if !is_clear || !is_counted(frame, at) || !is_counted(frame + 1, next) {
                return None;
            }
            let distance = (observations[frame + 1][next].offset? - observations[frame][at].offset?).abs();
            Some(if distance > GRAIN { distance } else { 0.0 })
        };
        let distances: Vec<Option<f64>> = (0..places.len()).map(distance).collect();
        let measured = distances.iter().zip(places);
        moved.extend(measured.filter_map(|(distance, place)| Some(((*distance)?, place.length))));
        for (stretch, on) in distances.windows(STRETCH_PLACES).zip(places.windows(STRETCH_PLACES)) {
            let least = stretch.iter().copied().try_fold(f64::INFINITY, |least, distance| Some(least.min(distance?)));
            if let Some(least) = least.filter(|_| on[0].line == on[STRETCH_PLACES - 1].line) {
                max = max.max(least);
            }
        }
    }
    Movement { p99: percentile(&mut moved), max }
}

/// What 99 % of the length moves at most.
fn percentile(moved: &mut [(f64, f64)]) -> f64 {
    moved.sort_unstable_by(|one, other| one.0.total_cmp(&other.0));
    let whole: f64 = moved.iter().map(|(_, length)| length).sum();
    let mut reached = 0.0;
    let found = moved.iter().find(|(_, length)| {
        reached += length;
        reached >= 0.99 * whole
    });
    found.map_or(0.0, |(distance, _)| *distance)
}

#[cfg(test)]
mod tests {
    use super::super::sample_sequence::{SampleSequence, exact, jittering, jumping, lagging, swimming};

    /// The control of the largest movement: a part of the picture, in one frame of twelve.
    #[test]
    fn a_jump_of_a_short_stretch_is_the_largest_movement_alone() {
        let jumps = [512, 1024].map(|height| SampleSequence::blob(height).measure(jumping));
        for metrics in jumps {
            assert!(metrics.movement_p99_rpx < 1e-9, "{metrics:?}");
            assert!((3.0..5.0).contains(&metrics.movement_max_rpx), "{metrics:?}");
        }
        assert!((jumps[0].movement_max_rpx / jumps[1].movement_max_rpx - 1.0).abs() < 0.1, "{jumps:?}");
    }

    #[test]
    fn lines_that_are_exact_do_not_move() {
        for height in [512, 1024] {
            let metrics = SampleSequence::blob(height).measure(exact);
            assert!(metrics.movement_p99_rpx < 1e-9 && metrics.movement_max_rpx < 1.0, "{height}: {metrics:?}");
        }
    }

    /// The control: every other frame is drawn a pixel of a 512 px high picture to the right.
    #[test]
    fn jittering_by_a_pixel_is_movement_by_that_pixel_at_any_size() {
        let measured = [512, 1024].map(|height| SampleSequence::blob(height).measure(jittering));
        let [small, large] = measured.map(|metrics| metrics.movement_p99_rpx);
        let pixel = 1000.0 / 512.0;
        let max = measured.map(|metrics| metrics.movement_max_rpx);
        assert!((max[0] / max[1] - 1.0).abs() < 0.1 && max[0] > 0.9 * pixel, "{max:?}");
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
