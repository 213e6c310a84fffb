//! Step 1: criterion's files become [`Change`]s.

use serde::Deserialize;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// A benchmark, how long it takes, and how that changed.
#[derive(Debug, Clone, PartialEq)]
pub struct Change {
    /// Its name, as criterion prints it.
    pub name: String,
    /// Median of the last run in nanoseconds.
    pub now_ns: f64,
    /// The median over that of the run before; `None` of a benchmark that has run once.
    pub ratio: Option<Ratio>,
}

/// A ratio and how sure it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ratio {
    /// The ratio of the medians.
    pub median: f64,
    /// Its bootstrap interval, of the level that criterion was asked for.
    pub interval: [f64; 2],
}

/// Why criterion's files could not be read.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// A folder or a file could not be read.
    #[error("{}: {cause}; run cargo bench --bench kernels first", path.display())]
    File { path: PathBuf, cause: io::Error },
    /// A file is not what criterion writes.
    #[error("{}: {cause}", path.display())]
    Form { path: PathBuf, cause: serde_json::Error },
}

#[derive(Deserialize)]
struct Benchmark {
    full_id: String,
}

#[derive(Deserialize)]
struct Estimates {
    median: Estimate,
}

#[derive(Deserialize)]
struct Estimate {
    point_estimate: f64,
    confidence_interval: Interval,
}

#[derive(Deserialize)]
struct Interval {
    lower_bound: f64,
    upper_bound: f64,
}

/// Every benchmark below a folder, in the order of their folders' names.
///
/// # Errors
/// [`ReadError`], also where there is no such folder.
pub fn read(folder: &Path) -> Result<Vec<Change>, ReadError> {
    let mut found = Vec::new();
    visit(folder, &mut found)?;
    Ok(found)
}

/// Adds the benchmarks of a folder: it is one if it holds `new/benchmark.json`.
fn visit(folder: &Path, found: &mut Vec<Change>) -> Result<(), ReadError> {
    if folder.join("new/benchmark.json").is_file() {
        found.push(change(folder)?);
        return Ok(());
    }
    let failed = |cause| ReadError::File { path: folder.to_owned(), cause };
    let mut inner = Vec::new();
    for entry in fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.is_dir() {
            inner.push(path);
        }
    }
    inner.sort();
    inner.iter().try_for_each(|path| visit(path, found))
}

fn change(folder: &Path) -> Result<Change, ReadError> {
    let Benchmark { full_id } = json(&folder.join("new/benchmark.json"))?;
    let now: Estimates = json(&folder.join("new/estimates.json"))?;
    let file = folder.join("change/estimates.json");
    // Relative changes: 0 is none.
    let ratio = |Estimates { median }| Ratio {
        median: 1.0 + median.point_estimate,
        interval: [median.confidence_interval.lower_bound, median.confidence_interval.upper_bound].map(|end| 1.0 + end),
    };
    let ratio = if file.is_file() { Some(ratio(json(&file)?)) } else { None };
    Ok(Change { name: full_id, now_ns: now.median.point_estimate, ratio })
}

fn json<T: for<'a> Deserialize<'a>>(path: &Path) -> Result<T, ReadError> {
    let text = fs::read_to_string(path).map_err(|cause| ReadError::File { path: path.to_owned(), cause })?;
    serde_json::from_str(&text).map_err(|cause| ReadError::Form { path: path.to_owned(), cause })
}
