//! The files of a score, in the columns of a comparison.
//!
//! | file | holds |
//! |---|---|
//! | `results.jsonl` | one [`Cell`] on one line, its views nested in it; what nobody measured, such as times, is `null` |
//! | `results.csv` | one row per view, in the columns of a comparison's `results.csv`; what nobody measured is empty |
//! | `run.json` | the cameras, the files that were scored, this program and machine |
//! | `images/*.png` | of each view what was drawn, the truth, the difference |
//! | `silhouettes-score.json` | the marker by which a later run knows that it may replace the directory |

use super::cameras::CamerasDocument;
use super::score::ForeignScore;
use crate::machine::{describe_machine, describe_program};
use crate::record::Cell;
use crate::record::flat::Table;
use crate::result_directory::{DirectoryError, DirectoryKind, StagedDirectory};
use serde::Serialize;
use std::io;
use std::path::Path;

const SCORE: DirectoryKind = DirectoryKind { noun: "score", marker: "silhouettes-score.json" };

/// Columns that are not NaN where nobody measured, since they count.
const COUNTED: [&str; 2] = ["bytes_prepared", "frames"];

/// Whether a score may be written to `directory`: nothing there, an empty directory, or an earlier score without any file of
/// somebody else's.
///
/// # Errors
/// [`DirectoryError`] says what is in the way.
pub fn check_target(directory: &Path) -> Result<(), DirectoryError> {
    SCORE.check_target(directory)
}

/// Why a score could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ResultsError {
    /// The directory could not be written.
    #[error(transparent)]
    Directory(#[from] DirectoryError),
    /// What a file is to hold cannot be written down.
    #[error("{file}: {cause}")]
    Form {
        /// The file's name in the directory.
        file: String,
        /// Why.
        cause: io::Error,
    },
}

/// What a score comes from.
#[derive(Serialize)]
struct RunFile<'a> {
    files: &'a [String],
    program: String,
    machine: String,
    cameras: &'a CamerasDocument,
}

/// Writes the files. `files` names what was scored, one per view. The directory appears as a whole or not at all; one that holds
/// an earlier score is replaced.
///
/// # Errors
/// [`ResultsError`]; whatever was at `directory` before is still there.
pub fn write(
    directory: &Path,
    cell: &Cell,
    scores: &[ForeignScore],
    files: &[String],
    cameras: &CamerasDocument,
) -> Result<(), ResultsError> {
    let mut staged = StagedDirectory::begin(directory, SCORE)?;
    let run = RunFile { files, program: describe_program(), machine: describe_machine(), cameras };
    staged.write("run.json", &formed("run.json", lined(serde_json::to_vec_pretty(&run)))?)?;
    staged.write("results.jsonl", &formed("results.jsonl", lined(serde_json::to_vec(cell)))?)?;
    staged.write("results.csv", &formed("results.csv", csv_of(cell))?)?;
    for score in scores {
        for (what, picture) in ["drawn", "truth", "difference"].iter().zip(&score.pictures) {
            let name = format!("images/{:05}-{what}.png", score.view.frame);
            staged.write(&name, &formed(&name, picture.to_png().map_err(io::Error::other))?)?;
        }
    }
    Ok(staged.commit()?)
}

fn formed<T>(file: &str, contents: io::Result<T>) -> Result<T, ResultsError> {
    contents.map_err(|cause| ResultsError::Form { file: file.to_owned(), cause })
}

fn lined(text: serde_json::Result<Vec<u8>>) -> io::Result<Vec<u8>> {
    let mut text = text?;
    text.push(b'\n');
    Ok(text)
}

fn csv_of(cell: &Cell) -> io::Result<Vec<u8>> {
    let table = Table::of_views(std::slice::from_ref(cell));
    let is_counted: Vec<bool> = table.columns.iter().map(|column| COUNTED.contains(&column.as_str())).collect();
    let mut out = csv::Writer::from_writer(Vec::new());
    out.write_record(&table.columns)?;
    for row in &table.rows {
        let is_unmeasured = |(value, is_counted): (&String, &bool)| *is_counted || value == "NaN";
        out.write_record(row.iter().zip(&is_counted).map(|field| if is_unmeasured(field) { "" } else { field.0 }))?;
    }
    out.into_inner().map_err(csv::IntoInnerError::into_error)
}
