//! [`LineMetrics`]: what a picture of lines scores.

use super::ink::Ink;
use super::{corners, gaps, separation, share, width};
use crate::truth::samples::TrueLines;
use serde::{Deserialize, Serialize};

/// Tolerances, in pixels, at which missed and spurious shares are measured.
pub const TOLERANCES_PX: [f64; 3] = [0.5, 1.0, 2.0];

/// What a picture of lines scores in one view, or averaged over several. Every value is finite.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct LineMetrics {
    /// [`share::missed_share`] at 0.5 px.
    pub missed_0_5px: f64,
    /// [`share::missed_share`] at 1 px.
    pub missed_1px: f64,
    /// [`share::missed_share`] at 2 px.
    pub missed_2px: f64,
    /// [`share::spurious_share`] at 0.5 px.
    pub spurious_0_5px: f64,
    /// [`share::spurious_share`] at 1 px.
    pub spurious_1px: f64,
    /// [`share::spurious_share`] at 2 px.
    pub spurious_2px: f64,
    /// [`separation::Separation::chamfer_px`].
    pub chamfer_px: f64,
    /// [`separation::Separation::hausdorff_95_px`].
    pub hausdorff_95_px: f64,
    /// [`width::DrawnWidth::mean_px`].
    pub width_mean_px: f64,
    /// [`width::DrawnWidth::deviation_px`].
    pub width_deviation_px: f64,
    /// [`gaps::gaps_per_1000_px`].
    pub gaps_per_1000px: f64,
    /// [`corners::closed_corner_share`].
    pub closed_corners: f64,
}

/// A pen, as far as the metrics need it.
#[derive(Debug, Clone, Copy)]
pub struct TruePen<'a> {
    /// The true lines drawn with the pen.
    pub picture: &'a Ink,
    /// Its width in pixels.
    pub width_px: f64,
}

/// Scores a picture. O(pixels + samples).
///
/// # Panics
/// If picture and true pen differ in size.
pub fn measure(ink: &Ink, truth: &TrueLines, pen: TruePen<'_>) -> LineMetrics {
    let missed = TOLERANCES_PX.map(|tolerance| share::missed_share(ink, truth, tolerance));
    let spurious = TOLERANCES_PX.map(|tolerance| share::spurious_share(ink, pen.picture, tolerance));
    let separation = separation::separation(ink, pen.picture);
    let width = width::drawn_width(ink, truth, pen.width_px);
    LineMetrics {
        missed_0_5px: missed[0],
        missed_1px: missed[1],
        missed_2px: missed[2],
        spurious_0_5px: spurious[0],
        spurious_1px: spurious[1],
        spurious_2px: spurious[2],
        chamfer_px: separation.chamfer_px,
        hausdorff_95_px: separation.hausdorff_95_px,
        width_mean_px: width.mean_px,
        width_deviation_px: width.deviation_px,
        gaps_per_1000px: gaps::gaps_per_1000_px(ink, truth),
        closed_corners: corners::closed_corner_share(ink, truth, pen),
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample_lines;
    use super::*;

    #[test]
    fn every_metric_of_every_empty_combination_is_finite() {
        let sample = sample_lines::crossing_lines();
        let blank = Ink::blank(sample.pen.width(), sample.pen.height());
        for ink in [&blank, &sample.pen] {
            for (lines, picture) in [(&sample.lines, &sample.pen), (&TrueLines::default(), &blank)] {
                let metrics = measure(ink, lines, TruePen { picture, width_px: sample_lines::PEN_PX });
                let values = serde_json::to_value(metrics).unwrap();
                for (name, value) in values.as_object().unwrap() {
                    assert!(value.as_f64().is_some_and(f64::is_finite), "{name}: {value}");
                }
            }
        }
    }
}
