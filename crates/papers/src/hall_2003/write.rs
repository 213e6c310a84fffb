//! The reproduction as files, its chart as `trade.svg`. See [`files`](crate::files).

use super::measure::Reproduction;
use super::rows::figures;
use super::{chart, page};
use crate::files::{Files, WriteError};
use std::path::{Path, PathBuf};

/// Writes a reproduction and yields the path of its page. The directory appears as a whole or not at all; one that holds
/// an earlier reproduction is replaced.
///
/// # Errors
/// [`WriteError`]; whatever was at `directory` before is still there.
pub fn write(reproduction: &Reproduction, directory: &Path) -> Result<PathBuf, WriteError> {
    let chart = chart::trade(reproduction);
    let page = page::render(reproduction, &chart)?;
    Files { figures: figures(reproduction), chart: ("trade.svg", chart), page }.write(directory)
}

#[cfg(test)]
mod tests {
    use super::super::measure::tests::reproduction;
    use super::*;
    use crate::read_figures;

    #[test]
    fn every_figure_is_written() {
        let folder = tempfile::tempdir().unwrap();
        let page = write(reproduction(), folder.path()).unwrap();
        let read = read_figures(&std::fs::read(page.with_file_name("tables.jsonl")).unwrap()[..]).unwrap();
        assert_eq!(read.len(), figures(reproduction()).len());
        assert!(read.iter().any(|figure| figure.ours.is_some()));
    }
}
