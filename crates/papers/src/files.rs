//! A reproduction as files: a directory that appears as a whole.
//!
//! | file | holds |
//! |---|---|
//! | `index.html` | tables and chart for people; asks nothing of the network |
//! | `tables.jsonl` | every figure, one [`Figure`] a line |
//! | `*.svg` | the chart |
//! | `silhouettes-reproduction.json` | the marker by which a later run knows that it may replace the directory |

use super::figure::{Figure, write_figures};
use silhouette_compare::result_directory::{DirectoryError, DirectoryKind, StagedDirectory};
use std::io;
use std::path::{Path, PathBuf};

/// How reproductions are known.
const REPRODUCTION: DirectoryKind = DirectoryKind { noun: "reproduction", marker: "silhouettes-reproduction.json" };

/// Why a reproduction could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum WriteError {
    /// The directory could not be written.
    #[error(transparent)]
    Directory(#[from] DirectoryError),
    /// A file could not be written.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The page could not be made.
    #[error("index.html: {0}")]
    Page(#[from] minijinja::Error),
}

/// Whether a reproduction may be written to `directory`: nothing there, an empty directory, or an earlier reproduction
/// without any file of somebody else's. Ask before a long run; writing asks again.
///
/// # Errors
/// [`DirectoryError`] says what is in the way.
pub fn check_target(directory: &Path) -> Result<(), DirectoryError> {
    REPRODUCTION.check_target(directory)
}

/// What a reproduction consists of.
pub(super) struct Files {
    /// Every figure.
    pub figures: Vec<Figure>,
    /// What the chart is called, and the chart.
    pub chart: (&'static str, String),
    /// The page.
    pub page: String,
}

impl Files {
    /// Writes them and yields the path of the page. The directory appears as a whole or not at all; one that holds an
    /// earlier reproduction is replaced.
    ///
    /// # Errors
    /// [`WriteError`]; whatever was at `directory` before is still there.
    pub fn write(self, directory: &Path) -> Result<PathBuf, WriteError> {
        let mut staged = StagedDirectory::begin(directory, REPRODUCTION)?;
        let mut table = Vec::new();
        let written = write_figures(&self.figures, &mut table);
        written.map_err(|source| WriteError::Io { path: directory.join(TABLES), source })?;
        let (chart_name, chart) = self.chart;
        for (name, bytes) in [(TABLES, table), (chart_name, chart.into_bytes()), (PAGE, self.page.into_bytes())] {
            let path = staged.file(name)?;
            std::fs::write(&path, bytes).map_err(|source| WriteError::Io { path, source })?;
        }
        staged.commit()?;
        Ok(directory.join(PAGE))
    }
}

const TABLES: &str = "tables.jsonl";
const PAGE: &str = "index.html";

#[cfg(test)]
mod tests {
    use super::super::figure::read_figures;
    use super::*;

    fn files(ours: f64) -> Files {
        let text = String::new;
        let figure = Figure {
            method: text(),
            table: text(),
            row: text(),
            metric: text(),
            unit: text(),
            paper: None,
            ours: Some(ours),
            comparable: true,
            note: text(),
        };
        Files { figures: vec![figure], chart: ("chart.svg", "<svg/>".to_owned()), page: "<html>".to_owned() }
    }

    #[test]
    fn files_hold_every_figure_and_replace_those_of_before() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("out");
        for ours in [1.0, 2.0] {
            check_target(&target).unwrap();
            assert_eq!(files(ours).write(&target).unwrap(), target.join("index.html"));
            let read = read_figures(&std::fs::read(target.join("tables.jsonl")).unwrap()[..]).unwrap();
            assert_eq!(read.iter().map(|figure| figure.ours).collect::<Vec<_>>(), [Some(ours)]);
        }
        let mut names: Vec<_> = target.read_dir().unwrap().map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        assert_eq!(names, ["chart.svg", "index.html", "silhouettes-reproduction.json", "tables.jsonl"]);
        assert_eq!(folder.path().read_dir().unwrap().count(), 1, "nothing is left beside it");
    }

    #[test]
    fn a_report_or_a_folder_of_somebody_else_is_not_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let theirs = folder.path().join("silhouettes-report.json");
        std::fs::write(&theirs, "{\"version\":\"1\",\"files\":[]}").unwrap();
        let refused = files(1.0).write(folder.path()).unwrap_err().to_string();
        assert!(refused.contains("is no reproduction of this program"), "{refused}");
        assert!(theirs.exists() && check_target(folder.path()).is_err());
    }
}
