//! The report: a directory that opens offline and that other programs can read.
//!
//! | file | holds |
//! |---|---|
//! | `index.html` | charts, pictures and tables for people; asks nothing of the network |
//! | `results.jsonl` | one full [`Record`] a line |
//! | `results.csv` | the same, flat |
//! | `extraction.jsonl` | extraction times of this run and of peers, one [`ExtractionRow`] a line |
//! | `images/*.png` | what each method drew, the truth, the difference |
//! | `silhouettes-report.json` | the marker by which a later run knows that it may replace the directory |

mod chart;
mod extraction_chart;
mod page;
mod summary;

pub use chart::COLORS;
pub use summary::{CellSummary, MeshSummary, summarise};

use crate::record::Record;
use crate::result_directory::{DirectoryError, DirectoryKind, StagedDirectory};
use crate::runner::{Comparison, PictureSet};
use crate::scaling::{ExtractionRow, rows_of_records, write_rows};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// How reports are known.
const REPORT: DirectoryKind = DirectoryKind { noun: "report", marker: "silhouettes-report.json" };

/// Whether a report may be written to `directory`: nothing there, an empty directory, or an earlier report without any
/// file of somebody else's. Ask before a long run; [`write`](write()) asks again.
///
/// # Errors
/// [`DirectoryError`] says what is in the way.
pub fn check_target(directory: &Path) -> Result<(), DirectoryError> {
    REPORT.check_target(directory)
}

/// Why a report could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReportError {
    /// The directory could not be written.
    #[error(transparent)]
    Directory(#[from] DirectoryError),
    /// A file could not be read or written.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A picture could not be written.
    #[error(transparent)]
    Picture(#[from] silhouette_render::ImageError),
    /// The table could not be written.
    #[error("{}: {source}", path.display())]
    Table {
        /// The file.
        path: PathBuf,
        /// Why.
        source: csv::Error,
    },
    /// The page could not be made.
    #[error("index.html: {0}")]
    Page(#[from] minijinja::Error),
}

/// Writes the report of a comparison and yields the path of its page. The directory appears as a whole or not at all; one
/// that holds an earlier report is replaced.
///
/// # Errors
/// [`ReportError`]; whatever was at `directory` before is still there.
pub fn write(comparison: &Comparison, directory: &Path) -> Result<PathBuf, ReportError> {
    let mut staged = StagedDirectory::begin(directory, REPORT)?;
    write_jsonl(&comparison.records, &staged.file("results.jsonl")?)?;
    write_csv(&comparison.records, &staged.file("results.csv")?)?;
    let extractions = [rows_of_records(&comparison.records), comparison.peers.clone()].concat();
    write_extractions(&extractions, &staged.file("extraction.jsonl")?)?;
    for (index, set) in comparison.pictures.iter().enumerate() {
        for (name, picture) in picture_names(index, set).iter().zip([&set.drawn, &set.truth, &set.difference]) {
            picture.save_png(&staged.file(name)?)?;
        }
    }
    let page = page::render(comparison, &extractions)?;
    let path = staged.file("index.html")?;
    std::fs::write(&path, page).map_err(|source| ReportError::Io { path, source })?;
    staged.commit()?;
    Ok(directory.join("index.html"))
}

/// Paths of a set's pictures inside of the report. They hold no text of a user's.
fn picture_names(index: usize, set: &PictureSet) -> [String; 3] {
    ["drawn", "truth", "difference"].map(|what| format!("images/{index:03}-{}-{what}.png", set.method))
}

fn write_jsonl(records: &[Record], path: &Path) -> Result<(), ReportError> {
    let failed = |source| ReportError::Io { path: path.to_owned(), source };
    let mut out = BufWriter::new(std::fs::File::create(path).map_err(failed)?);
    for record in records {
        serde_json::to_writer(&mut out, record).map_err(|error| failed(error.into()))?;
        out.write_all(b"\n").map_err(failed)?;
    }
    out.flush().map_err(failed)
}

fn write_extractions(rows: &[ExtractionRow], path: &Path) -> Result<(), ReportError> {
    let file = std::fs::File::create(path);
    let written = file.and_then(|file| write_rows(rows, BufWriter::new(file)));
    written.map_err(|source| ReportError::Io { path: path.to_owned(), source })
}

fn write_csv(records: &[Record], path: &Path) -> Result<(), ReportError> {
    let failed = |source| ReportError::Table { path: path.to_owned(), source };
    let mut out = csv::Writer::from_path(path).map_err(failed)?;
    out.write_record(Record::columns()).map_err(failed)?;
    for record in records {
        out.write_record(record.row()).map_err(failed)?;
    }
    out.flush().map_err(|error| failed(error.into()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{Profile, tests as sample};
    use crate::scaling::{read_rows, row};
    use silhouette_render::Image;

    /// A comparison on a mesh whose name would break out of a page, a script or a table.
    pub(super) fn comparison() -> Comparison {
        let mesh = "</script><img src=x onerror=alert(1)>\",'\n{{ 7*7 }}";
        let picture = Image { width: 2, height: 2, rgba: vec![255; 16] };
        let set = |method: &str| PictureSet {
            mesh: mesh.to_owned(),
            method: method.to_owned(),
            options: String::new(),
            view: 0,
            drawn: picture.clone(),
            truth: picture.clone(),
            difference: picture.clone(),
        };
        Comparison {
            profile: Profile::Quick,
            run: sample::run(),
            methods: crate::registry::all().iter().collect(),
            records: vec![
                sample::record(mesh, "brute-force", 4.0, 0.25),
                sample::record(mesh, "image-precision", 2.0, 0.5),
            ],
            left_out: Vec::new(),
            pictures: vec![set("brute-force"), set("image-precision")],
            peers: (1..=4).map(|step| row("<b>peer", "m", mesh, step * 100, step as f64)).collect(),
        }
    }

    #[test]
    fn files_hold_every_record() {
        let dir = tempfile::tempdir().unwrap();
        let comparison = comparison();
        let page = write(&comparison, &dir.path().join("report")).unwrap();
        let folder = page.parent().unwrap();
        let lines = std::fs::read_to_string(folder.join("results.jsonl")).unwrap();
        let records: Vec<Record> = lines.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        assert_eq!(records, comparison.records);
        let extractions = read_rows(&folder.join("extraction.jsonl")).unwrap();
        assert_eq!(extractions[..2], rows_of_records(&comparison.records));
        assert_eq!(extractions[2..], comparison.peers);
        let mut table = csv::Reader::from_path(folder.join("results.csv")).unwrap();
        let rows: Vec<csv::StringRecord> = table.records().map(Result::unwrap).collect();
        assert_eq!((rows.len(), &rows[0][0]), (2, comparison.records[0].mesh.name.as_str()));
        assert!(folder.join("images/001-image-precision-difference.png").is_file());
    }

    #[test]
    fn a_second_report_replaces_the_first_and_leaves_nothing_behind() {
        let dir = tempfile::tempdir().unwrap();
        let target = dir.path().join("report");
        write(&comparison(), &target).unwrap();
        let mut smaller = comparison();
        smaller.records.truncate(1);
        smaller.pictures.truncate(1);
        write(&smaller, &target).unwrap();
        assert!(!target.join("images/001-image-precision-drawn.png").exists());
        assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1);
    }
}
