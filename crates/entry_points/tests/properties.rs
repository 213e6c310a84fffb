//! The entry points over their seeds, over changed seeds and over bytes that nobody wrote: what fuzzing does for hours, for seconds.

use proptest::prelude::*;
use silhouette_entry_points::{ALL, EntryPoint, seeds};
use silhouette_testing::Random;
use silhouette_testing::mutations::mutate;
use std::path::{Path, PathBuf};

/// Changed seeds per entry point; the variable `SILHOUETTES_MUTATIONS` overrides this.
const USUAL: usize = 400;

fn data(folder: &str, entry_point: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(folder).join(entry_point)
}

/// The files of a folder with their bytes, by name; none where there is no such folder.
fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let Ok(entries) = folder.read_dir() else { return Vec::new() };
    let mut files: Vec<_> = entries
        .map(|entry| entry.unwrap().path())
        .map(|path| (path.file_name().unwrap().to_str().unwrap().to_owned(), std::fs::read(&path).unwrap()))
        .collect();
    files.sort();
    files
}

/// What fuzzing begins with gets past the first checks, and stands in `data/seeds` as the code makes it.
#[test]
fn seeds_are_accepted_and_stand_in_their_folder() {
    for (name, entry_point) in ALL {
        let mut made = seeds::of(name);
        made.sort();
        let there = files(&data("seeds", name));
        let names = |seeds: &[(String, Vec<u8>)]| seeds.iter().map(|(seed, _)| seed.clone()).collect::<Vec<_>>();
        assert_eq!(names(&made), names(&there), "{name}: run the example write_seeds");
        for (one, other) in made.iter().zip(&there) {
            assert!(one == other, "{name}, {}: run the example write_seeds", one.0);
        }
        let refused: Vec<&str> =
            made.iter().filter(|(_, bytes)| !entry_point(bytes)).map(|(seed, _)| seed.as_str()).collect();
        // Those that are there to be refused.
        let expected: &[&str] = match name {
            "triangles" => &["no-such-vertex"],
            "drawing" => &["no-such-vertex", "nothing"],
            "text" => &["shape-wrong"],
            _ => &[],
        };
        assert_eq!(refused, expected, "{name}");
        assert!(made.iter().all(|(_, bytes)| bytes.len() < 4096), "{name}: seeds are small");
    }
}

/// Whatever once broke something.
#[test]
fn what_was_found_before_stays_mended() {
    for (name, entry_point) in ALL {
        for (_, bytes) in files(&data("regressions", name)) {
            entry_point(&bytes);
        }
    }
}

fn mutated(name: &str) {
    let count = std::env::var("SILHOUETTES_MUTATIONS").ok().and_then(|count| count.parse().ok()).unwrap_or(USUAL);
    let entry_point: EntryPoint = ALL.iter().find(|(other, _)| *other == name).unwrap().1;
    let good = seeds::of(name);
    let mut random = Random::new(11);
    let mut accepted = 0;
    for round in 0..count {
        let mut bytes = good[round % good.len()].1.clone();
        for _ in 0..=random.below(3) {
            mutate(&mut bytes, &mut random);
        }
        accepted += usize::from(entry_point(&bytes));
    }
    // Both happen, or the changes are too many or too few.
    assert!(accepted > count / 100 && accepted < count, "{name}: {accepted} of {count}");
}

#[test]
fn changed_mesh_files() {
    mutated("mesh_files");
}

#[test]
fn changed_textures() {
    mutated("siltex");
}

#[test]
fn changed_texts() {
    mutated("text");
}

#[test]
fn changed_triangles() {
    mutated("triangles");
}

#[test]
fn changed_drawings() {
    mutated("drawing");
}

#[test]
fn changed_foreign_drawings() {
    mutated("foreign");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn bytes_that_nobody_wrote(bytes in prop::collection::vec(any::<u8>(), 0..300), first in any::<prop::sample::Index>()) {
        for (name, entry_point) in ALL {
            entry_point(&bytes);
            // Behind the first byte of a seed, they get further.
            let good = seeds::of(name);
            let (_, seed) = &good[first.index(good.len())];
            entry_point(&[&seed[..seed.len().min(2)], &bytes[..]].concat());
        }
    }
}
