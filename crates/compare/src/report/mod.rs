//! The report: a directory that opens offline and that other programs can read.
//!
//! | file | holds |
//! |---|---|
//! | `index.html` | charts, pictures and tables for people; asks nothing of the network |
//! | `run.json` | the scene, which methods refused which mesh, and the runs, each with machine, adapter and program: what all results have in common |
//! | `results.jsonl` | one [`Cell`](crate::record::Cell) per line, its scored frames nested in it |
//! | `results.csv` | the same as a [flat table](crate::record::flat): one row per scored frame, one column per option |
//! | `cells.csv` | one row per cell: medians of times and means of metrics, each with the ends of its 95 % [interval](crate::interval) |
//! | `extraction.jsonl` | extraction times of this run and of peers, one [`ExtractionRow`](crate::scaling::ExtractionRow) per line |
//! | `images/*.png` | what each cell drew, the truth, the difference |
//! | `silhouettes-report.json` | the marker by which a later run knows that it may replace the directory |

mod answer;
mod chart;
mod coherence_table;
mod evidence;
mod extraction_chart;
mod measure;
mod page;
mod pictures;
mod published;
mod sphere_map;
mod summary;
mod tables;
mod text;
mod where_it_errs;

pub use chart::COLORS;
pub use where_it_errs::sentence;

use crate::machine::RunDescription;
use crate::record::flat::Table;
use crate::result_directory::{DirectoryError, DirectoryKind, StagedDirectory, WriteError, formed};
use crate::runner::{Comparison, LeftOut};
use crate::scaling::{rows_of_cells, write_rows};
use crate::scene::Scene;
use pictures::PictureFiles;
use serde::Serialize;
use std::io;
use std::path::{Path, PathBuf};

const PAGE: &str = "index.html";

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

/// Writes the report of a comparison and yields the path of its page. The directory appears as a whole or not at all; one
/// that holds an earlier report is replaced.
///
/// # Errors
/// [`WriteError`]; whatever was at `directory` before is still there.
pub fn write(comparison: &Comparison, directory: &Path) -> Result<PathBuf, WriteError> {
    let mut staged = StagedDirectory::begin(directory, REPORT)?;
    staged.write("run.json", &formed("run.json", run_file(comparison))?)?;
    staged.write("results.jsonl", &formed("results.jsonl", rows(&comparison.cells))?)?;
    staged.write("results.csv", &formed("results.csv", Table::of_views(&comparison.cells).to_csv())?)?;
    staged.write("cells.csv", &formed("cells.csv", Table::of_cells(&comparison.cells).to_csv())?)?;
    let own = rows_of_cells(&comparison.cells, &comparison.runs);
    let extractions = [own, comparison.peers.clone()].concat();
    staged.write("extraction.jsonl", &formed("extraction.jsonl", rows(&extractions))?)?;
    let pictures = PictureFiles::of(&comparison.pictures);
    for (name, picture) in &pictures.files {
        staged.write(name, &formed(name, picture.to_png().map_err(io::Error::other))?)?;
    }
    let page = page::render(comparison, &pictures, &extractions).map_err(io::Error::other);
    staged.write(PAGE, formed(PAGE, page)?.as_bytes())?;
    staged.commit()?;
    Ok(directory.join(PAGE))
}

/// What all results of a run have in common.
#[derive(Serialize)]
struct RunFile<'a> {
    scene: &'a Scene,
    runs: &'a [RunDescription],
    left_out: &'a [LeftOut],
}

fn run_file(comparison: &Comparison) -> io::Result<Vec<u8>> {
    let Comparison { scene, runs, left_out, .. } = comparison;
    let mut text = serde_json::to_vec_pretty(&RunFile { scene, runs, left_out })?;
    text.push(b'\n');
    Ok(text)
}

fn rows<T: Serialize>(rows: &[T]) -> io::Result<Vec<u8>> {
    let mut text = Vec::new();
    write_rows(rows, &mut text)?;
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::PictureKind;
    use crate::options::OptionSettings;
    use crate::record::Cell;
    use crate::record::tests as sample;
    use crate::runner::PictureSet;
    use crate::scaling::{read_rows, row};
    use crate::scene::Profile;
    use silhouette_render::Image;

    /// A comparison on a mesh whose name would break out of a page, a script or a table.
    pub(super) fn comparison() -> Comparison {
        let mesh = "</script><img src=x onerror=alert(1)>\",'\n{{ 7*7 }}";
        let picture = |value: u8| Image { width: 2, height: 2, rgba: vec![value; 16] };
        let set = |(index, cell): (usize, &Cell)| PictureSet {
            mesh: mesh.to_owned(),
            method: cell.method.clone(),
            options: OptionSettings::default(),
            picture: PictureKind::Lines,
            frame: 5,
            drawn: picture(index as u8),
            truth: picture(100),
            difference: picture(200 + index as u8),
        };
        let cells = vec![
            sample::cell(mesh, "brute-force", 4.0, 0.25),
            sample::cell(mesh, "image-precision", 2.0, 0.5),
            sample::fill_cell(mesh, "fine-mesh", 2.0, 0.5),
        ];
        Comparison {
            scene: Profile::Quick.scene(),
            runs: vec![sample::run()],
            methods: crate::registry::Registry::builtin().entries().to_vec(),
            left_out: Vec::new(),
            pictures: cells.iter().enumerate().map(set).collect(),
            cells,
            peers: (1..=4).map(|step| row("<b>peer", "m", mesh, step * 100, step as f64)).collect(),
        }
    }

    #[test]
    fn files_hold_every_cell_and_what_they_have_in_common_once() {
        let dir = tempfile::tempdir().unwrap();
        let comparison = comparison();
        let page = write(&comparison, &dir.path().join("report")).unwrap();
        let folder = page.parent().unwrap();
        let read = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
        let lines = read("results.jsonl");
        let cells: Vec<Cell> = lines.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        assert_eq!(cells, comparison.cells);
        let extractions = read_rows(&folder.join("extraction.jsonl")).unwrap();
        let own = rows_of_cells(&comparison.cells, &comparison.runs);
        assert_eq!(extractions, [own, comparison.peers.clone()].concat());
        let mut table = csv::Reader::from_path(folder.join("results.csv")).unwrap();
        let rows: Vec<csv::StringRecord> = table.records().map(Result::unwrap).collect();
        assert_eq!((rows.len(), &rows[0][0]), (3, comparison.cells[0].mesh.name.as_str()));
        assert!(folder.join("images/001-image-precision-difference.png").is_file());
        assert!(!folder.join("images/001-image-precision-truth.png").exists(), "the truth is written once");
        // The machine is stated once.
        let run: serde_json::Value = serde_json::from_str(&read("run.json")).unwrap();
        assert_eq!((&run["runs"][0]["cpu"], &run["scene"]["path"]["frames"]), (&"a <processor>".into(), &30.into()));
        assert!([lines, read("results.csv")].iter().all(|text| !text.contains("a <processor>")));
    }

    #[test]
    fn a_second_report_replaces_the_first_and_leaves_nothing_behind() {
        let dir = tempfile::tempdir().unwrap();
        let target = dir.path().join("report");
        write(&comparison(), &target).unwrap();
        let mut smaller = comparison();
        smaller.cells.truncate(1);
        smaller.pictures.truncate(1);
        write(&smaller, &target).unwrap();
        assert!(!target.join("images/001-image-precision-drawn.png").exists());
        assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1);
    }
}
