//! How often a drawn line is interrupted.

use super::ink::Ink;
use crate::truth::samples::{Run, TrueLines};

/// A place of a true line is bare where no ink lies within this distance: as much as rasterisation can move a line.
const BARE_PX: f64 = 1.0;

/// Shorter bare runs are not seen as gaps.
const SHORTEST_GAP_PX: f64 = 1.0;

/// Gaps per 1000 px of true line: bare runs along a true line that are longer than 1 px. 0 where there is no true line;
/// fewer than 1000. A line that is missing as a whole is one gap, so read this beside the missed share.
pub fn gaps_per_1000_px(ink: &Ink, truth: &TrueLines) -> f64 {
    let length: f64 = truth.samples.iter().map(|sample| sample.length_px).sum();
    let gaps: usize = truth.runs.iter().map(|run| gaps_in_run(ink, truth, run)).sum();
    if length > 0.0 { gaps as f64 * 1000.0 / length } else { 0.0 }
}

fn gaps_in_run(ink: &Ink, truth: &TrueLines, run: &Run) -> usize {
    let samples = &truth.samples[run.samples.clone()];
    let bare: Vec<bool> = samples.iter().map(|sample| !ink.has_ink_within(sample.pixel, BARE_PX)).collect();
    // A closed line is read from its first covered place, so that no gap is cut in two by the start.
    let start = if run.closed { bare.iter().position(|bare| !bare).unwrap_or(0) } else { 0 };
    let (mut gaps, mut length) = (0, 0.0);
    for at in (start..samples.len()).chain(0..start) {
        if bare[at] {
            length += samples[at].length_px;
        } else {
            gaps += usize::from(length > SHORTEST_GAP_PX);
            length = 0.0;
        }
    }
    gaps + usize::from(length > SHORTEST_GAP_PX)
}

#[cfg(test)]
mod tests {
    use super::super::sample_lines;
    use super::*;

    #[test]
    fn punching_holes_raises_the_gap_count() {
        let sample = sample_lines::crossing_lines();
        let whole = gaps_per_1000_px(&sample.pen, &sample.lines);
        let holed = gaps_per_1000_px(&sample_lines::punch_holes(&sample.pen), &sample.lines);
        assert!(whole.abs() < 1e-12 && holed > 5.0, "{whole} {holed}");
    }

    #[test]
    fn a_gap_over_the_start_of_a_closed_line_is_one_gap() {
        let mut sample = sample_lines::square();
        assert!(sample.lines.runs[0].closed);
        let holed = sample_lines::erase_around(&sample.pen, sample.lines.samples[0].pixel, 6.0);
        let length: f64 = sample.lines.samples.iter().map(|sample| sample.length_px).sum();
        assert!((gaps_per_1000_px(&holed, &sample.lines) * length / 1000.0 - 1.0).abs() < 1e-9);
        sample.lines.runs[0].closed = false;
        assert!((gaps_per_1000_px(&holed, &sample.lines) * length / 1000.0 - 2.0).abs() < 1e-9);
    }

    #[test]
    fn without_ink_every_line_is_one_gap() {
        let sample = sample_lines::crossing_lines();
        let blank = Ink::blank(sample.pen.width(), sample.pen.height());
        let length: f64 = sample.lines.samples.iter().map(|sample| sample.length_px).sum();
        let gaps = gaps_per_1000_px(&blank, &sample.lines) * length / 1000.0;
        assert!((gaps - sample.lines.runs.len() as f64).abs() < 1e-9, "{gaps}");
        assert!(gaps_per_1000_px(&blank, &TrueLines::default()).abs() < 1e-12);
    }
}
