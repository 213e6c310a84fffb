//! What tables call a mesh.

use std::path::Path;

/// A file's name without folder and ending; the name of a built-in shape without the prefix.
pub fn mesh_label(name: &str) -> String {
    match name.strip_prefix("builtin:") {
        Some(shape) => shape.to_owned(),
        None => Path::new(name).file_stem().map_or_else(|| name.to_owned(), |stem| stem.to_string_lossy().into_owned()),
    }
}
