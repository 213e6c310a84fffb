//! Rows of a comparison's own extractions.

use super::{ExtractionRow, OURS};
use crate::cost::Spread;
use crate::machine::{MachineFacts, RunDescription};
use crate::record::Cell;
use crate::record::label::label;

/// One row for each cell of a comparison that extracts edges, in their order. Times are those of its frames: between two
/// extractions a frame is drawn, which leaves caches colder than extractions one after another. `runs` are those that the cells
/// refer to. O(cells squared).
pub fn rows_of_cells(cells: &[Cell], runs: &[RunDescription]) -> Vec<ExtractionRow> {
    cells.iter().filter_map(|cell| row(label(cell, cells), cell, runs.get(cell.run)?)).collect()
}

/// The row of a cell; `None` where it extracts no edges, or faster than the clock ticks.
fn row(method: String, cell: &Cell, run: &RunDescription) -> Option<ExtractionRow> {
    let spread = cell.frame.extract_ms.filter(|spread| spread.median > 0.0)?;
    let counts: Vec<f64> = cell.views.iter().filter_map(|view| Some(view.edges?.found as f64)).collect();
    let counters = cell.frame.counters;
    let (faces, edges) = (cell.mesh.faces as u64, cell.mesh.edges as u64);
    Some(ExtractionRow {
        tool: OURS.to_owned(),
        method,
        mesh: cell.mesh.name.clone(),
        faces,
        edges,
        silhouette_edges: Spread::of(&counts).map(|spread| spread.median),
        recall: cell.recall(),
        views: cell.frame.frames,
        threads: u32::try_from(run.threads).unwrap_or(u32::MAX),
        median_ms: spread.median,
        p95_ms: spread.p95,
        edges_per_second: edges as f64 / spread.median * 1000.0,
        prepare_ms: Some(cell.prepare.prepare_ms),
        bytes: Some(cell.prepare.bytes),
        bytes_per_edge: Some(cell.prepare.bytes as f64 / edges.max(1) as f64),
        faces_tested: counters.map(|counters| counters.faces_tested),
        edges_tested: counters.map(|counters| counters.edges_tested),
        nodes_visited: counters.map(|counters| counters.nodes_visited),
        exact_fallbacks: counters.map(|counters| counters.exact_fallbacks),
        machine: MachineFacts { cpu: run.cpu.clone(), threads: run.threads, system: run.system.clone() }.to_string(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::OptionSetting;
    use crate::record::EdgeScore;
    use crate::record::tests::{cell, run, view, with_option};

    #[test]
    fn a_cell_that_extracts_edges_is_one_row() {
        let mut found = cell("a", "brute-force", 4.0, 1.0);
        let mut second = view(15, 1.0);
        second.edges = Some(EdgeScore { found: 2, precision: 1.0, recall: 0.5 });
        found.views.push(second);
        let mut drawn = cell("a", "image-precision", 2.0, 1.0);
        drawn.frame.extract_ms = None;
        let rows = rows_of_cells(&[found, drawn], &[run()]);
        let [row] = &rows[..] else { panic!("{rows:?}") };
        assert_eq!((row.label().as_str(), row.faces, row.views), ("brute-force, 2 threads", 4, 20));
        assert_eq!((row.median_ms, row.p95_ms, row.edges_per_second), (1.0, 2.0, 6000.0));
        assert_eq!((row.silhouette_edges, row.recall, row.bytes), (Some(3.0), Some(0.75), Some(300)));
        assert_eq!(row.machine, "a <processor>, 2 threads, some system");
    }

    #[test]
    fn options_are_named_where_they_differ() {
        let seeded = |seed: f64| with_option(cell("a", "m", 1.0, 1.0), "seed", OptionSetting::Number(seed));
        let rows = rows_of_cells(&[seeded(1.0), seeded(2.0)], &[run()]);
        let names: Vec<String> = rows.into_iter().map(|row| row.method).collect();
        assert_eq!(names, ["m (seed=1)", "m (seed=2)"]);
    }
}
