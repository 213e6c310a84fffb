//! Meshes named on the command line: files, or `builtin:NAME`.

use crate::failure::Failure;
use silhouette_compare::runner::NamedMesh;
use silhouette_core::{PreparedMesh, Progress, TriangleMesh, load, shapes};
use std::path::Path;
use std::sync::Arc;

/// What built-in shapes are called by.
const BUILTIN: &str = "builtin:";

/// Loads a file or generates a built-in shape.
pub fn mesh(argument: &str, progress: &dyn Progress) -> Result<NamedMesh, Failure> {
    let named =
        |name: &str, mesh: TriangleMesh| NamedMesh { name: name.to_owned(), mesh: Arc::new(PreparedMesh::new(mesh)) };
    if let Some(shape) = argument.strip_prefix(BUILTIN) {
        let mesh = shapes::by_name(shape).map_err(|error| Failure::Input(format!("{argument}: {error}")))?;
        return Ok(named(argument, mesh));
    }
    let path = Path::new(argument);
    let mesh = load::load_with_progress(path, progress)?;
    let name = path.file_name().map_or_else(|| argument.to_owned(), |name| name.to_string_lossy().into_owned());
    Ok(named(&name, mesh))
}
