#![doc = include_str!("../README.md")]
//!
//! # Constants
//!
//! Each module holds the stages of one crate, one constant per file of the folder with the crate's name. A constant is a
//! complete WGSL module for `wgpu::ShaderSource::Wgsl`. [`ALL`] lists them with their paths.
//!
//! # Imports
//! A WGSL file imports others by lines of the form
//!
//! ```wgsl
//! #import "shared/camera.wgsl"
//! ```
//!
//! The path is relative to the folder `shaders/`. The build script puts each imported file in front of the file that imports
//! it, once, in the order of first import; it refuses circles, missing files and lines that only resemble an import. WGSL does
//! not depend on the order of declarations, so that a part may use what the importing file declares.
//!
//! A file that no other file imports is a *stage*; the others are parts. Parts that several crates use lie in `shared/`, those of
//! one crate in its folder. A stage begins with a comment, whose first paragraph documents its constant. `NAME.VARIANT.wgsl` is
//! a variant of a stage: its constant is `NAME_VARIANT`.
//!
//! The build script parses and validates the text of every stage with naga. A broken stage fails the build with its path and
//! naga's message, whose lines are those of the resolved text in the build script's output folder.
//!
//! # Twins
//! A stage shares its file stem (up to the first dot) with the Rust file that runs it or does the same on the CPU. The test that
//! compares the layout of a uniform lies beside its Rust struct and uses `layout` (feature of the same name).

#[cfg(test)]
mod build;
#[cfg(any(test, feature = "layout"))]
pub mod layout;

include!(concat!(env!("OUT_DIR"), "/stages.rs"));

#[cfg(test)]
mod tests {
    use super::{ALL, build};
    use std::collections::BTreeSet;
    use std::path::Path;

    /// File stems of all Rust files below a folder.
    fn rust_stems(folder: &Path) -> BTreeSet<String> {
        let mut stems = BTreeSet::new();
        for entry in folder.read_dir().unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                stems.extend(rust_stems(&path));
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                stems.insert(path.file_stem().unwrap().to_string_lossy().into_owned());
            }
        }
        stems
    }

    /// Stages without a Rust file of the same stem below the `src` of their crate.
    fn without_twin<'a>(paths: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
        let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().join("crates");
        let has_twin = |path: &str| {
            let (folder, file) = path.split_once('/').unwrap();
            let stem = file.split('.').next().unwrap();
            rust_stems(&crates.join(folder).join("src")).contains(stem)
        };
        paths.filter(|path| !has_twin(path)).collect()
    }

    #[test]
    fn every_stage_has_a_rust_twin() {
        assert_eq!(without_twin(ALL.iter().map(|(path, _)| *path)), Vec::<&str>::new());
        assert_eq!(without_twin(["render/no_such_stage.wgsl"].into_iter()), ["render/no_such_stage.wgsl"]);
    }

    #[test]
    fn the_list_holds_every_stage_on_disk_as_it_is() {
        let stages = build::stages::collect(Path::new(env!("CARGO_MANIFEST_DIR"))).unwrap();
        let on_disk: Vec<(&str, &str)> = stages.iter().map(|stage| (&*stage.path, &*stage.text)).collect();
        assert_eq!(on_disk, ALL);
        assert!(build::stages::rust_source(&stages).contains("pub mod render"));
    }

    #[test]
    fn every_stage_is_valid() {
        assert!(!ALL.is_empty());
        for (path, text) in ALL {
            assert_eq!(build::validate::validate(path, text, path), Ok(()));
        }
    }
}
