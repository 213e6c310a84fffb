//! Rows of a comparison's own extractions.

use super::{ExtractionRow, OURS};
use crate::cost::Spread;
use crate::machine::MachineFacts;
use crate::record::Record;

/// One row for each mesh and method of a comparison that extracts edges, in the order of the records. Times are those of
/// its frames: between two extractions a frame is drawn, which leaves caches colder than extractions one after another.
/// O(records x rows).
pub fn rows_of_records(records: &[Record]) -> Vec<ExtractionRow> {
    let mut rows = Vec::new();
    let mut seen: Vec<&Record> = Vec::new();
    let is_same = |a: &Record, b: &Record| a.mesh == b.mesh && a.method == b.method && a.options == b.options;
    for record in records {
        if seen.iter().any(|other| is_same(other, record)) {
            continue;
        }
        seen.push(record);
        let views: Vec<&Record> = records.iter().filter(|other| is_same(other, record)).collect();
        // Options are part of the name only where a method was run with several.
        let name_is_enough =
            records.iter().all(|other| other.method != record.method || other.options == record.options);
        let method = if name_is_enough {
            record.method.clone()
        } else {
            format!("{} ({})", record.method, or_default(&record.options))
        };
        rows.extend(row(method, &views));
    }
    rows
}

fn or_default(options: &str) -> &str {
    if options.is_empty() { "default" } else { options }
}

/// The row of all views of a mesh and method; `None` where it extracts no edges, or faster than the clock ticks.
fn row(method: String, views: &[&Record]) -> Option<ExtractionRow> {
    let first = *views.first()?;
    let spread = first.frame.extract_ms.filter(|spread| spread.median > 0.0)?;
    let scores = || views.iter().filter_map(|record| record.edges.map(|edges| (edges, record.truth.silhouette_edges)));
    let counts: Vec<f64> = scores().map(|(edges, _)| edges.found as f64).collect();
    let expected: usize = scores().map(|(_, expected)| expected).sum();
    let right: f64 = scores().map(|(edges, expected)| edges.recall * expected as f64).sum();
    let counters = first.frame.counters;
    let (faces, edges) = (first.mesh.faces as u64, first.mesh.edges as u64);
    let run = &first.run;
    Some(ExtractionRow {
        tool: OURS.to_owned(),
        method,
        mesh: first.mesh.name.clone(),
        faces,
        edges,
        silhouette_edges: Spread::of(&counts).map(|spread| spread.median),
        recall: Some(if expected > 0 { (right / expected as f64).clamp(0.0, 1.0) } else { 1.0 }),
        views: first.frame.frames,
        threads: u32::try_from(run.threads).unwrap_or(u32::MAX),
        median_ms: spread.median,
        p95_ms: spread.p95,
        edges_per_second: edges as f64 / spread.median * 1000.0,
        prepare_ms: Some(first.prepare.prepare_ms),
        bytes: Some(first.prepare.bytes),
        bytes_per_edge: Some(first.prepare.bytes as f64 / edges.max(1) as f64),
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
    use crate::record::EdgeScore;
    use crate::record::tests::record;

    #[test]
    fn views_of_a_mesh_and_method_are_one_row() {
        let mut second = record("a", "brute-force", 4.0, 1.0);
        second.edges = Some(EdgeScore { found: 2, precision: 1.0, recall: 0.5 });
        let mut drawn = record("a", "image-precision", 2.0, 1.0);
        drawn.frame.extract_ms = None;
        let rows = rows_of_records(&[record("a", "brute-force", 4.0, 1.0), second, drawn]);
        let [row] = &rows[..] else { panic!("{rows:?}") };
        assert_eq!((row.label().as_str(), row.faces, row.views), ("brute-force, 2 threads", 4, 20));
        assert_eq!((row.median_ms, row.p95_ms, row.edges_per_second), (1.0, 2.0, 6000.0));
        assert_eq!((row.silhouette_edges, row.recall, row.bytes), (Some(3.0), Some(0.75), Some(300)));
        assert_eq!(row.machine, "a <processor>, 2 threads, some system");
    }

    #[test]
    fn options_are_named_where_they_differ() {
        let mut other = record("a", "m", 1.0, 1.0);
        other.options = "seed=2".to_owned();
        let names: Vec<String> =
            rows_of_records(&[record("a", "m", 1.0, 1.0), other]).into_iter().map(|row| row.method).collect();
        assert_eq!(names, ["m (default)", "m (seed=2)"]);
    }
}
