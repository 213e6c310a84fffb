//! What a mesh argument names: a file or a built-in shape, subdivided or not.

use silhouette_core::shapes::{ShapeError, by_name};
use silhouette_core::subdivide::{SubdivisionError, loop_subdivision};
use silhouette_core::{Topology, TriangleMesh, load};
use std::path::Path;

/// Before the number of levels. Neither a shell nor the name of a shape gives a meaning to `+`.
const LOOP: &str = "+loop";

/// Why there is no mesh.
#[derive(Debug, thiserror::Error)]
pub enum SourceError {
    #[error("{name}: {source}")]
    Shape { name: String, source: ShapeError },
    #[error(transparent)]
    Load(#[from] load::LoadError),
    #[error("{name}: {source}")]
    Subdivision { name: String, source: SubdivisionError },
}

/// The mesh that `PATH` or `builtin:NAME` names, Loop-subdivided N times where `+loopN` follows, and its name in rows: the
/// argument without the folder of a file.
pub fn load_mesh(argument: &str) -> Result<(String, TriangleMesh), SourceError> {
    let (source, levels) = split(argument);
    let builtin = source.strip_prefix("builtin:");
    let file_name = || Path::new(argument).file_name().map(|name| name.to_string_lossy().into_owned());
    let name = if builtin.is_some() { None } else { file_name() }.unwrap_or_else(|| argument.to_owned());
    let mesh = match builtin {
        Some(shape) => by_name(shape).map_err(|source| SourceError::Shape { name: name.clone(), source })?,
        None => load::load(Path::new(source))?,
    };
    match levels {
        None => Ok((name, mesh)),
        Some(levels) => match loop_subdivision(&mesh, &Topology::new(&mesh), levels) {
            Ok(fine) => Ok((name, fine)),
            Err(source) => Err(SourceError::Subdivision { name, source }),
        },
    }
}

/// The source, and the levels of subdivision behind it.
fn split(argument: &str) -> (&str, Option<u32>) {
    let levels = argument.rsplit_once(LOOP).and_then(|(source, levels)| Some((source, levels.parse().ok()?)));
    levels.map_or((argument, None), |(source, levels)| (source, Some(levels)))
}
