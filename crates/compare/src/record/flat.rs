//! Cells as flat tables: one row per [scored view](Table::of_views), or one per [cell](Table::of_cells).
//!
//! What belongs to the whole run is not in it. Each option is a column, named `METHOD.OPTION` as on the command line and
//! empty in rows of other methods. Metrics of kinds of picture that no cell has are left out. The last columns of the table of views
//! are the [lengths](LENGTHS) of where pictures of lines err, and [coherence](COHERENCE) along each motion, named `MOTION_METRIC` and
//! the same in all rows of a cell; it is empty where the mesh moved and the method cannot follow.

use super::{Cell, View};
use crate::coherence::Motion;
use crate::coherence::metrics::{COHERENCE, CoherenceSpec};
use crate::metrics::PictureKind;
use crate::metrics::line_errors::LENGTHS;
use crate::metrics::table::MetricSpec;
use std::io;

/// A table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Table {
    /// Names of the columns.
    pub columns: Vec<String>,
    /// The rows, with a value for every column; empty where something does not apply.
    pub rows: Vec<Vec<String>>,
}

type CellColumn = (&'static str, fn(&Cell) -> String);
type ViewColumn = (&'static str, fn(&View) -> String);

fn optional<T: ToString>(value: Option<T>) -> String {
    value.map(|value| value.to_string()).unwrap_or_default()
}

/// The columns that are the same for all views of a cell, before those of options.
const CELL_COLUMNS: [CellColumn; 25] = [
    ("mesh", |cell| cell.mesh.name.clone()),
    ("vertices", |cell| cell.mesh.vertices.to_string()),
    ("faces", |cell| cell.mesh.faces.to_string()),
    ("method", |cell| cell.method.clone()),
    ("picture", |cell| cell.picture.name().to_owned()),
    ("run", |cell| cell.run.to_string()),
    ("pen_width_px", |cell| optional(cell.pen.as_ref().map(|pen| pen.width_px))),
    ("pen_placement", |cell| optional(cell.pen.as_ref().map(|pen| pen.placement.clone()))),
    ("prepare_ms", |cell| cell.prepare.prepare_ms.to_string()),
    ("renderer_ms", |cell| cell.prepare.renderer_ms.to_string()),
    ("bytes_prepared", |cell| cell.prepare.bytes.to_string()),
    ("frames", |cell| cell.frame.frames.to_string()),
    ("frame_median_ms", |cell| cell.frame.frame_ms.median.to_string()),
    ("frame_median_low_ms", |cell| cell.frame.frame_ms.interval[0].to_string()),
    ("frame_median_high_ms", |cell| cell.frame.frame_ms.interval[1].to_string()),
    ("frame_p95_ms", |cell| cell.frame.frame_ms.p95.to_string()),
    ("frame_max_ms", |cell| cell.frame.frame_ms.max.to_string()),
    ("gpu_median_ms", |cell| optional(cell.frame.gpu_ms.map(|spread| spread.median))),
    ("gpu_median_low_ms", |cell| optional(cell.frame.gpu_ms.map(|spread| spread.interval[0]))),
    ("gpu_median_high_ms", |cell| optional(cell.frame.gpu_ms.map(|spread| spread.interval[1]))),
    ("extract_median_ms", |cell| optional(cell.frame.extract_ms.map(|spread| spread.median))),
    ("extract_median_low_ms", |cell| optional(cell.frame.extract_ms.map(|spread| spread.interval[0]))),
    ("extract_median_high_ms", |cell| optional(cell.frame.extract_ms.map(|spread| spread.interval[1]))),
    ("faces_tested", |cell| optional(cell.frame.counters.map(|counters| counters.faces_tested))),
    ("edges_tested", |cell| optional(cell.frame.counters.map(|counters| counters.edges_tested))),
];

/// The columns of a view, before those of its metrics.
const VIEW_COLUMNS: [ViewColumn; 12] = [
    ("frame", |view| view.frame.to_string()),
    ("eye_x", |view| view.camera.eye[0].to_string()),
    ("eye_y", |view| view.camera.eye[1].to_string()),
    ("eye_z", |view| view.camera.eye[2].to_string()),
    ("frame_ms", |view| view.frame_ms.to_string()),
    ("extract_ms", |view| optional(view.extract_ms)),
    ("silhouette_edges", |view| view.truth.silhouette_edges.to_string()),
    ("visible_length_px", |view| view.truth.visible_length_px.to_string()),
    ("true_area_px", |view| optional(view.truth.area_px)),
    ("edges_found", |view| optional(view.edges.map(|edges| edges.found))),
    ("edge_precision", |view| optional(view.edges.map(|edges| edges.precision))),
    ("edge_recall", |view| optional(view.edges.map(|edges| edges.recall))),
];

/// The columns that only some cells have.
struct Present<'a> {
    /// Methods with their options.
    options: Vec<(&'a str, &'a str)>,
    /// Metrics of the kinds of picture that are there.
    metrics: Vec<&'static MetricSpec>,
}

impl<'a> Present<'a> {
    fn in_cells(cells: &'a [Cell]) -> Self {
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
        let metrics = PictureKind::ALL.into_iter().filter(is_there).flat_map(PictureKind::metrics).collect();
        Self { options, metrics }
    }

    fn option_names(&self) -> impl Iterator<Item = String> + '_ {
        self.options.iter().map(|(method, option)| format!("{method}.{option}"))
    }

    fn options_of<'b>(&'b self, cell: &'b Cell) -> impl Iterator<Item = String> + 'b {
        let value = |&(method, name): &(&str, &str)| cell.options.0.get(name).filter(|_| cell.method == method);
        self.options.iter().map(move |option| optional(value(option)))
    }
}

impl Table {
    /// The views of cells, in their order. O(rows x columns).
    pub fn of_views(cells: &[Cell]) -> Self {
        let present = Present::in_cells(cells);
        let lengths = if cells.iter().any(|cell| cell.picture == PictureKind::Lines) { LENGTHS } else { &[] };
        let is_followed =
            |motion: &Motion| cells.iter().any(|cell| cell.coherence.iter().any(|record| record.motion == *motion));
        let of_motion = |motion: Motion| COHERENCE.iter().map(move |spec| (motion, spec));
        let coherence: Vec<(Motion, &CoherenceSpec)> =
            Motion::ALL.into_iter().filter(is_followed).flat_map(of_motion).collect();

        let fixed = CELL_COLUMNS.iter().map(|(name, _)| *name).chain(VIEW_COLUMNS.iter().map(|(name, _)| *name));
        let metric_names = present.metrics.iter().map(|metric| metric.name.to_owned());
        let length_names = lengths.iter().map(|length| length.name.to_owned());
        let coherence_names = coherence.iter().map(|(motion, spec)| format!("{}_{}", motion.name(), spec.name));
        let names = fixed.map(str::to_owned).chain(present.option_names());
        let columns = names.chain(metric_names).chain(length_names).chain(coherence_names).collect();

        let row = |cell: &Cell, view: &View| {
            let of_cell = CELL_COLUMNS.iter().map(|(_, value)| value(cell));
            let of_view = VIEW_COLUMNS.iter().map(|(_, value)| value(view));
            let measured = present.metrics.iter().map(|metric| optional((metric.value)(&view.metrics)));
            let errors = view.errors.as_ref();
            let lengths = lengths.iter().map(|length| optional(errors.and_then(length.value)));
            let coherent = coherence.iter().map(|(motion, spec)| {
                let record = cell.coherence.iter().find(|record| record.motion == *motion);
                optional(record.and_then(|record| record.metrics.as_ref()).and_then(spec.value))
            });
            of_cell
                .chain(of_view)
                .chain(present.options_of(cell))
                .chain(measured)
                .chain(lengths)
                .chain(coherent)
                .collect()
        };
        Self {
            columns,
            rows: cells.iter().flat_map(|cell| cell.views.iter().map(move |view| row(cell, view))).collect(),
        }
    }

    /// The table as CSV, the names of its columns first.
    ///
    /// # Errors
    /// A row of another length than that of the columns.
    pub fn to_csv(&self) -> io::Result<Vec<u8>> {
        let mut out = csv::Writer::from_writer(Vec::new());
        out.write_record(&self.columns)?;
        for row in &self.rows {
            out.write_record(row)?;
        }
        out.into_inner().map_err(csv::IntoInnerError::into_error)
    }

    /// The cells, in their order: of every metric the mean over the views, with the ends of its 95 % interval. O(rows x columns).
    pub fn of_cells(cells: &[Cell]) -> Self {
        let present = Present::in_cells(cells);
        let three = |metric: &&MetricSpec| ["", "_low", "_high"].map(|end| format!("{}{end}", metric.name));
        let fixed = CELL_COLUMNS.iter().map(|(name, _)| (*name).to_owned());
        let columns = fixed.chain(present.option_names()).chain(present.metrics.iter().flat_map(three)).collect();
        let row = |cell: &Cell| {
            let mean = cell.mean_metrics();
            let metrics = present.metrics.iter().flat_map(|metric| {
                let interval = cell.intervals.get(metric.name);
                let value = mean.as_ref().and_then(metric.value);
                [value, interval.map(|ends| ends[0]), interval.map(|ends| ends[1])].map(optional)
            });
            CELL_COLUMNS.iter().map(|(_, value)| value(cell)).chain(present.options_of(cell)).chain(metrics).collect()
        };
        Self { columns, rows: cells.iter().map(row).collect() }
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
        let table = Table::of_views(&[tracking, seeded, fill_cell("m", "fine-mesh", 1.0, 0.125)]);
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
    fn a_cell_is_a_row_with_means_and_their_intervals() {
        let mut spread = cell("m", "tracking", 2.0, 0.5);
        spread.views.push(view(15, 0.75));
        let spread = with_option(spread.with_intervals(), "concavity", OptionSetting::Number(0.25));
        let table = Table::of_cells(&[spread, fill_cell("m", "fine-mesh", 1.0, 0.125)]);
        let column = |name: &str| {
            let at = table.columns.iter().position(|column| column == name).unwrap();
            table.rows.iter().map(|row| row[at].as_str()).collect::<Vec<_>>()
        };
        assert_eq!(column("chamfer_px"), ["0.625", ""]);
        assert_eq!((column("chamfer_px_low"), column("chamfer_px_high")), (vec!["0.5", ""], vec!["0.75", ""]));
        assert_eq!(
            (column("frame_median_low_ms"), column("frame_median_high_ms")),
            (vec!["1", "0.5"], vec!["3", "1.5"])
        );
        assert_eq!(column("tracking.concavity"), ["0.25", ""]);
        assert!(table.rows.iter().all(|row| row.len() == table.columns.len()));
        assert!(Table::of_cells(&[]).rows.is_empty());
    }

    #[test]
    fn each_motion_and_number_of_coherence_is_a_column() {
        let coherent = with_coherence(cell("m", "tracking", 2.0, 0.5), 0.25);
        let table = Table::of_views(&[coherent, cell("m", "brute-force", 2.0, 0.5)]);
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
        let table = Table::of_views(&[cell("m", "brute-force", 2.0, 0.5)]);
        assert!(!table.columns.iter().any(|column| column == "xor_share"));
        assert!(Table::of_views(&[]).rows.is_empty());
    }
}
