//! How much of the truth is missed, and how much ink is spurious.

use super::ink::Ink;
use crate::truth::samples::TrueLines;
use glam::DVec2;

/// Share of the true lines' length, 0 to 1, without ink within `tolerance_px`: distances run from the true line, not
/// from its pen, to the area of the nearest ink pixel. 0 where there is no true line, 1 where there is no ink.
pub fn missed_share(ink: &Ink, truth: &TrueLines, tolerance_px: f64) -> f64 {
    let missed = |pixel: DVec2| !ink.has_ink_within(pixel, tolerance_px);
    let length = truth.samples.iter().filter(|sample| missed(sample.pixel)).map(|sample| sample.length_px).sum();
    share_of(length, truth.samples.iter().map(|sample| sample.length_px).sum())
}

/// Share of the ink pixels, 0 to 1, whose centre lies farther than `tolerance_px` from the area of the true pen. 0 where
/// there is no ink, 1 where there is ink but no true line.
pub fn spurious_share(ink: &Ink, true_pen: &Ink, tolerance_px: f64) -> f64 {
    let (mut pixels, mut spurious) = (0_u64, 0_u64);
    for (x, y) in ink.ink_pixels() {
        pixels += 1;
        let center = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        spurious += u64::from(!true_pen.has_ink_within(center, tolerance_px));
    }
    share_of(spurious as f64, pixels as f64)
}

fn share_of(part: f64, whole: f64) -> f64 {
    // The sum of no values is -0, which would be written as such: adding 0 makes it 0.
    if whole > 0.0 { part / whole + 0.0 } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::super::sample_lines;
    use super::*;

    #[test]
    fn erasing_a_stretch_raises_the_missed_share() {
        let sample = sample_lines::crossing_lines();
        let whole = missed_share(&sample.pen, &sample.lines, 0.5);
        let erased = missed_share(&sample_lines::erase_stretch(&sample.pen), &sample.lines, 0.5);
        assert!(whole.abs() < 1e-12 && erased > 0.05, "{whole} {erased}");
    }

    #[test]
    fn specks_raise_the_spurious_share() {
        let sample = sample_lines::crossing_lines();
        let specked = sample_lines::add_specks(&sample.pen);
        for tolerance in [0.5, 1.0, 2.0] {
            let before = spurious_share(&sample.pen, &sample.pen, tolerance);
            let after = spurious_share(&specked, &sample.pen, tolerance);
            assert!(before.abs() < 1e-12 && after > 0.01, "at {tolerance}: {before} {after}");
        }
    }

    #[test]
    fn tolerances_forgive_a_shift_up_to_their_size() {
        let sample = sample_lines::crossing_lines();
        let shifted = sample_lines::shift_right(&sample.pen, 2);
        let spurious = [0.5, 1.0, 2.0].map(|tolerance| spurious_share(&shifted, &sample.pen, tolerance));
        assert!(spurious[0] > 0.05 && spurious[0] > spurious[1] && spurious[1] > spurious[2], "{spurious:?}");
        assert!(spurious[2].abs() < 1e-12, "{spurious:?}");
    }

    #[test]
    fn empty_pictures_have_shares_at_the_ends() {
        let sample = sample_lines::crossing_lines();
        let blank = Ink::blank(sample.pen.width(), sample.pen.height());
        assert!((missed_share(&blank, &sample.lines, 2.0) - 1.0).abs() < 1e-12);
        assert!(missed_share(&sample.pen, &TrueLines::default(), 0.5).abs() < 1e-12);
        assert!((spurious_share(&sample.pen, &blank, 2.0) - 1.0).abs() < 1e-12);
        assert!(spurious_share(&blank, &sample.pen, 0.5).abs() < 1e-12);
    }
}
