//! How wide the lines were drawn, and how evenly.

use super::ink::Ink;
use crate::truth::samples::{TrueLines, TrueSample};
use glam::DVec2;
use std::collections::HashMap;

/// A profile reaches this far beyond the pen's width on both sides: room for a line that is drawn too wide or beside
/// the truth, little room for a neighbour.
pub const WINDOW_MARGIN_PX: f64 = 1.0;

/// Distance between the points of a profile.
const STEP_PX: f64 = 0.125;

/// A neighbour that leaves the sample's own straight continuation by more than this is another line, or a bend that a
/// straight profile does not measure. Half a pixel more than what rasterisation moves a line by.
const STRAIGHT_PX: f64 = 1.0;

/// One profile per this many samples, which are a quarter of a pixel apart: closer profiles see the same pixels again.
const STRIDE: usize = 4;

/// Width of the drawn lines.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct DrawnWidth {
    /// Mean width in pixels; 0 where nothing could be measured.
    pub mean_px: f64,
    /// Standard deviation of the width in pixels; 0 where nothing could be measured.
    pub deviation_px: f64,
    /// Number of profiles measured.
    pub profiles: usize,
}

/// Measures the drawn width in profiles across the true lines: the integral of coverage along the normal, as far as
/// `pen_width_px` + [`WINDOW_MARGIN_PX`] to both sides.
///
/// Left out: places without ink within 1 px (they are missed, not thin), and places where another line, or a bend of
/// the same one, comes within the window.
pub fn drawn_width(ink: &Ink, truth: &TrueLines, pen_width_px: f64) -> DrawnWidth {
    let reach = pen_width_px + WINDOW_MARGIN_PX;
    let grid = SampleGrid::new(&truth.samples, reach + pen_width_px);
    let measurable = |sample: &&TrueSample| ink.has_ink_within(sample.pixel, 1.0) && grid.is_alone(sample);
    let measured = truth.samples.iter().step_by(STRIDE).filter(measurable);
    let widths: Vec<f64> = measured.map(|sample| profile_width(ink, sample, reach)).collect();
    if widths.is_empty() {
        return DrawnWidth::default();
    }
    let count = widths.len() as f64;
    let mean = widths.iter().sum::<f64>() / count;
    let variance = widths.iter().map(|width| (width - mean).powi(2)).sum::<f64>() / count;
    DrawnWidth { mean_px: mean, deviation_px: variance.sqrt(), profiles: widths.len() }
}

fn profile_width(ink: &Ink, sample: &TrueSample, reach: f64) -> f64 {
    let normal = sample.tangent.perp();
    let steps = (2.0 * reach / STEP_PX).ceil();
    let spacing = 2.0 * reach / steps;
    let points = (0..steps as u32).map(|step| (f64::from(step) + 0.5) * spacing - reach);
    points.map(|offset| ink.sample(sample.pixel + normal * offset) * spacing).sum()
}

/// Samples in square cells as large as the radius that is asked for.
struct SampleGrid<'a> {
    samples: &'a [TrueSample],
    cells: HashMap<(i64, i64), Vec<usize>>,
    radius: f64,
}

impl<'a> SampleGrid<'a> {
    fn new(samples: &'a [TrueSample], radius: f64) -> Self {
        let mut cells: HashMap<_, Vec<_>> = HashMap::new();
        for (index, sample) in samples.iter().enumerate() {
            cells.entry(Self::cell(sample.pixel, radius)).or_default().push(index);
        }
        Self { samples, cells, radius }
    }

    fn cell(pixel: DVec2, radius: f64) -> (i64, i64) {
        let cell = (pixel / radius).floor();
        (cell.x as i64, cell.y as i64)
    }

    /// Whether all samples within the radius lie on the straight continuation of `sample`.
    fn is_alone(&self, sample: &TrueSample) -> bool {
        let (cx, cy) = Self::cell(sample.pixel, self.radius);
        let around = (cx - 1..=cx + 1).flat_map(|x| (cy - 1..=cy + 1).map(move |y| (x, y)));
        around.filter_map(|cell| self.cells.get(&cell)).flatten().all(|&other| {
            let offset = self.samples[other].pixel - sample.pixel;
            offset.length() > self.radius || offset.perp_dot(sample.tangent).abs() <= STRAIGHT_PX
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample_lines;
    use super::*;

    #[test]
    fn the_true_pen_has_its_own_width() {
        let sample = sample_lines::crossing_lines();
        let width = drawn_width(&sample.pen, &sample.lines, sample_lines::PEN_PX);
        assert!((width.mean_px - sample_lines::PEN_PX).abs() < 0.05, "{width:?}");
        assert!(width.deviation_px < 0.15 && width.profiles > 50, "{width:?}");
    }

    #[test]
    fn thickening_raises_the_mean_width() {
        let sample = sample_lines::crossing_lines();
        let thick = drawn_width(&sample_lines::thicken(&sample.pen), &sample.lines, sample_lines::PEN_PX);
        assert!(thick.mean_px > sample_lines::PEN_PX + 1.0, "{thick:?}");
    }

    #[test]
    fn an_uneven_pen_raises_the_deviation() {
        let sample = sample_lines::crossing_lines();
        let even = drawn_width(&sample.pen, &sample.lines, sample_lines::PEN_PX).deviation_px;
        let uneven = drawn_width(&sample_lines::thicken_left_half(&sample.pen), &sample.lines, sample_lines::PEN_PX)
            .deviation_px;
        assert!(uneven > even + 0.5, "{even} {uneven}");
    }

    #[test]
    fn places_near_another_line_are_left_out() {
        let sample = sample_lines::crossing_lines();
        let grid = SampleGrid::new(&sample.lines.samples, 8.0);
        let alone = sample.lines.samples.iter().filter(|sample| grid.is_alone(sample)).count();
        assert!(alone > 0 && alone < sample.lines.samples.len());
    }

    #[test]
    fn nothing_to_measure_is_zero() {
        let sample = sample_lines::crossing_lines();
        let blank = Ink::blank(sample.pen.width(), sample.pen.height());
        assert_eq!(drawn_width(&blank, &sample.lines, sample_lines::PEN_PX), DrawnWidth::default());
        assert_eq!(drawn_width(&sample.pen, &TrueLines::default(), sample_lines::PEN_PX), DrawnWidth::default());
    }
}
