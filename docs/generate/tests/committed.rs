//! The committed documentation is what the code and the committed results make.

use silhouette_compare::registry::Registry;
use silhouette_docs::{make, pictures, write};
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn committed_files_are_up_to_date() {
    for made in make(&root()).unwrap() {
        let lines = made.committed.lines().zip(made.made.lines());
        let first = lines.enumerate().find(|(_, (committed, made))| committed != made);
        assert!(
            made.is_up_to_date(),
            "cargo run -p silhouette-docs makes {} otherwise: {first:#?}",
            made.file.display()
        );
    }
}

#[test]
fn every_method_has_its_picture_and_no_other_is_there() {
    let mut wanted: Vec<String> = Registry::builtin().entries().iter().map(pictures::file).collect();
    let folder = fs::read_dir(root().join(pictures::FOLDER)).unwrap();
    let mut found: Vec<String> = folder.map(|file| file.unwrap().file_name().into_string().unwrap()).collect();
    wanted.sort();
    found.sort();
    assert_eq!(found, wanted, "cargo run -p silhouette-docs -- --pictures draws them");
}

/// A copy of what is read, so that it can be changed.
fn copy(folder: &Path) {
    let files = ["README.md", "docs/METHODS.md", silhouette_docs::line_errors::FILE, silhouette_docs::coherence::FILE];
    let times = fs::read_dir(root().join(silhouette_docs::extraction_times::FOLDER)).unwrap();
    let times = times.map(|file| Path::new(silhouette_docs::extraction_times::FOLDER).join(file.unwrap().file_name()));
    for file in files.into_iter().map(PathBuf::from).chain(times) {
        fs::create_dir_all(folder.join(&file).parent().unwrap()).unwrap();
        fs::copy(root().join(&file), folder.join(&file)).unwrap();
    }
}

#[test]
fn a_changed_table_a_changed_result_and_a_lost_mark_are_seen() {
    let folder = tempfile::tempdir().unwrap();
    let stale = || -> Vec<String> {
        let made = make(folder.path()).unwrap();
        let stale = made.into_iter().filter(|made| !made.is_up_to_date());
        stale.map(|made| made.file.file_name().unwrap().to_string_lossy().into_owned()).collect()
    };
    let edit = |file: &str, from: &str, to: &str| {
        let path = folder.path().join(file);
        let text = fs::read_to_string(&path).unwrap();
        assert!(text.contains(from), "{file} holds {from}");
        fs::write(path, text.replacen(from, to, 1)).unwrap();
    };
    copy(folder.path());
    assert_eq!(stale(), [] as [&str; 0]);
    // By hand, outside of the tables: nobody's business.
    edit("README.md", "# silhouettes", "# Silhouettes");
    assert_eq!(stale(), [] as [&str; 0]);
    edit("README.md", "Hall 2003, as its baseline", "Hall 2004");
    assert_eq!(stale(), ["README.md"]);
    assert_eq!(write(folder.path()).unwrap().len(), 1);
    assert_eq!(stale(), [] as [&str; 0], "written anew");
    edit(
        "docs/results/2026-11-22-amd-epyc-2-cores/extraction-ten-million.jsonl",
        "\"median_ms\":438.",
        "\"median_ms\":439.",
    );
    assert_eq!(stale(), ["METHODS.md"]);
    edit("docs/METHODS.md", "<!-- end: coherence -->", "");
    assert!(make(folder.path()).unwrap_err().to_string().contains("METHODS.md: 0 lines are '<!-- end: coherence -->'"));
}
