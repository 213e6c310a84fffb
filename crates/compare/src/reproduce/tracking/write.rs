//! The reproduction as files: a directory that appears as a whole.
//!
//! | file | holds |
//! |---|---|
//! | `index.html` | tables and chart for people; asks nothing of the network |
//! | `tables.jsonl` | every figure, one [`Figure`](crate::reproduce::Figure) a line |
//! | `trade.svg` | the chart |
//! | `silhouettes-reproduction.json` | the marker by which a later run knows that it may replace the directory |

use super::measure::Reproduction;
use super::rows::figures;
use super::{chart, page};
use crate::reproduce::write_figures;
use crate::result_directory::{DirectoryError, DirectoryKind, StagedDirectory};
use std::io;
use std::path::{Path, PathBuf};

/// How reproductions are known.
pub(in crate::reproduce) const REPRODUCTION: DirectoryKind =
    DirectoryKind { noun: "reproduction", marker: "silhouettes-reproduction.json" };

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
/// without any file of somebody else's. Ask before a long run; [`write`](write()) asks again.
///
/// # Errors
/// [`DirectoryError`] says what is in the way.
pub fn check_target(directory: &Path) -> Result<(), DirectoryError> {
    REPRODUCTION.check_target(directory)
}

/// Writes a reproduction and yields the path of its page. The directory appears as a whole or not at all; one that holds
/// an earlier reproduction is replaced.
///
/// # Errors
/// [`WriteError`]; whatever was at `directory` before is still there.
pub fn write(reproduction: &Reproduction, directory: &Path) -> Result<PathBuf, WriteError> {
    let mut staged = StagedDirectory::begin(directory, REPRODUCTION)?;
    let mut table = Vec::new();
    let path = staged.file("tables.jsonl")?;
    write_figures(&figures(reproduction), &mut table)
        .map_err(|source| WriteError::Io { path: path.clone(), source })?;
    let chart = chart::trade(reproduction);
    let page = page::render(reproduction, &chart)?;
    let trade = (staged.file("trade.svg")?, chart.into_bytes());
    for (path, bytes) in [(path, table), trade, (staged.file("index.html")?, page.into_bytes())] {
        std::fs::write(&path, bytes).map_err(|source| WriteError::Io { path, source })?;
    }
    staged.commit()?;
    Ok(directory.join("index.html"))
}

#[cfg(test)]
mod tests {
    use super::super::measure::tests::reproduction;
    use super::*;
    use crate::reproduce::{Figure, read_figures};

    #[test]
    fn files_hold_every_figure_and_replace_those_of_before() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("out");
        for _ in 0..2 {
            check_target(&target).unwrap();
            let page = write(reproduction(), &target).unwrap();
            assert_eq!(page, target.join("index.html"));
        }
        let read = read_figures(&std::fs::read(target.join("tables.jsonl")).unwrap()[..]).unwrap();
        let rows =
            |figures: &[Figure]| figures.iter().map(|figure| (figure.row.clone(), figure.paper)).collect::<Vec<_>>();
        assert_eq!(rows(&read), rows(&figures(reproduction())));
        assert!(read.iter().any(|figure| figure.ours.is_some()));
        let mut names: Vec<_> = target.read_dir().unwrap().map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        assert_eq!(names, ["index.html", "silhouettes-reproduction.json", "tables.jsonl", "trade.svg"]);
        assert_eq!(folder.path().read_dir().unwrap().count(), 1, "nothing is left beside it");
    }

    #[test]
    fn a_report_or_a_folder_of_somebody_else_is_not_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let theirs = folder.path().join("silhouettes-report.json");
        std::fs::write(&theirs, "{\"version\":\"1\",\"files\":[]}").unwrap();
        let refused = write(reproduction(), folder.path()).unwrap_err().to_string();
        assert!(refused.contains("is no reproduction of this program"), "{refused}");
        assert!(theirs.exists() && check_target(folder.path()).is_err());
    }
}
