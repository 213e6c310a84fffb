//! Rows of the tables that set the methods of a mesh side by side.

use super::chart::look;
use super::summary::{CellSummary, baseline};
use super::text::{interval, megabytes, metric_text, milliseconds, optional};
use crate::cost::Spread;
use crate::metrics::PictureKind;
use crate::metrics::table::{Better, MetricSpec};
use crate::record::Cell;
use minijinja::{Value, context};

/// Which cell a row is about: its method with the options that distinguish it, the look of its dots, its row in the results.
pub(super) fn who(summary: &CellSummary<'_>) -> Value {
    let [color, shape] = look(summary.series);
    context! {
        method => &summary.cell.method,
        options => summary.options.to_string(),
        color => color,
        shape => shape,
        row => summary.row,
    }
}

/// The quality of a cell beside that of the others of its mesh.
pub(super) fn quality_row(kind: PictureKind, cells: &[&CellSummary<'_>], summary: &CellSummary<'_>) -> Value {
    let is_best = |metric: &MetricSpec| {
        let value = (metric.value)(&summary.metrics);
        let others = || cells.iter().filter_map(|other| (metric.value)(&other.metrics));
        let is_beaten = |value: f64| match metric.better {
            Better::Lower => others().any(|other| other < value),
            Better::Higher => others().any(|other| other > value),
            Better::NearPenWidth => true,
        };
        cells.len() > 1 && value.is_some_and(|value| !is_beaten(value))
    };
    let metrics = kind.metrics().map(|metric| {
        let text = optional((metric.value)(&summary.metrics), |value| metric_text(metric, value));
        let ends = summary.cell.intervals.get(metric.name).copied();
        let interval = interval(ends, |end| metric_text(metric, end));
        context! { text => text, interval => interval, best => is_best(metric) }
    });
    let (edges, edges_wrong) = edges_found(summary.cell);
    context! {
        who => who(summary),
        pen => summary.cell.pen.as_ref().map(|pen| format!("{} px, {}", pen.width_px, pen.placement)),
        metrics => metrics.collect::<Vec<_>>(),
        edges => edges,
        edges_wrong => edges_wrong,
    }
}

/// How many silhouette edges a cell found, in words, and whether that is not all of them and no others.
pub(super) fn edges_found(cell: &Cell) -> (String, bool) {
    let worst = cell.worst_edges();
    let is_wrong = worst.is_some_and(|edges| edges.precision < 1.0 || edges.recall < 1.0);
    let text = match (worst, cell.recall()) {
        (Some(worst), Some(recall)) if is_wrong => {
            let percent = |share: f64| format!("{:.2} %", share * 100.0);
            let missed = format!("recall {}, worst frame {}", percent(recall), percent(worst.recall));
            let is_precise = worst.precision >= 1.0;
            if is_precise { missed } else { format!("{missed}; precision {}", percent(worst.precision)) }
        }
        (Some(_), _) => "all, exact".to_owned(),
        (None, _) => "draws only".to_owned(),
    };
    (text, is_wrong)
}

/// What a cell cost.
pub(super) fn cost_row(summary: &CellSummary<'_>) -> Value {
    let ratio = |value: Option<f64>| optional(value, |value| format!("{value:.3}"));
    let between = |spread: Option<Spread>| interval(spread.map(|spread| spread.interval), milliseconds);
    let Cell { prepare, frame, picture, .. } = summary.cell;
    context! {
        who => who(summary),
        baseline => baseline(*picture),
        prepare => milliseconds(prepare.prepare_ms),
        renderer => milliseconds(prepare.renderer_ms),
        bytes => megabytes(prepare.bytes),
        extract => optional(frame.extract_ms.map(|spread| spread.median), milliseconds),
        gpu => optional(frame.gpu_ms.map(|spread| spread.median), milliseconds),
        median => milliseconds(frame.frame_ms.median),
        median_interval => between(Some(frame.frame_ms)),
        extract_interval => between(frame.extract_ms),
        gpu_interval => between(frame.gpu_ms),
        p95 => milliseconds(frame.frame_ms.p95),
        max => milliseconds(frame.frame_ms.max),
        frame_ratio => ratio(summary.frame_ratio),
        extract_ratio => ratio(summary.extract_ratio),
    }
}
