//! [`ExtractionRow`] and the files that hold them.

use serde::{Deserialize, Serialize};
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};

/// [`ExtractionRow::tool`] of this workspace's own methods.
pub const OURS: &str = "silhouettes";

/// Longest line that [`read_rows`] takes, in bytes: a row has some five hundred.
pub const MAX_LINE_BYTES: u64 = 1 << 16;

/// What extracting the silhouette edges of one mesh cost a method of some tool: one line of a JSON Lines file.
///
/// Times are of extractions alone, over many views, preparation left out. A tool leaves out what it does not know.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ExtractionRow {
    /// Program that was measured: [`OURS`], `vtk`, `numpy`, or `stream-read` for a plain read of as many bytes.
    pub tool: String,
    /// Name of the method in that program.
    pub method: String,
    /// Name of the mesh: a file's name, or `builtin:NAME`.
    pub mesh: String,
    /// Number of faces, polygons fanned; at least 1.
    pub faces: u64,
    /// Number of edges.
    pub edges: u64,
    /// Silhouette edges found, median over the views.
    #[serde(default)]
    pub silhouette_edges: Option<f64>,
    /// Silhouette edges found over those that there are, all views together, 0 to 1; where the truth was known.
    #[serde(default)]
    pub recall: Option<f64>,
    /// Number of views; at least 1.
    pub views: u32,
    /// Threads that the tool could use; at least 1.
    pub threads: u32,
    /// Wall time of an extraction in milliseconds, median over the views; above 0.
    pub median_ms: f64,
    /// Its 95th percentile by nearest rank; not below the median.
    pub p95_ms: f64,
    /// All edges of the mesh over the median time.
    pub edges_per_second: f64,
    /// Wall time of the preparation in milliseconds, everything built from positions and triangles.
    #[serde(default)]
    pub prepare_ms: Option<f64>,
    /// Bytes prepared, the mesh itself left out; for `stream-read` the bytes read.
    #[serde(default)]
    pub bytes: Option<u64>,
    /// `bytes` over `edges`.
    #[serde(default)]
    pub bytes_per_edge: Option<f64>,
    /// Faces whose facing was evaluated, averaged over views.
    #[serde(default)]
    pub faces_tested: Option<f64>,
    /// Edges looked at, averaged over views.
    #[serde(default)]
    pub edges_tested: Option<f64>,
    /// Nodes of a hierarchy whose bounds were evaluated, averaged over views.
    #[serde(default)]
    pub nodes_visited: Option<f64>,
    /// Faces decided by exact arithmetic, averaged over views.
    #[serde(default)]
    pub exact_fallbacks: Option<f64>,
    /// Processor, threads and system, as [`describe_machine`](crate::machine::describe_machine) states them.
    pub machine: String,
}

/// Why rows could not be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RowsError {
    /// The file could not be read.
    #[error("{}: {cause}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// Why.
        cause: io::Error,
    },
    /// A line is no row.
    #[error("{}: line {line}: {fault}", path.display())]
    Line {
        /// The file.
        path: PathBuf,
        /// The line, from 1.
        line: usize,
        /// What is wrong with it.
        fault: RowFault,
    },
    /// The file holds no row at all.
    #[error("{}: no row in it; write one JSON object per line", path.display())]
    Empty {
        /// The file.
        path: PathBuf,
    },
}

/// What is wrong with a line.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RowFault {
    /// It is no JSON, or lacks a field.
    #[error(transparent)]
    Json(#[from] serde_json::Error),
    /// It is longer than [`MAX_LINE_BYTES`].
    #[error("longer than {MAX_LINE_BYTES} bytes, so no row of timings")]
    TooLong,
    /// A value is out of its range.
    #[error("{field} must be {expected}")]
    Range {
        /// The field.
        field: &'static str,
        /// The range.
        expected: &'static str,
    },
}

impl ExtractionRow {
    /// Who was measured, for legends: the method's name, with the tool's where it is not ours, and the number of threads
    /// where there are several.
    pub fn label(&self) -> String {
        let Self { tool, method, threads, .. } = self;
        let name = if tool == OURS { method.clone() } else { format!("{tool}: {method}") };
        if *threads > 1 { format!("{name}, {threads} threads") } else { name }
    }

    fn check(&self) -> Result<(), RowFault> {
        let range = |ok: bool, field, expected| if ok { Ok(()) } else { Err(RowFault::Range { field, expected }) };
        for (field, text) in [("tool", &self.tool), ("method", &self.method), ("mesh", &self.mesh)] {
            range(!text.trim().is_empty(), field, "a name")?;
        }
        range(self.faces > 0, "faces", "at least 1")?;
        range(self.views > 0, "views", "at least 1")?;
        range(self.threads > 0, "threads", "at least 1")?;
        range(self.median_ms.is_finite() && self.median_ms > 0.0, "median_ms", "above 0")?;
        range(self.p95_ms.is_finite() && self.p95_ms >= self.median_ms, "p95_ms", "no less than median_ms")?;
        range(self.recall.is_none_or(|recall| (0.0..=1.0).contains(&recall)), "recall", "0 to 1")
    }
}

/// Reads the rows of a file of JSON Lines; empty lines are skipped, unknown fields ignored.
///
/// # Errors
/// [`RowsError`] names the file and the first line that is no row; a file without a row is refused too.
pub fn read_rows(path: &Path) -> Result<Vec<ExtractionRow>, RowsError> {
    let failed = |cause| RowsError::Io { path: path.to_owned(), cause };
    let mut input = BufReader::new(File::open(path).map_err(failed)?);
    let mut rows = Vec::new();
    let mut text = Vec::new();
    for line in 1.. {
        text.clear();
        let length = input.by_ref().take(MAX_LINE_BYTES + 1).read_until(b'\n', &mut text).map_err(failed)?;
        if length == 0 {
            break;
        }
        if !text.trim_ascii().is_empty() {
            rows.push(parse(&text).map_err(|fault| RowsError::Line { path: path.to_owned(), line, fault })?);
        }
    }
    if rows.is_empty() { Err(RowsError::Empty { path: path.to_owned() }) } else { Ok(rows) }
}

fn parse(line: &[u8]) -> Result<ExtractionRow, RowFault> {
    if line.len() as u64 > MAX_LINE_BYTES {
        return Err(RowFault::TooLong);
    }
    let row: ExtractionRow = serde_json::from_slice(line)?;
    row.check()?;
    Ok(row)
}

/// Writes rows as JSON Lines.
///
/// # Errors
/// Whatever `out` reports.
pub fn write_rows<T: Serialize>(rows: &[T], mut out: impl Write) -> io::Result<()> {
    for row in rows {
        serde_json::to_writer(&mut out, row)?;
        out.write_all(b"\n")?;
    }
    out.flush()
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// A row with the fields that must be there.
    pub(crate) fn row(tool: &str, method: &str, mesh: &str, faces: u64, median_ms: f64) -> ExtractionRow {
        ExtractionRow {
            tool: tool.to_owned(),
            method: method.to_owned(),
            mesh: mesh.to_owned(),
            faces,
            edges: faces * 3 / 2,
            silhouette_edges: None,
            recall: None,
            views: 200,
            threads: 1,
            median_ms,
            p95_ms: median_ms * 1.5,
            edges_per_second: faces as f64 * 1.5 / median_ms * 1e3,
            prepare_ms: None,
            bytes: None,
            bytes_per_edge: None,
            faces_tested: None,
            edges_tested: None,
            nodes_visited: None,
            exact_fallbacks: None,
            machine: "a machine".to_owned(),
        }
    }

    fn read(text: &[u8]) -> Result<Vec<ExtractionRow>, RowsError> {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("rows.jsonl");
        std::fs::write(&path, text).unwrap();
        read_rows(&path)
    }

    #[test]
    fn rows_survive_a_file() {
        let full =
            ExtractionRow { recall: Some(0.5), bytes: Some(7), nodes_visited: Some(1.5), ..row("a", "b", "c", 4, 2.0) };
        let rows = [row(OURS, "brute-force", "a \"quoted\"\nmesh", 12, 0.1), full];
        let mut file = Vec::new();
        write_rows(&rows, &mut file).unwrap();
        assert_eq!(read(&file).unwrap(), rows);
    }

    #[test]
    fn what_a_tool_does_not_know_may_be_null_or_absent() {
        let line = r#"{"tool":"t","method":"m","mesh":"x","faces":4,"edges":6,"views":2,"threads":1,"median_ms":1,
            "p95_ms":1,"edges_per_second":6000,"bytes":null,"machine":"y","extra":[]}"#
            .replace('\n', "");
        let expected = ExtractionRow { p95_ms: 1.0, views: 2, machine: "y".to_owned(), ..row("t", "m", "x", 4, 1.0) };
        assert_eq!(read(format!("\n  \n{line}\r\n").as_bytes()).unwrap(), [expected]);
    }

    #[test]
    fn a_bad_line_is_named_with_its_file() {
        let line = |row: &ExtractionRow| serde_json::to_string(row).unwrap();
        let good = row("t", "m", "x", 4, 1.0);
        let bad = [
            ("nonsense".to_owned(), "expected"),
            (r#"{"tool":"t"}"#.to_owned(), "missing field"),
            (line(&ExtractionRow { faces: 0, ..good.clone() }), "faces must be at least 1"),
            (line(&ExtractionRow { median_ms: 0.0, ..good.clone() }), "median_ms must be above 0"),
            (line(&ExtractionRow { median_ms: f64::NAN, ..good.clone() }), "null"),
            (line(&ExtractionRow { p95_ms: 0.5, ..good.clone() }), "p95_ms"),
            (line(&ExtractionRow { recall: Some(1.5), ..good.clone() }), "recall"),
            (line(&ExtractionRow { method: " ".to_owned(), ..good.clone() }), "method must be a name"),
            (line(&good).replace(":1.0,", ":1e999,"), "out of range"),
            (" ".repeat(MAX_LINE_BYTES as usize) + "{}", "longer than"),
        ];
        for (text, expected) in bad {
            let message = read(format!("{}\n\n{text}\n", line(&good)).as_bytes()).unwrap_err().to_string();
            assert!(message.contains("rows.jsonl: line 3: ") && message.contains(expected), "{expected}: {message}");
        }
        assert!(matches!(read(b"\n"), Err(RowsError::Empty { .. })));
        assert!(read(b"\xff\n").is_err());
        assert!(matches!(read_rows("missing.jsonl".as_ref()), Err(RowsError::Io { .. })));
    }

    #[test]
    fn labels_distinguish_tools_and_threads() {
        let two = ExtractionRow { threads: 2, ..row("vtk", "filter", "x", 4, 1.0) };
        assert_eq!([row(OURS, "fast", "x", 4, 1.0).label(), two.label()], ["fast", "vtk: filter, 2 threads"]);
    }
}
