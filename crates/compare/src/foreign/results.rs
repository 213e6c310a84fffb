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
use crate::result_directory::{DirectoryError, DirectoryKind, StagedDirectory, WriteError, formed};
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
/// [`WriteError`]; whatever was at `directory` before is still there.
pub fn write(
    directory: &Path,
    cell: &Cell,
    scores: &[ForeignScore],
    files: &[String],
    cameras: &CamerasDocument,
) -> Result<(), WriteError> {
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

fn lined(text: serde_json::Result<Vec<u8>>) -> io::Result<Vec<u8>> {
    let mut text = text?;
    text.push(b'\n');
    Ok(text)
}

fn csv_of(cell: &Cell) -> io::Result<Vec<u8>> {
    let mut table = Table::of_views(std::slice::from_ref(cell));
    for row in &mut table.rows {
        for (value, column) in row.iter_mut().zip(&table.columns) {
            if value == "NaN" || COUNTED.contains(&column.as_str()) {
                value.clear();
            }
        }
    }
    table.to_csv()
}
