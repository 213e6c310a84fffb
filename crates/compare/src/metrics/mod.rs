//! How good a drawn picture is: one small function a metric, each with a unit, a range and a test that makes a picture
//! worse and watches the number move.
//!
//! 1. [`ink`]: a picture becomes coverage a pixel.
//! 2. [`share`]: how much of the truth is missed, how much ink is spurious.
//! 3. [`separation`]: Chamfer and Hausdorff distance, over [`distance_transform`].
//! 4. [`width`]: how wide lines are drawn, and how evenly.
//! 5. [`gaps`]: how often a line is interrupted.
//!
//! [`METRICS`] is the one table of them: results, report and documentation are written from it.

pub mod distance_transform;
pub mod gaps;
pub mod ink;
#[cfg(test)]
mod scene;
pub mod separation;
pub mod share;
pub mod width;

pub use ink::Ink;

use crate::truth::TrueLines;
use serde::{Deserialize, Serialize};

/// Tolerances, in pixels, at which missed and spurious shares are measured.
pub const TOLERANCES_PX: [f64; 3] = [0.5, 1.0, 2.0];

/// What a picture of lines scores in one view, or on the mean of several. Every value is finite.
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
}

/// Which way a metric is better.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Better {
    /// Lower values.
    Lower,
    /// Values near the width of the pen.
    NearPenWidth,
}

/// What a metric says of itself.
#[derive(Debug, Clone, Copy)]
pub struct MetricSpec {
    /// Name in results: a field of [`LineMetrics`].
    pub name: &'static str,
    /// Name in the report.
    pub title: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Best value.
    pub best: &'static str,
    /// Worst value.
    pub worst: &'static str,
    /// What it is, in one sentence.
    pub summary: &'static str,
    /// Which way it is better.
    pub better: Better,
    /// Reads it.
    pub value: fn(&LineMetrics) -> f64,
    /// Writes it.
    pub value_mut: fn(&mut LineMetrics) -> &mut f64,
}

/// Every metric, in the order of results and report.
pub const METRICS: [MetricSpec; 11] = [
    MetricSpec {
        name: "missed_0_5px",
        title: "missed at 0.5 px",
        unit: "share",
        best: "0",
        worst: "1",
        summary: "Share of the true lines' length without ink within 0.5 px.",
        better: Better::Lower,
        value: |metrics| metrics.missed_0_5px,
        value_mut: |metrics| &mut metrics.missed_0_5px,
    },
    MetricSpec {
        name: "missed_1px",
        title: "missed at 1 px",
        unit: "share",
        best: "0",
        worst: "1",
        summary: "Share of the true lines' length without ink within 1 px.",
        better: Better::Lower,
        value: |metrics| metrics.missed_1px,
        value_mut: |metrics| &mut metrics.missed_1px,
    },
    MetricSpec {
        name: "missed_2px",
        title: "missed at 2 px",
        unit: "share",
        best: "0",
        worst: "1",
        summary: "Share of the true lines' length without ink within 2 px.",
        better: Better::Lower,
        value: |metrics| metrics.missed_2px,
        value_mut: |metrics| &mut metrics.missed_2px,
    },
    MetricSpec {
        name: "spurious_0_5px",
        title: "spurious at 0.5 px",
        unit: "share",
        best: "0",
        worst: "1",
        summary: "Share of the ink pixels whose centre is farther than 0.5 px from the true pen.",
        better: Better::Lower,
        value: |metrics| metrics.spurious_0_5px,
        value_mut: |metrics| &mut metrics.spurious_0_5px,
    },
    MetricSpec {
        name: "spurious_1px",
        title: "spurious at 1 px",
        unit: "share",
        best: "0",
        worst: "1",
        summary: "Share of the ink pixels whose centre is farther than 1 px from the true pen.",
        better: Better::Lower,
        value: |metrics| metrics.spurious_1px,
        value_mut: |metrics| &mut metrics.spurious_1px,
    },
    MetricSpec {
        name: "spurious_2px",
        title: "spurious at 2 px",
        unit: "share",
        best: "0",
        worst: "1",
        summary: "Share of the ink pixels whose centre is farther than 2 px from the true pen.",
        better: Better::Lower,
        value: |metrics| metrics.spurious_2px,
        value_mut: |metrics| &mut metrics.spurious_2px,
    },
    MetricSpec {
        name: "chamfer_px",
        title: "Chamfer distance",
        unit: "px",
        best: "0",
        worst: "the picture's diagonal",
        summary: "Mean distance from ink to true pen and from true pen to ink, averaged over the two directions.",
        better: Better::Lower,
        value: |metrics| metrics.chamfer_px,
        value_mut: |metrics| &mut metrics.chamfer_px,
    },
    MetricSpec {
        name: "hausdorff_95_px",
        title: "Hausdorff distance (95 %)",
        unit: "px",
        best: "0",
        worst: "the picture's diagonal",
        summary: "Distance that 95 % of the ink keeps to the true pen, and 95 % of the true pen to the ink.",
        better: Better::Lower,
        value: |metrics| metrics.hausdorff_95_px,
        value_mut: |metrics| &mut metrics.hausdorff_95_px,
    },
    MetricSpec {
        name: "width_mean_px",
        title: "mean width",
        unit: "px",
        best: "the pen's width",
        worst: "0, or the window of the profile: twice the pen's width + 2",
        summary: "Mean width of the drawn lines, in profiles across true lines that have ink and no neighbour.",
        better: Better::NearPenWidth,
        value: |metrics| metrics.width_mean_px,
        value_mut: |metrics| &mut metrics.width_mean_px,
    },
    MetricSpec {
        name: "width_deviation_px",
        title: "deviation of width",
        unit: "px",
        best: "0",
        worst: "half the window of the profile: the pen's width + 1",
        summary: "Standard deviation of that width from place to place.",
        better: Better::Lower,
        value: |metrics| metrics.width_deviation_px,
        value_mut: |metrics| &mut metrics.width_deviation_px,
    },
    MetricSpec {
        name: "gaps_per_1000px",
        title: "gaps",
        unit: "per 1000 px",
        best: "0",
        worst: "below 1000",
        summary: "Stretches of true line longer than 1 px without ink within 1 px, per 1000 px of true line.",
        better: Better::Lower,
        value: |metrics| metrics.gaps_per_1000px,
        value_mut: |metrics| &mut metrics.gaps_per_1000px,
    },
];

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
    }
}

/// Finds a metric by its name in results.
pub fn find(name: &str) -> Option<&'static MetricSpec> {
    METRICS.iter().find(|metric| metric.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_names_the_fields_in_order() {
        let json = serde_json::to_value(LineMetrics::default()).unwrap();
        let mut fields: Vec<_> = json.as_object().unwrap().keys().map(String::as_str).collect();
        let mut named: Vec<_> = METRICS.iter().map(|metric| metric.name).collect();
        fields.sort_unstable();
        named.sort_unstable();
        assert_eq!(fields, named);
        // Each reader reads the field of its own name.
        for metric in &METRICS {
            let mut one = serde_json::to_value(LineMetrics::default()).unwrap();
            one[metric.name] = 7.0.into();
            let metrics: LineMetrics = serde_json::from_value(one).unwrap();
            assert!(((metric.value)(&metrics) - 7.0).abs() < 1e-12, "{}", metric.name);
            let mut written = LineMetrics::default();
            *(metric.value_mut)(&mut written) = 7.0;
            assert_eq!(written, metrics, "{}", metric.name);
        }
    }

    #[test]
    fn the_true_pen_scores_best() {
        let scene = scene::crossing_lines();
        let metrics = measure(&scene.pen, &scene.lines, TruePen { picture: &scene.pen, width_px: scene::PEN_PX });
        for metric in METRICS.iter().filter(|metric| metric.better == Better::Lower) {
            let limit = if metric.name == "width_deviation_px" { 0.15 } else { 1e-12 };
            assert!((metric.value)(&metrics) < limit, "{}: {metrics:?}", metric.name);
        }
    }

    #[test]
    fn every_metric_of_every_empty_combination_is_finite() {
        let scene = scene::crossing_lines();
        let blank = Ink::blank(scene.pen.width(), scene.pen.height());
        for ink in [&blank, &scene.pen] {
            for (lines, picture) in [(&scene.lines, &scene.pen), (&TrueLines::default(), &blank)] {
                let metrics = measure(ink, lines, TruePen { picture, width_px: scene::PEN_PX });
                for metric in &METRICS {
                    assert!((metric.value)(&metrics).is_finite(), "{}", metric.name);
                }
            }
        }
    }

    #[test]
    fn the_documentation_holds_the_table() {
        let text = include_str!("../../../../docs/METRICS.md");
        for MetricSpec { name, unit, best, worst, summary, .. } in &METRICS {
            let row = format!("| `{name}` | {unit} | {best} | {worst} | {summary} |");
            assert!(text.contains(&row), "docs/METRICS.md lacks this row:\n{row}");
        }
    }
}
