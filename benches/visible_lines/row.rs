//! Rows: ours as they are written, and what is read of other tools' rows.

use serde::{Deserialize, Serialize};
use std::io::{self, BufRead, Write};
use std::path::{Path, PathBuf};

/// What finding the lines of views of one mesh cost: one line of a JSON Lines file. Times are wall times in milliseconds.
#[derive(Debug, Clone, Serialize)]
pub struct LinesRow {
    /// This workspace.
    pub tool: &'static str,
    /// Name of the mesh: a file's name, or `builtin:NAME`.
    pub mesh: String,
    pub faces: u64,
    /// `visible`: visible silhouette and boundary edges; `all`: the hidden ones as well, with their invisibility; `outline`:
    /// the outline alone, in an orthographic view.
    pub metric: &'static str,
    /// How the finder was prepared: `plain`, or `many-views`, with a search tree for silhouette edges.
    pub finder: &'static str,
    /// `still`: the view that peers are given, again and again; `orbit`: views over a turn, each once.
    pub views: &'static str,
    /// Views timed.
    pub runs: u32,
    pub threads: u32,
    /// Of a view, preparation left out.
    pub median_ms: f64,
    pub p95_ms: f64,
    /// The first view after the preparation.
    pub first_ms: f64,
    /// All of the preparation, and of that the topology and the face tree.
    pub prepare_ms: f64,
    pub topology_ms: f64,
    pub tree_ms: f64,
    /// Bytes prepared, the mesh itself left out.
    pub prepared_bytes: u64,
    /// Medians of the stages.
    pub stages_ms: Stages,
    /// Medians of the counts.
    pub counts: Counts,
    /// Of the still view, or of the orbit's first.
    pub camera: CameraNumbers,
    /// Processor, threads and system.
    pub machine: String,
}

/// A value for each stage of a view.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Stages {
    pub extract: f64,
    pub project: f64,
    pub decide: f64,
    pub chain: f64,
}

/// What a view looked at and found.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Counts {
    pub edges: f64,
    pub contours: f64,
    pub pairs: f64,
    pub events: f64,
    pub sight_lines: f64,
    pub pieces: f64,
    pub chains: f64,
    pub points: f64,
    pub length_px: f64,
    /// What the outline encloses, in square pixels.
    pub area_px: f64,
}

/// A camera in numbers, in the mesh's coordinates.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CameraNumbers {
    pub eye: [f32; 3],
    pub target: [f32; 3],
    pub up: [f32; 3],
    /// In perspective.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fov_deg: Option<f64>,
    /// Object units that the viewport is high, in an orthographic view.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub height: Option<f64>,
    pub size: [u32; 2],
}

/// What a row of another tool says, as far as it is compared.
#[derive(Debug, Clone, Deserialize)]
pub struct PeerRow {
    pub tool: String,
    pub mesh: String,
    pub faces: u64,
    pub metric: String,
    pub median_ms: f64,
    pub threads: u32,
    /// What the outline encloses, where it is the metric.
    pub area_px: Option<f64>,
    #[serde(flatten)]
    pub camera: CameraNumbers,
}

/// Why the rows of another tool could not be read.
#[derive(Debug, thiserror::Error)]
pub enum PeersError {
    #[error("{}: {source}", path.display())]
    Io { path: PathBuf, source: io::Error },
    #[error("{}: line {line}: {source}", path.display())]
    Json { path: PathBuf, line: usize, source: serde_json::Error },
}

/// Rows of a file, empty lines left out.
pub fn read_peers(path: &Path) -> Result<Vec<PeerRow>, PeersError> {
    let io_error = |source| PeersError::Io { path: path.to_owned(), source };
    let file = io::BufReader::new(std::fs::File::open(path).map_err(io_error)?);
    let mut rows = Vec::new();
    for (index, line) in file.lines().enumerate() {
        let line = line.map_err(io_error)?;
        if !line.trim().is_empty() {
            let row = serde_json::from_str(&line);
            rows.push(row.map_err(|source| PeersError::Json { path: path.to_owned(), line: index + 1, source })?);
        }
    }
    Ok(rows)
}

/// Writes rows, a line each.
pub fn write_rows(rows: &[LinesRow], mut out: impl Write) -> io::Result<()> {
    for row in rows {
        serde_json::to_writer(&mut out, row)?;
        writeln!(out)?;
    }
    out.flush()
}
