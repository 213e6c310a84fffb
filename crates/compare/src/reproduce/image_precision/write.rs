//! The reproduction as files: a directory that appears as a whole.
//!
//! | file | holds |
//! |---|---|
//! | `index.html` | tables and chart for people; asks nothing of the network |
//! | `tables.jsonl` | every figure, one [`Figure`](crate::reproduce::Figure) a line |
//! | `variants.svg` | the chart |
//! | `silhouettes-reproduction.json` | the marker by which a later run knows that it may replace the directory |

use super::measure::Reproduction;
use super::rows::figures;
use super::{chart, page};
use crate::reproduce::tracking::write::{REPRODUCTION, WriteError};
use crate::reproduce::write_figures;
use crate::result_directory::StagedDirectory;
use std::path::{Path, PathBuf};

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
    let chart = chart::variants(reproduction);
    let page = page::render(reproduction, &chart)?;
    let files = [
        (path, table),
        (staged.file("variants.svg")?, chart.into_bytes()),
        (staged.file("index.html")?, page.into_bytes()),
    ];
    for (path, bytes) in files {
        std::fs::write(&path, bytes).map_err(|source| WriteError::Io { path, source })?;
    }
    staged.commit()?;
    Ok(directory.join("index.html"))
}

#[cfg(test)]
mod tests {
    use super::super::measure::tests::reproduction;
    use super::*;
    use crate::reproduce::read_figures;

    #[test]
    fn files_hold_every_figure_and_replace_those_of_before() {
        let Some(reproduction) = reproduction() else { return };
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("out");
        for _ in 0..2 {
            assert_eq!(write(reproduction, &target).unwrap(), target.join("index.html"));
        }
        let read = read_figures(&std::fs::read(target.join("tables.jsonl")).unwrap()[..]).unwrap();
        assert_eq!(read.len(), figures(reproduction).len());
        let mut names: Vec<_> = target.read_dir().unwrap().map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        assert_eq!(names, ["index.html", "silhouettes-reproduction.json", "tables.jsonl", "variants.svg"]);
        assert_eq!(folder.path().read_dir().unwrap().count(), 1, "nothing is left beside it");
    }
}
