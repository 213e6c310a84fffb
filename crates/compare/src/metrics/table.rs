//! [`METRICS`]: what each metric is, in one table.

use super::fill::FillMetrics;
use super::lines::LineMetrics;
use serde::{Deserialize, Serialize};

/// What a picture shows, which decides what it is measured against and how.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PictureKind {
    /// The silhouette as lines of ink on paper.
    Lines,
    /// The mesh as a filled image on a transparent ground.
    Fill,
}

impl PictureKind {
    /// Every kind, in the order of results and report.
    pub const ALL: [Self; 2] = [Self::Lines, Self::Fill];

    /// Name in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Lines => "lines",
            Self::Fill => "fill",
        }
    }

    /// The metric by which pictures of this kind are compared where one number has to do: the worst view is the one in which
    /// it is largest, and the report shows it first.
    ///
    /// # Panics
    /// Never: a test finds both.
    pub fn leading_metric(self) -> &'static MetricSpec {
        let name = match self {
            Self::Lines => "chamfer_px",
            Self::Fill => "boundary_chamfer_px",
        };
        find(name).expect("names of METRICS")
    }

    /// Its metrics, in the order of results and report.
    pub fn metrics(self) -> impl Iterator<Item = &'static MetricSpec> {
        METRICS.iter().filter(move |metric| metric.kind == self)
    }
}

/// What a picture scores, by what it shows.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PictureMetrics {
    /// A picture of lines.
    Lines(LineMetrics),
    /// A filled picture.
    Fill(FillMetrics),
}

impl PictureMetrics {
    /// What the picture shows.
    pub fn kind(&self) -> PictureKind {
        match self {
            Self::Lines(_) => PictureKind::Lines,
            Self::Fill(_) => PictureKind::Fill,
        }
    }

    /// The average of several, each counting the same; `None` of none. A metric that any of them lacks is lacking.
    ///
    /// # Panics
    /// If they are of different kinds.
    pub fn mean(all: &[Self]) -> Option<Self> {
        let first = all.first()?;
        assert!(all.iter().all(|other| other.kind() == first.kind()), "one kind of picture per average");
        let mut mean = *first;
        for metric in first.kind().metrics() {
            let values: Option<Vec<f64>> = all.iter().map(|metrics| (metric.value)(metrics)).collect();
            if let (Some(values), Some(place)) = (values, (metric.value_mut)(&mut mean)) {
                *place = values.iter().sum::<f64>() / values.len() as f64;
            }
        }
        Some(mean)
    }
}

/// Which way a metric is better.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Better {
    /// Lower values.
    Lower,
    /// Higher values.
    Higher,
    /// Values near the width of the pen.
    NearPenWidth,
}

/// What a metric states about itself.
#[derive(Debug, Clone, Copy)]
pub struct MetricSpec {
    /// The kind of picture that it measures.
    pub kind: PictureKind,
    /// Name in results: a field of [`LineMetrics`] or [`FillMetrics`].
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
    /// Reads it; `None` for a picture of another kind, and where it was not measured.
    pub value: fn(&PictureMetrics) -> Option<f64>,
    /// Writes it, under the same condition.
    pub value_mut: fn(&mut PictureMetrics) -> Option<&mut f64>,
}

impl MetricSpec {
    /// The value so that lower is better; `None` where there is none.
    pub fn error(&self, metrics: &PictureMetrics) -> Option<f64> {
        let value = (self.value)(metrics)?;
        Some(if self.better == Better::Higher { -value } else { value })
    }
}

/// A row of [`METRICS`], with how its value is read and written.
macro_rules! row {
    ($kind:ident, $field:ident, $title:literal, $unit:literal, $best:literal, $worst:literal, $better:ident,
        $summary:literal, |$read:ident| $value:expr, |$write:ident| $value_mut:expr) => {
        MetricSpec {
            kind: PictureKind::$kind,
            name: stringify!($field),
            title: $title,
            unit: $unit,
            best: $best,
            worst: $worst,
            summary: $summary,
            better: Better::$better,
            value: |metrics| match metrics {
                PictureMetrics::$kind($read) => $value,
                _ => None,
            },
            value_mut: |metrics| match metrics {
                PictureMetrics::$kind($write) => $value_mut,
                _ => None,
            },
        }
    };
}

/// A row of [`METRICS`] for a field that is always measured.
macro_rules! metric {
    ($kind:ident, $field:ident, { title: $title:literal, unit: $unit:literal, best: $best:literal, worst: $worst:literal,
        better: $better:ident, summary: $summary:literal, }) => {
        row!(
            $kind,
            $field,
            $title,
            $unit,
            $best,
            $worst,
            $better,
            $summary,
            |metrics| Some(metrics.$field),
            |metrics| Some(&mut metrics.$field)
        )
    };
}

/// A row of [`METRICS`] for a field that is measured by some builds only.
macro_rules! optional {
    ($kind:ident, $field:ident, { title: $title:literal, unit: $unit:literal, best: $best:literal, worst: $worst:literal,
        better: $better:ident, summary: $summary:literal, }) => {
        row!($kind, $field, $title, $unit, $best, $worst, $better, $summary, |metrics| metrics.$field, |metrics| {
            metrics.$field.as_mut()
        })
    };
}

/// Every metric, in the order of results and report.
pub const METRICS: [MetricSpec; 18] = [
    metric!(Lines, missed_0_5px, {
        title: "missed at 0.5 px",
        unit: "share",
        best: "0",
        worst: "1",
        better: Lower,
        summary: "Share of the true lines' length without ink within 0.5 px.",
    }),
    metric!(Lines, missed_1px, {
        title: "missed at 1 px",
        unit: "share",
        best: "0",
        worst: "1",
        better: Lower,
        summary: "Share of the true lines' length without ink within 1 px.",
    }),
    metric!(Lines, missed_2px, {
        title: "missed at 2 px",
        unit: "share",
        best: "0",
        worst: "1",
        better: Lower,
        summary: "Share of the true lines' length without ink within 2 px.",
    }),
    metric!(Lines, spurious_0_5px, {
        title: "spurious at 0.5 px",
        unit: "share",
        best: "0",
        worst: "1",
        better: Lower,
        summary: "Share of the ink pixels whose centre is farther than 0.5 px from the true pen.",
    }),
    metric!(Lines, spurious_1px, {
        title: "spurious at 1 px",
        unit: "share",
        best: "0",
        worst: "1",
        better: Lower,
        summary: "Share of the ink pixels whose centre is farther than 1 px from the true pen.",
    }),
    metric!(Lines, spurious_2px, {
        title: "spurious at 2 px",
        unit: "share",
        best: "0",
        worst: "1",
        better: Lower,
        summary: "Share of the ink pixels whose centre is farther than 2 px from the true pen.",
    }),
    metric!(Lines, chamfer_px, {
        title: "Chamfer distance",
        unit: "px",
        best: "0",
        worst: "the picture's diagonal",
        better: Lower,
        summary: "Mean distance from ink to true pen and from true pen to ink, averaged over the two directions.",
    }),
    metric!(Lines, hausdorff_95_px, {
        title: "Hausdorff distance (95 %)",
        unit: "px",
        best: "0",
        worst: "the picture's diagonal",
        better: Lower,
        summary: "Distance that 95 % of the ink keeps to the true pen, and 95 % of the true pen to the ink.",
    }),
    metric!(Lines, width_mean_px, {
        title: "mean width",
        unit: "px",
        best: "the pen's width",
        worst: "0, or the window of the profile: twice the pen's width + 2",
        better: NearPenWidth,
        summary: "Mean width of the drawn lines, in profiles across true lines that have ink and no neighbour.",
    }),
    metric!(Lines, width_deviation_px, {
        title: "deviation of width",
        unit: "px",
        best: "0",
        worst: "half the window of the profile: the pen's width + 1",
        better: Lower,
        summary: "Standard deviation of that width from place to place.",
    }),
    metric!(Lines, gaps_per_1000px, {
        title: "gaps",
        unit: "per 1000 px",
        best: "0",
        worst: "below 1000",
        better: Lower,
        summary: "Stretches of true line longer than 1 px without ink within 1 px, per 1000 px of true line.",
    }),
    metric!(Lines, closed_corners, {
        title: "closed corners",
        unit: "share",
        best: "1",
        worst: "0",
        better: Higher,
        summary: "Share of the corners of the true lines at which the pen's join is inked altogether.",
    }),
    metric!(Fill, xor_share, {
        title: "XOR area",
        unit: "share",
        best: "0",
        worst: "the picture's area over the true area",
        better: Lower,
        summary: "Sum over all pixels of the difference between drawn and true coverage, over the true area.",
    }),
    metric!(Fill, boundary_chamfer_px, {
        title: "boundary Chamfer distance",
        unit: "px",
        best: "0",
        worst: "the picture's diagonal",
        better: Lower,
        summary: "Mean distance from drawn to true boundary and from true to drawn boundary, averaged over the two directions.",
    }),
    metric!(Fill, boundary_hausdorff_95_px, {
        title: "boundary Hausdorff distance (95 %)",
        unit: "px",
        best: "0",
        worst: "the picture's diagonal",
        better: Lower,
        summary: "Distance that 95 % of the drawn boundary keeps to the true one, and 95 % of the true one to the drawn.",
    }),
    metric!(Fill, hole_pixels, {
        title: "hole pixels",
        unit: "pixels",
        best: "0",
        worst: "the true area",
        better: Lower,
        summary: "Bare pixels in spots that drawn pixels enclose and that the truth covers altogether.",
    }),
    metric!(Fill, psnr_db, {
        title: "PSNR",
        unit: "dB",
        best: "that of one byte differing by one: 107 dB at 512 x 512 pixels",
        worst: "0",
        better: Higher,
        summary: "Peak signal-to-noise ratio of the colours over white paper, all pixels counted.",
    }),
    optional!(Fill, flip, {
        title: "FLIP",
        unit: "0 to 1",
        best: "0",
        worst: "1",
        better: Lower,
        summary: "Mean perceived difference of the colours over white paper, by NVIDIA's FLIP; with the feature flip only.",
    }),
];

/// Finds a metric by its name in results.
pub fn find(name: &str) -> Option<&'static MetricSpec> {
    METRICS.iter().find(|metric| metric.name == name)
}

#[cfg(test)]
mod tests {
    use super::super::{fill, lines, sample_fill, sample_lines};
    use super::*;
    use std::collections::BTreeSet;

    /// One value of each kind, every field set.
    fn samples() -> [PictureMetrics; 2] {
        let fill = FillMetrics { flip: Some(0.0), ..FillMetrics::default() };
        [PictureMetrics::Lines(LineMetrics::default()), PictureMetrics::Fill(fill)]
    }

    #[test]
    fn the_table_names_every_field_once_and_reads_what_it_writes() {
        for mut metrics in samples() {
            let kind = metrics.kind();
            let json = serde_json::to_value(metrics).unwrap();
            let fields: BTreeSet<String> = json[kind.name()].as_object().unwrap().keys().cloned().collect();
            let named: BTreeSet<String> = kind.metrics().map(|metric| metric.name.to_owned()).collect();
            assert_eq!((fields, kind.metrics().count()), (named.clone(), named.len()));
            for (value, metric) in (1..).map(f64::from).zip(kind.metrics()) {
                *(metric.value_mut)(&mut metrics).unwrap() = value;
                let written = &serde_json::to_value(metrics).unwrap()[kind.name()][metric.name];
                assert_eq!((written.as_f64(), (metric.value)(&metrics)), (Some(value), Some(value)), "{}", metric.name);
            }
            for metric in METRICS.iter().filter(|metric| metric.kind != kind) {
                assert_eq!((metric.value)(&metrics), None, "{}", metric.name);
            }
        }
        assert_eq!(METRICS.map(|metric| metric.name).iter().collect::<BTreeSet<_>>().len(), METRICS.len());
    }

    #[test]
    fn the_truth_itself_scores_best() {
        let sample = sample_lines::crossing_lines();
        let pen = lines::TruePen { picture: &sample.pen, width_px: sample_lines::PEN_PX };
        let line_metrics = PictureMetrics::Lines(lines::measure(&sample.pen, &sample.lines, pen));
        let disc = sample_fill::picture(&sample_fill::disc(glam::DVec2::splat(32.0), 20.0));
        let fill_metrics = PictureMetrics::Fill(fill::measure_fill(&disc, &disc));
        for metrics in [line_metrics, fill_metrics] {
            for metric in metrics.kind().metrics().filter(|metric| metric.better == Better::Lower) {
                let limit = if metric.name == "width_deviation_px" { 0.15 } else { 1e-12 };
                assert!((metric.value)(&metrics).is_none_or(|value| value < limit), "{}: {metrics:?}", metric.name);
            }
        }
    }

    #[test]
    fn views_are_averaged_and_what_one_lacks_is_lacking() {
        let fill = |psnr_db, flip| PictureMetrics::Fill(FillMetrics { psnr_db, flip, ..FillMetrics::default() });
        let mean = PictureMetrics::mean(&[fill(20.0, Some(0.5)), fill(30.0, Some(0.25))]);
        assert_eq!(mean, Some(fill(25.0, Some(0.375))));
        assert_eq!(PictureMetrics::mean(&[fill(20.0, None); 2]), Some(fill(20.0, None)));
        assert_eq!(PictureMetrics::mean(&[]), None);
    }

    #[test]
    fn the_leading_metric_of_each_kind_is_a_distance_of_that_kind() {
        for kind in PictureKind::ALL {
            let leading = kind.leading_metric();
            assert_eq!((leading.kind, leading.unit, leading.better), (kind, "px", Better::Lower));
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
