//! Records of all views of a mesh and method, drawn together.

use crate::cost::{FrameCost, PrepareCost, Spread};
use crate::metrics::{LineMetrics, METRICS, MetricSpec};
use crate::pareto::pareto_front;
use crate::record::{EdgeScore, MeshRecord, PenRecord, Record};
use crate::registry::BASELINE;
use serde::Serialize;

/// A mesh with its methods.
#[derive(Debug, Clone, Serialize)]
pub struct MeshSummary {
    /// The mesh.
    pub mesh: MeshRecord,
    /// Number of views.
    pub views: usize,
    /// Visible silhouette on the mean of the views, in pixels.
    pub visible_length_px: f64,
    /// Its methods, in the order of the records.
    pub cells: Vec<CellSummary>,
}

/// A method on a mesh.
#[derive(Debug, Clone, Serialize)]
pub struct CellSummary {
    /// Name of the method.
    pub method: String,
    /// Its options.
    pub options: String,
    /// The pen.
    pub pen: PenRecord,
    /// Metrics on the mean of the views, each view counting the same.
    pub metrics: LineMetrics,
    /// Fewest edges found, lowest precision and recall of all views.
    pub edges: Option<EdgeScore>,
    /// Cost of the preparation.
    pub prepare: PrepareCost,
    /// Cost of frames.
    pub frame: FrameCost,
    /// Median frame time over that of the [`BASELINE`] on the same mesh in the same run.
    pub frame_ratio: Option<f64>,
    /// The same ratio of median times of the extraction alone.
    pub extract_ratio: Option<f64>,
}

impl MeshSummary {
    /// Indices of the cells that no other beats in both median frame time and `metric`.
    pub fn front(&self, metric: &MetricSpec) -> Vec<usize> {
        let point = |cell: &CellSummary| [cell.frame.frame_ms.median, (metric.value)(&cell.metrics)];
        pareto_front(&self.cells.iter().map(point).collect::<Vec<_>>())
    }
}

/// Draws records together, meshes and methods in the order of their first record. O(records x cells).
pub fn summarise(records: &[Record]) -> Vec<MeshSummary> {
    let mut meshes: Vec<MeshSummary> = Vec::new();
    for record in records {
        if meshes.iter().any(|mesh| mesh.mesh == record.mesh) {
            continue;
        }
        let of_mesh: Vec<&Record> = records.iter().filter(|other| other.mesh == record.mesh).collect();
        meshes.push(summarise_mesh(&of_mesh));
    }
    meshes
}

fn summarise_mesh(records: &[&Record]) -> MeshSummary {
    let mut cells: Vec<CellSummary> = Vec::new();
    let mut views = 0;
    for record in records {
        if cells.iter().any(|cell| cell.method == record.method && cell.options == record.options) {
            continue;
        }
        let is_same = |other: &&&Record| other.method == record.method && other.options == record.options;
        let of_cell: Vec<&Record> = records.iter().filter(is_same).copied().collect();
        views = views.max(of_cell.len());
        cells.push(summarise_cell(&of_cell));
    }
    let baseline = cells.iter().find(|cell| cell.method == BASELINE).map(|cell| cell.frame);
    for cell in &mut cells {
        let ratio =
            |ours: Spread, baseline: Spread| Some(ours.median / baseline.median).filter(|ratio| ratio.is_finite());
        cell.frame_ratio = baseline.and_then(|baseline| ratio(cell.frame.frame_ms, baseline.frame_ms));
        cell.extract_ratio = baseline.and_then(|baseline| ratio(cell.frame.extract_ms?, baseline.extract_ms?));
    }
    let lengths = records.iter().map(|record| record.truth.visible_length_px);
    let visible_length_px = lengths.sum::<f64>() / records.len() as f64;
    MeshSummary { mesh: records[0].mesh.clone(), views, visible_length_px, cells }
}

fn summarise_cell(records: &[&Record]) -> CellSummary {
    let first = records[0];
    let worst = |a: EdgeScore, b: EdgeScore| EdgeScore {
        found: a.found.min(b.found),
        precision: a.precision.min(b.precision),
        recall: a.recall.min(b.recall),
    };
    CellSummary {
        method: first.method.clone(),
        options: first.options.clone(),
        pen: first.pen.clone(),
        metrics: mean_metrics(records),
        edges: records.iter().filter_map(|record| record.edges).reduce(worst),
        prepare: first.prepare,
        frame: first.frame,
        frame_ratio: None,
        extract_ratio: None,
    }
}

fn mean_metrics(records: &[&Record]) -> LineMetrics {
    let mut mean = LineMetrics::default();
    for metric in &METRICS {
        let sum: f64 = records.iter().map(|record| (metric.value)(&record.metrics)).sum();
        *(metric.value_mut)(&mut mean) = sum / records.len() as f64;
    }
    mean
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics;
    use crate::record::tests::record;

    #[test]
    fn views_are_averaged_and_the_worst_edge_score_is_kept() {
        let mut worse = record("a", BASELINE, 4.0, 3.0);
        worse.edges = Some(EdgeScore { found: 9, precision: 0.5, recall: 0.75 });
        let records =
            [record("a", BASELINE, 4.0, 1.0), worse, record("a", "fast", 1.0, 5.0), record("b", "fast", 1.0, 0.0)];
        let meshes = summarise(&records);
        assert_eq!(meshes.iter().map(|mesh| mesh.cells.len()).collect::<Vec<_>>(), [2, 1]);
        let cell = &meshes[0].cells[0];
        assert!((cell.metrics.chamfer_px - 2.0).abs() < 1e-12 && (cell.metrics.width_mean_px - 2.0).abs() < 1e-12);
        assert_eq!(cell.edges, Some(EdgeScore { found: 4, precision: 0.5, recall: 0.75 }));
        assert_eq!((meshes[0].views, meshes[0].cells[1].frame_ratio), (2, Some(0.25)));
        assert_eq!(meshes[0].cells[1].extract_ratio, Some(0.25));
        assert_eq!(meshes[1].cells[0].frame_ratio, None, "no baseline on this mesh");
    }

    #[test]
    fn the_front_leaves_out_what_is_beaten() {
        let records = [record("a", "x", 4.0, 1.0), record("a", "y", 1.0, 3.0), record("a", "z", 5.0, 2.0)];
        let metric = metrics::find("chamfer_px").unwrap();
        assert_eq!(summarise(&records)[0].front(metric), [1, 0]);
    }
}
