//! Tables for people, on standard output.

use silhouette_compare::scaling::{ExtractionRow, OURS, series};
use std::io::{self, Write};

/// Method that ratios are stated to.
const REFERENCE: &str = "brute-force-simd";

/// The rows of one mesh, and those of `others` on a mesh of this name, with ratios to [`REFERENCE`] of this run, and of
/// each method to itself with the fewest threads of this run.
pub fn write_mesh(rows: &[ExtractionRow], others: &[ExtractionRow], out: &mut impl Write) -> io::Result<()> {
    let Some(first) = rows.first() else { return Ok(()) };
    writeln!(out, "\n{}: {} faces, {} edges", first.mesh, first.faces, first.edges)?;
    writeln!(
        out,
        "{:42} {:>10} {:>10} {:>8} {:>8} {:>9} {:>10} {:>8} {:>7} {:>9} {:>9} {:>9} {:>7} {:>7}",
        "method",
        "median ms",
        "p95 ms",
        "ratio",
        "speed-up",
        "Medges/s",
        "prepare ms",
        "MB",
        "B/edge",
        "faces",
        "edges",
        "nodes",
        "exact",
        "recall"
    )?;
    let time_of = |tool: &str, method: &str, threads: u32| {
        let mut same = rows.iter().filter(|row| row.tool == tool && row.method == method && row.threads == threads);
        same.next().map(|row| row.median_ms)
    };
    let fewest = rows.iter().map(|row| row.threads).min().unwrap_or(1);
    let same_mesh = others.iter().filter(|other| other.mesh == first.mesh && other.faces == first.faces);
    let of_this_run = rows.iter().map(|row| (row, time_of(&row.tool, &row.method, fewest)));
    for (row, alone) in of_this_run.chain(same_mesh.map(|row| (row, None))) {
        let optional = |value: Option<f64>, digits: usize| {
            value.map_or_else(|| "-".to_owned(), |value| format!("{value:.digits$}"))
        };
        writeln!(
            out,
            "{:42} {:>10.4} {:>10.4} {:>8} {:>8} {:>9.1} {:>10} {:>8} {:>7} {:>9} {:>9} {:>9} {:>7} {:>7}",
            row.label(),
            row.median_ms,
            row.p95_ms,
            optional(time_of(OURS, REFERENCE, row.threads).map(|reference| row.median_ms / reference), 3),
            optional(alone.filter(|_| row.threads > fewest).map(|alone| alone / row.median_ms), 3),
            row.edges_per_second / 1e6,
            optional(row.prepare_ms, 1),
            optional(row.bytes.map(|bytes| bytes as f64 / 1e6), 2),
            optional(row.bytes_per_edge, 1),
            optional(row.faces_tested, 0),
            optional(row.edges_tested, 0),
            optional(row.nodes_visited, 0),
            optional(row.exact_fallbacks, 1),
            optional(row.recall, 4),
        )?;
    }
    writeln!(
        out,
        "ratio: median time over that of {REFERENCE} with as many threads in this run, of which rows of --peers are no part"
    )?;
    if rows.iter().any(|row| row.threads > fewest) {
        let plural = if fewest == 1 { "" } else { "s" };
        writeln!(
            out,
            "speed-up: median time of the same method with {fewest} thread{plural} in this run over this one"
        )?;
    }
    Ok(())
}

/// How the time of each method grows, where there are sizes enough.
pub fn write_growth(rows: &[ExtractionRow], out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "\ntime ~ faces^exponent, least squares on logarithms")?;
    for series in series(rows) {
        let Some(growth) = series.growth() else { continue };
        let shape = growth.shape.as_deref().unwrap_or("all meshes");
        writeln!(
            out,
            "{:42} exponent {:>6.3}  r2 {:.4}  {shape}, {} to {} faces",
            series.label, growth.law.exponent, growth.law.r2, growth.faces[0], growth.faces[1]
        )?;
    }
    Ok(())
}
