//! The meshes in the folder that the environment variable `SILHOUETTES_MODELS` names.
//!
//! Files are read in the formats that `silhouette-core` is built with: a test crate turns on the features of the files in
//! its folder, or all of them.

use crate::skip::skipped;
use silhouette_core::TriangleMesh;
use silhouette_core::load::{Format, load};
use std::path::{Path, PathBuf};

/// The environment variable that names the folder.
pub const FOLDER: &str = "SILHOUETTES_MODELS";

/// The paths of all mesh files in the folder, sorted. If the variable is unset, none, and a line that says so. A folder without
/// a mesh is a mistake, and panics.
pub fn paths(test: &str) -> Vec<PathBuf> {
    let Some(folder) = folder(test) else { return Vec::new() };
    let entries = folder.read_dir().unwrap_or_else(|error| panic!("{FOLDER}={}: {error}", folder.display()));
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| Format::of(path).is_some());
    assert!(!paths.is_empty(), "{FOLDER}={}: no mesh in this folder", folder.display());
    paths.sort();
    paths
}

/// All meshes in the folder with the names of their files, in the order of their names, each loaded when it is asked for. If
/// the variable is unset, none, and a line that says so.
pub fn real_meshes(test: &str) -> impl Iterator<Item = (String, TriangleMesh)> {
    paths(test).into_iter().map(|path| (file_name(&path), read(&path)))
}

/// One mesh of the folder, by the name of its file. If the variable is unset or the folder lacks the file, `None`, and a line
/// that says so.
pub fn real_mesh(test: &str, name: &str) -> Option<TriangleMesh> {
    let path = folder(test)?.join(name);
    if path.is_file() {
        return Some(read(&path));
    }
    skipped(test, &format!("{} does not exist", path.display()));
    None
}

/// The name of a file, without its folder.
pub fn file_name(path: &Path) -> String {
    path.file_name().unwrap().to_string_lossy().into_owned()
}

fn folder(test: &str) -> Option<PathBuf> {
    let folder = std::env::var_os(FOLDER).map(PathBuf::from);
    if folder.is_none() {
        skipped(test, &format!("{FOLDER} names no folder of meshes"));
    }
    folder
}

fn read(path: &Path) -> TriangleMesh {
    load(path).unwrap_or_else(|error| panic!("{error}"))
}
