//! Cells as a flat table: one row per scored view.
//!
//! What belongs to the whole run is not in it. Each option is a column, named `METHOD.OPTION` as on the command line and
//! empty in rows of other methods. Metrics of kinds of picture that no cell has are left out. Last come the [lengths](LENGTHS)
//! of where pictures of lines err, and [coherence](COHERENCE) along each motion, named `MOTION_METRIC` and the same in all rows of a
//! cell; it is empty where the mesh moved and the method cannot follow.

use super::{Cell, View};
use crate::coherence::Motion;
use crate::coherence::metrics::{COHERENCE, CoherenceSpec};
use crate::metrics::PictureKind;
use crate::metrics::line_errors::LENGTHS;
use crate::metrics::table::MetricSpec;

/// A table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Table {
    /// Names of the columns.
    pub columns: Vec<String>,
    /// The rows, with a value for every column; empty where something does not apply.
    pub rows: Vec<Vec<String>>,
}

type Column = (&'static str, fn(&Cell, &View) -> String);

fn optional<T: ToString>(value: Option<T>) -> String {
    value.map(|value| value.to_string()).unwrap_or_default()
}

/// The columns before those of options and metrics.
const COLUMNS: [Column; 31] = [
    ("mesh", |cell, _| cell.mesh.name.clone()),
    ("vertices", |cell, _| cell.mesh.vertices.to_string()),
    ("faces", |cell, _| cell.mesh.faces.to_string()),
    ("method", |cell, _| cell.method.clone()),
    ("picture", |cell, _| cell.picture.name().to_owned()),
    ("run", |cell, _| cell.run.to_string()),
    ("pen_width_px", |cell, _| optional(cell.pen.as_ref().map(|pen| pen.width_px))),
    ("pen_placement", |cell, _| optional(cell.pen.as_ref().map(|pen| pen.placement.clone()))),
    ("prepare_ms", |cell, _| cell.prepare.prepare_ms.to_string()),
    ("renderer_ms", |cell, _| cell.prepare.renderer_ms.to_string()),
    ("bytes_prepared", |cell, _| cell.prepare.bytes.to_string()),
    ("frames", |cell, _| cell.frame.frames.to_string()),
    ("frame_median_ms", |cell, _| cell.frame.frame_ms.median.to_string()),
    ("frame_p95_ms", |cell, _| cell.frame.frame_ms.p95.to_string()),
    ("frame_max_ms", |cell, _| cell.frame.frame_ms.max.to_string()),
    ("gpu_median_ms", |cell, _| optional(cell.frame.gpu_ms.map(|spread| spread.median))),
    ("extract_median_ms", |cell, _| optional(cell.frame.extract_ms.map(|spread| spread.median))),
    ("faces_tested", |cell, _| optional(cell.frame.counters.map(|counters| counters.faces_tested))),
    ("edges_tested", |cell, _| optional(cell.frame.counters.map(|counters| counters.edges_tested))),
    ("frame", |_, view| view.frame.to_string()),
    ("eye_x", |_, view| view.camera.eye[0].to_string()),
    ("eye_y", |_, view| view.camera.eye[1].to_string()),
    ("eye_z", |_, view| view.camera.eye[2].to_string()),
    ("frame_ms", |_, view| view.frame_ms.to_string()),
    ("extract_ms", |_, view| optional(view.extract_ms)),
    ("silhouette_edges", |_, view| view.truth.silhouette_edges.to_string()),
    ("visible_length_px", |_, view| view.truth.visible_length_px.to_string()),
    ("true_area_px", |_, view| optional(view.truth.area_px)),
    ("edges_found", |_, view| optional(view.edges.map(|edges| edges.found))),
    ("edge_precision", |_, view| optional(view.edges.map(|edges| edges.precision))),
    ("edge_recall", |_, view| optional(view.edges.map(|edges| edges.recall))),
];

impl Table {
    /// The views of cells, in their order. O(rows x columns).
    pub fn of(cells: &[Cell]) -> Self {
        let mut options: Vec<(&str, &str)> = Vec::new();
        for cell in cells {
            for name in cell.options.0.keys() {
                let column = (cell.method.as_str(), name.as_str());
                if !options.contains(&column) {
                    options.push(column);
                }
            }
        }
        let is_there = |kind: &PictureKind| cells.iter().any(|cell| cell.picture == *kind);
        let metrics: Vec<&MetricSpec> =
            PictureKind::ALL.into_iter().filter(is_there).flat_map(PictureKind::metrics).collect();

        let lengths = if cells.iter().any(|cell| cell.picture == PictureKind::Lines) { LENGTHS } else { &[] };

        let is_followed =
            |motion: &Motion| cells.iter().any(|cell| cell.coherence.iter().any(|record| record.motion == *motion));
        let of_motion = |motion: Motion| COHERENCE.iter().map(move |spec| (motion, spec));
        let coherence: Vec<(Motion, &CoherenceSpec)> =
            Motion::ALL.into_iter().filter(is_followed).flat_map(of_motion).collect();

        let names = COLUMNS.iter().map(|(name, _)| (*name).to_owned());
        let option_names = options.iter().map(|(method, option)| format!("{method}.{option}"));
        let metric_names = metrics.iter().map(|metric| metric.name.to_owned());
        let coherence_names = coherence.iter().map(|(motion, spec)| format!("{}_{}", motion.name(), spec.name));
        let length_names = lengths.iter().map(|length| length.name.to_owned());
        let row = |cell: &Cell, view: &View| {
            let option = |&(method, name): &(&str, &str)| {
                let value = cell.options.0.get(name).filter(|_| cell.method == method);
                optional(value)
            };
            let fixed = COLUMNS.iter().map(|(_, value)| value(cell, view));
            let measured = metrics.iter().map(|metric| optional((metric.value)(&view.metrics)));
            let errors = view.errors.as_ref();
            let lengths = lengths.iter().map(|length| optional(errors.and_then(length.value)));
            let coherent = coherence.iter().map(|(motion, spec)| {
                let record = cell.coherence.iter().find(|record| record.motion == *motion);
                optional(record.and_then(|record| record.metrics.as_ref()).and_then(spec.value))
            });
            fixed.chain(options.iter().map(option)).chain(measured).chain(lengths).chain(coherent).collect()
        };
        Self {
            columns: names.chain(option_names).chain(metric_names).chain(length_names).chain(coherence_names).collect(),
            rows: cells.iter().flat_map(|cell| cell.views.iter().map(move |view| row(cell, view))).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{cell, fill_cell, view, with_coherence, with_option};
    use super::*;
    use crate::options::OptionSetting;
    use std::collections::BTreeSet;

    #[test]
    fn each_option_and_each_metric_is_a_column() {
        let mut tracking = with_option(cell("m", "tracking", 2.0, 0.5), "concavity", OptionSetting::Number(0.25));
        tracking.views.push(view(15, 0.75));
        let seeded = with_option(cell("m", "randomized", 2.0, 0.5), "seed", OptionSetting::Number(7.0));
        let table = Table::of(&[tracking, seeded, fill_cell("m", "fine-mesh", 1.0, 0.125)]);
        assert_eq!(table.columns.iter().collect::<BTreeSet<_>>().len(), table.columns.len());
        assert!(table.rows.iter().all(|row| row.len() == table.columns.len()));
        let column = |name: &str| {
            let at = table.columns.iter().position(|column| column == name).unwrap();
            table.rows.iter().map(|row| row[at].as_str()).collect::<Vec<_>>()
        };
        assert_eq!(column("tracking.concavity"), ["0.25", "0.25", "", ""]);
        assert_eq!(column("randomized.seed"), ["", "", "7", ""]);
        assert_eq!(column("chamfer_px"), ["0.5", "0.75", "0.5", ""]);
        assert_eq!(column("xor_share"), ["", "", "", "0.125"]);
        assert_eq!(column("frame"), ["5", "15", "5", "5"]);
        assert_eq!(column("gpu_median_ms"), [""; 4]);
        assert_eq!(column("true_crease_px"), ["20", "20", "20", ""]);
        assert_eq!(column("true_inner_px"), [""; 4], "where the outline is not known");
    }

    #[test]
    fn each_motion_and_number_of_coherence_is_a_column() {
        let coherent = with_coherence(cell("m", "tracking", 2.0, 0.5), 0.25);
        let table = Table::of(&[coherent, cell("m", "brute-force", 2.0, 0.5)]);
        let column = |name: &str| {
            let at = table.columns.iter().position(|column| column == name).unwrap();
            table.rows.iter().map(|row| row[at].as_str()).collect::<Vec<_>>()
        };
        assert_eq!((column("orbit_flicker"), column("wave_flicker")), (vec!["0.25", ""], vec![""; 2]));
        assert_eq!(column("orbit_loops_lost"), ["0.5", ""]);
        assert!(!table.columns.iter().any(|column| column.starts_with("dolly")));
    }

    #[test]
    fn a_kind_of_picture_that_is_not_there_has_no_columns() {
        let table = Table::of(&[cell("m", "brute-force", 2.0, 0.5)]);
        assert!(!table.columns.iter().any(|column| column == "xor_share"));
        assert!(Table::of(&[]).rows.is_empty());
    }
}
