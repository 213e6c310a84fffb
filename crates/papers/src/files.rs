//! A reproduction as files: a directory that appears as a whole.
//!
//! | file | holds |
//! |---|---|
//! | `index.html` | tables and charts for people; asks nothing of the network |
//! | `tables.jsonl` | every [figure](crate::figure), one per line |
//! | `tables.csv` | the same for spreadsheets and data frames |
//! | `*.svg` | the charts |
//! | `*.png` | the pictures |
//! | `silhouettes-reproduction.json` | marks the directory as one that a later run may replace |

use crate::figure::{figures, write_figures, write_figures_csv};
use crate::page;
use crate::paper::Reproduction;
use silhouette_compare::result_directory::{DirectoryError, DirectoryKind, StagedDirectory, WriteError, formed};
use std::io;
use std::path::{Path, PathBuf};

/// How directories of reproductions are recognised.
const REPRODUCTION: DirectoryKind = DirectoryKind { noun: "reproduction", marker: "silhouettes-reproduction.json" };

const TABLES: &str = "tables.jsonl";
const SHEET: &str = "tables.csv";
const PAGE: &str = "index.html";

/// Whether a reproduction may be written to `directory`: nothing is there, an empty directory, or an earlier reproduction
/// without any file of somebody else's. Ask before a long run; writing asks again.
///
/// # Errors
/// [`DirectoryError`] says what is in the way.
pub fn check_target(directory: &Path) -> Result<(), DirectoryError> {
    REPRODUCTION.check_target(directory)
}

/// Writes all files and yields the path of the page. The directory appears as a whole or not at all; one that holds an
/// earlier reproduction is replaced.
///
/// # Errors
/// [`WriteError`]; what was at `directory` before is still there.
pub fn write(reproduction: &Reproduction, directory: &Path) -> Result<PathBuf, WriteError> {
    let mut staged = StagedDirectory::begin(directory, REPRODUCTION)?;
    let mut table = Vec::new();
    let measured = &reproduction.measured;
    let figures = figures(reproduction.paper.name, &measured.tables);
    formed(TABLES, write_figures(&figures, &mut table))?;
    staged.write(TABLES, &table)?;
    let mut sheet = Vec::new();
    formed(SHEET, write_figures_csv(&figures, &mut sheet))?;
    staged.write(SHEET, &sheet)?;
    for chart in &measured.charts {
        staged.write(chart.file_name, chart.svg.as_bytes())?;
    }
    for picture in &measured.pictures {
        let name = picture.file_name;
        staged.write(name, &formed(name, picture.image.to_png().map_err(io::Error::other))?)?;
    }
    staged.write(PAGE, formed(PAGE, page::render(reproduction).map_err(io::Error::other))?.as_bytes())?;
    staged.commit()?;
    Ok(directory.join(PAGE))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paper::tests::reproduction;

    #[test]
    fn files_hold_every_figure_and_replace_those_of_before() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("out");
        for rows in [2, 1] {
            check_target(&target).unwrap();
            let mut reproduction = reproduction();
            reproduction.measured.tables[0].rows.truncate(rows);
            assert_eq!(write(&reproduction, &target).unwrap(), target.join("index.html"));
            let lines = std::fs::read_to_string(target.join("tables.jsonl")).unwrap();
            let count = figures("", &reproduction.measured.tables).len();
            assert_eq!(lines.lines().count(), count);
            assert_eq!(csv::Reader::from_path(target.join("tables.csv")).unwrap().records().count(), count);
        }
        let mut names: Vec<_> = target.read_dir().unwrap().map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        let expected =
            ["chart.svg", "index.html", "picture.png", "silhouettes-reproduction.json", "tables.csv", "tables.jsonl"];
        assert_eq!(names, expected);
        assert_eq!(folder.path().read_dir().unwrap().count(), 1, "nothing is left beside it");
    }

    #[test]
    fn a_report_or_a_folder_of_somebody_else_is_not_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let theirs = folder.path().join("silhouettes-report.json");
        std::fs::write(&theirs, "{\"version\":\"1\",\"files\":[]}").unwrap();
        let refused = write(&reproduction(), folder.path()).unwrap_err().to_string();
        assert!(refused.contains("is no reproduction of this program"), "{refused}");
        assert!(theirs.exists() && check_target(folder.path()).is_err());
    }
}
