//! Files become a [`TriangleMesh`]: OBJ, PLY, OFF, STL and glTF, each behind the cargo feature of its name.
//!
//! | format | vertex ids | read |
//! |---|---|---|
//! | OBJ | `v` rows | `v`, `f`, `usemtl`, `o`, `g`, `s`, `l`; groups and objects never renumber |
//! | PLY | rows of `vertex` | text and binary; `face`, `tristrips` |
//! | OFF | vertex rows | text; `[ST][C][N]OFF` |
//! | STL | equal positions joined, in order of appearance | text and binary |
//! | glTF | primitives one after another, in the order of the scene | text and GLB; node transforms, instances, morph targets and skins applied; hard edges |
//!
//! Applications that have loaded their scene with `tobj` make it a mesh by `TriangleMesh::from_tobj`, cargo feature `tobj`.
//!
//! Unreferenced vertices are kept. Convex polygons are fanned from their first corner, other simple polygons are cut into
//! triangles that cover them once, seen along their normal; so no corner is lost, and neighbours still share their edges.
//! Faces of one or two corners are left out. Texture and normal seams never split a vertex. Coordinates are rounded once, correctly, to
//! 32-bit floats, in the file's own units. A mesh farther from zero than 64 times its extent is read a second time in 64 bits, and its
//! positions count from an [origin](crate::origin) close to it; what 32 bits do not hold even so is noted. [`load_labelled`]
//! reports which faces share a material and group (OBJ's `usemtl` and `g`, glTF's materials), what parts are called (OBJ's `o` and `g`, glTF's nodes), and which edges are sharp
//! (OBJ's `s` and `l`, glTF's `EXT_mesh_primitive_edge_visibility`); everything else that a vertex or face carries (normals, colours) is passed over. To join coincident vertices see [`crate::weld`].
//!
//! Lines may end in `\n`, `\r\n` or `\r`. Where a format gives lines no meaning (OFF, text PLY, text STL), rows may be broken or
//! share lines. What is odd about a file that is read all the same, [`load_labelled`] reports as [`Note`]s.
//!
//! Bad files are refused with a [`LoadError`] that names the place and the remedy. A header's promise alone never takes
//! memory: it is bounded by the bytes that are there.
//!
//! | format | memory, for a file of n bytes | time |
//! |---|---|---|
//! | OBJ, PLY, OFF, STL | at most 4 KiB + 256 n, the file itself besides; the usual file takes 1 to 2 n | O(n), concave polygons as below |
//! | glTF | its buffers, and a mesh of at most 16 n + 256 MiB: a document may place one mesh, or read one accessor, many times | O(n + mesh) |
//!
//! What would take more is refused before memory is taken for it. [`load_labelled_within`] bounds n, by which all of this is bounded.
//! A [`Progress`] is asked every 256 KiB, those of a glTF document of many values included, and between placed meshes.
//!
//! Cost: O(bytes), one pass (a second one where rows are broken; for a concave polygon of n corners O(n log n) in most
//! cases, bounded by 1024 steps per corner), 150 MB/s of text or more on one core (350 MB/s of short OBJ rows).

#![cfg_attr(
    not(all(feature = "obj", feature = "ply", feature = "off", feature = "stl", feature = "gltf")),
    allow(dead_code, reason = "the readers share their parts; with a format switched off some have no user")
)]

mod assembly;
mod concave;
mod error;
#[cfg(feature = "obj")]
mod feature_edges;
mod format;
#[cfg(feature = "tobj")]
mod from_tobj;
#[cfg(feature = "gltf")]
mod gltf;
mod lines;
mod notes;
#[cfg(feature = "obj")]
mod obj;
#[cfg(feature = "off")]
mod off;
mod parts;
mod placing;
#[cfg(feature = "ply")]
mod ply;
mod polygon;
#[cfg(any(feature = "ply", feature = "off"))]
mod rows;
mod steps;
#[cfg(feature = "stl")]
mod stl;

pub use assembly::LabelledMesh;
pub use error::{LoadError, OneLine, Place, Problem};
pub use format::Format;
#[cfg(feature = "tobj")]
pub use from_tobj::FromTobjError;
pub use notes::Note;
pub use parts::{Part, Parts};

use self::error::Located;
use self::placing::{MOST_ATTEMPTS, Placing};
use self::steps::Steps;
use crate::mesh::TriangleMesh;
use crate::progress::{NoProgress, Progress};
use std::fs::File;
use std::io::{self, Read as _};
use std::path::Path;

/// Loads a mesh from a file of the format that its extension names.
///
/// # Errors
/// [`LoadError`], one line that names the file, the place and the remedy.
pub fn load(path: &Path) -> Result<TriangleMesh, LoadError> {
    load_with_progress(path, &NoProgress)
}

/// Like [`load`], but reports the bytes read and parsed to `progress` and stops when it asks to.
///
/// # Errors
/// [`LoadError`]; [`LoadError::is_cancelled`] distinguishes a stop from a bad file.
pub fn load_with_progress(path: &Path, progress: &dyn Progress) -> Result<TriangleMesh, LoadError> {
    load_labelled(path, progress).map(|labelled| labelled.mesh)
}

/// Like [`load_with_progress`], with labels for the faces that share a material and group, and with feature edges.
///
/// # Errors
/// [`LoadError`] as for [`load_with_progress`].
pub fn load_labelled(path: &Path, progress: &dyn Progress) -> Result<LabelledMesh, LoadError> {
    load_labelled_within(path, u64::MAX, progress)
}

/// Like [`load_labelled`], but refuses a file of more than `most_bytes`, before it is read: with the files beside it that it names,
/// and the buffers that it holds as text. By the table of the module, that bounds memory as well.
///
/// # Errors
/// [`LoadError`] as for [`load_with_progress`]; [`Problem::TooLong`].
pub fn load_labelled_within(path: &Path, most_bytes: u64, progress: &dyn Progress) -> Result<LabelledMesh, LoadError> {
    let load = || {
        let Some(format) = Format::of(path) else {
            if path.is_dir() {
                return Err(Problem::Directory.into());
            }
            let extension = path.extension().unwrap_or_default().to_string_lossy().into_owned();
            return Err(Problem::UnknownExtension { extension }.into());
        };
        let bytes = read_file(path, most_bytes, progress)?;
        let left = most_bytes - bytes.len() as u64;
        read_beside(format, &bytes, Beside { folder: path.parent(), most_bytes: left }, progress)
    };
    load().map_err(|located: Located| located.in_file(path))
}

/// Reads a mesh from bytes in memory; `name` stands for the file in messages. The file system is not touched, so glTF
/// must carry its buffers within.
///
/// # Errors
/// [`LoadError`] as for [`load_with_progress`].
pub fn read(format: Format, name: &str, bytes: &[u8], progress: &dyn Progress) -> Result<TriangleMesh, LoadError> {
    read_labelled(format, name, bytes, progress).map(|labelled| labelled.mesh)
}

/// Like [`read()`], with labels for the faces that share a material and group, and with feature edges.
///
/// # Errors
/// [`LoadError`] as for [`load_with_progress`].
pub fn read_labelled(
    format: Format,
    name: &str,
    bytes: &[u8],
    progress: &dyn Progress,
) -> Result<LabelledMesh, LoadError> {
    read_beside(format, bytes, Beside { folder: None, most_bytes: u64::MAX }, progress)
        .map_err(|located| located.in_file(Path::new(name)))
}

/// Where a mesh's neighbour files lie.
#[derive(Debug, Clone, Copy)]
struct Beside<'a> {
    /// `None` if none may be read.
    folder: Option<&'a Path>,
    /// Most bytes of them all.
    #[cfg_attr(not(feature = "gltf"), expect(dead_code, reason = "only glTF has neighbour files"))]
    most_bytes: u64,
}

/// Reads a mesh, with its neighbour files if it has any.
fn read_beside(
    format: Format,
    bytes: &[u8],
    beside: Beside<'_>,
    progress: &dyn Progress,
) -> Result<LabelledMesh, Located> {
    progress.check()?;
    if bytes.is_empty() {
        return Err(Problem::Empty.into());
    }
    let mut placing = Placing::NARROW;
    for _ in 1..MOST_ATTEMPTS {
        let labelled = read_once(format, bytes, beside, placing, progress)?;
        match placing.better(&labelled.mesh) {
            // What was read is dropped before the file is read anew.
            Some(better) => placing = better,
            None => return Ok(labelled),
        }
    }
    read_once(format, bytes, beside, placing, progress)
}

/// Reads a mesh with positions that are made as `placing` says.
fn read_once(
    format: Format,
    bytes: &[u8],
    #[cfg_attr(not(feature = "gltf"), expect(unused_variables, reason = "only glTF has neighbour files"))]
    beside: Beside<'_>,
    #[cfg_attr(
        not(any(feature = "obj", feature = "ply", feature = "off", feature = "stl", feature = "gltf")),
        expect(unused_variables, reason = "without a format nothing is read")
    )]
    placing: Placing,
    progress: &dyn Progress,
) -> Result<LabelledMesh, Located> {
    let mut steps = Steps::begin(progress, "parsing", bytes.len());
    let read: Result<LabelledMesh, Located> = match format {
        #[cfg(feature = "obj")]
        Format::Obj => obj::read(bytes, placing, &mut steps),
        #[cfg(feature = "ply")]
        Format::Ply => ply::read(bytes, placing, &mut steps),
        #[cfg(feature = "off")]
        Format::Off => off::read(bytes, placing, &mut steps),
        #[cfg(feature = "stl")]
        Format::Stl => stl::read(bytes, placing, &mut steps),
        #[cfg(feature = "gltf")]
        Format::Gltf => {
            // Parsed as one, and assembled in a stage of its own.
            steps.report(bytes.len())?;
            return gltf::read(bytes, beside, placing, progress);
        }
        #[cfg(not(all(feature = "obj", feature = "ply", feature = "off", feature = "stl", feature = "gltf")))]
        format => Err(Problem::FeatureOff { format }.into()),
    };
    let labelled = read?;
    steps.report(bytes.len())?;
    Ok(labelled)
}

/// Bytes read from a file at a time: large enough that the system call costs nothing, small enough to stop at.
const READ_AT_ONCE: u64 = 8 * 1024 * 1024;

/// The whole file, if it is not too long.
fn read_file(path: &Path, most_bytes: u64, progress: &dyn Progress) -> Result<Vec<u8>, Located> {
    let refused = |error: io::Error| match error.kind() {
        io::ErrorKind::NotFound => Problem::Missing,
        io::ErrorKind::IsADirectory => Problem::Directory,
        _ => Problem::Io(error),
    };
    // Asked before opening: to open a pipe is to wait for its writer, and a device may never end.
    let metadata = std::fs::metadata(path).map_err(refused)?;
    if metadata.is_dir() {
        return Err(Problem::Directory.into());
    }
    if !metadata.is_file() {
        return Err(Problem::NoRegularFile.into());
    }
    let too_long = |found: u64| Located::from(Problem::TooLong { found, limit: most_bytes });
    if metadata.len() > most_bytes {
        return Err(too_long(metadata.len()));
    }
    let mut file = File::open(path).map_err(refused)?;
    let mut steps = Steps::begin(progress, "reading", usize::try_from(metadata.len()).unwrap_or(usize::MAX));
    let mut bytes = Vec::new();
    while file.by_ref().take(READ_AT_ONCE).read_to_end(&mut bytes).map_err(refused)? > 0 {
        // It may have grown since.
        if bytes.len() as u64 > most_bytes {
            return Err(too_long(bytes.len() as u64));
        }
        steps.report(bytes.len())?;
    }
    Ok(bytes)
}
