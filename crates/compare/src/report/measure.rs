//! [`Measure`]: what a chart shows over time, for every cell that has it.

use super::summary::CellSummary;
use crate::metrics::PictureKind;
use crate::metrics::table::{Better, MetricSpec};
use crate::pareto::pareto_front;

/// A number that is better the lower, or the higher, it is.
#[derive(Debug, Clone, Copy)]
pub struct Measure {
    /// Name in the report.
    pub title: &'static str,
    /// Unit.
    pub unit: &'static str,
    source: Source,
}

#[derive(Debug, Clone, Copy)]
enum Source {
    Metric(&'static MetricSpec),
    MissedEdges,
}

impl Measure {
    /// Those of a kind of picture: its metrics that have a direction, and for lines the share of silhouette edges that were
    /// not found.
    pub fn of_kind(kind: PictureKind) -> Vec<Self> {
        let mut measures = Vec::new();
        for metric in kind.metrics().filter(|metric| metric.better != Better::NearPenWidth) {
            let MetricSpec { title, unit, .. } = *metric;
            measures.push(Self { title, unit, source: Source::Metric(metric) });
        }
        if kind == PictureKind::Lines {
            measures.push(Self { title: "silhouette edges missed", unit: "share", source: Source::MissedEdges });
        }
        measures
    }

    /// The value of a cell; `None` where it has none.
    pub fn value(&self, summary: &CellSummary<'_>) -> Option<f64> {
        match self.source {
            Source::Metric(metric) => (metric.value)(&summary.metrics),
            Source::MissedEdges => summary.cell.recall().map(|recall| 1.0 - recall),
        }
    }

    /// Ends of the 95 % interval of that value; `None` where none was found.
    pub fn interval(&self, summary: &CellSummary<'_>) -> Option<[f64; 2]> {
        match self.source {
            Source::Metric(metric) => summary.cell.intervals.get(metric.name).copied(),
            Source::MissedEdges => None,
        }
    }

    /// Indices of the cells that no other beats in both median frame time and this. O(cells log cells).
    pub fn front(&self, cells: &[&CellSummary<'_>]) -> Vec<usize> {
        let error = |summary: &CellSummary<'_>| match self.source {
            Source::Metric(metric) => metric.error(&summary.metrics),
            Source::MissedEdges => self.value(summary),
        };
        // What has no value is never in the front.
        let point =
            |summary: &&CellSummary<'_>| [summary.cell.frame.frame_ms.median, error(summary).unwrap_or(f64::NAN)];
        pareto_front(&cells.iter().map(point).collect::<Vec<_>>())
    }
}

#[cfg(test)]
mod tests {
    use super::super::summary::summarise;
    use super::*;
    use crate::metrics::table::PictureMetrics;
    use crate::record::Cell;
    use crate::record::tests::{cell, fill_cell};

    fn front(cells: &[Cell], kind: PictureKind, title: &str) -> Vec<usize> {
        let meshes = summarise(cells);
        let measure = Measure::of_kind(kind).into_iter().find(|measure| measure.title == title).unwrap();
        measure.front(&meshes[0].of_kind(kind))
    }

    #[test]
    fn the_front_leaves_out_what_is_beaten() {
        let cells = [cell("a", "x", 4.0, 1.0), cell("a", "y", 1.0, 3.0), cell("a", "z", 5.0, 2.0)];
        assert_eq!(front(&cells, PictureKind::Lines, "Chamfer distance"), [1, 0]);
    }

    #[test]
    fn where_higher_is_better_the_front_is_of_the_highest() {
        let psnr = |name: &str, frame_ms: f64, psnr_db: f64| {
            let mut cell = fill_cell("a", name, frame_ms, 0.0);
            let PictureMetrics::Fill(metrics) = &mut cell.views[0].metrics else { panic!("filled") };
            metrics.psnr_db = psnr_db;
            cell
        };
        let cells = [psnr("x", 1.0, 20.0), psnr("y", 2.0, 40.0), psnr("z", 3.0, 30.0)];
        assert_eq!(front(&cells, PictureKind::Fill, "PSNR"), [0, 1]);
        assert!(front(&cells, PictureKind::Fill, "FLIP").is_empty(), "not measured by this test");
    }

    #[test]
    fn missed_edges_are_those_of_methods_that_find_edges() {
        let mut lossy = cell("a", "x", 1.0, 1.0);
        lossy.views[0].edges.as_mut().unwrap().recall = 0.75;
        let mut drawn = cell("a", "y", 0.5, 1.0);
        drawn.views[0].edges = None;
        let cells = [lossy, drawn, cell("a", "z", 3.0, 1.0)];
        assert_eq!(front(&cells, PictureKind::Lines, "silhouette edges missed"), [0, 2]);
    }
}
