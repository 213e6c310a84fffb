//! What other programs and languages share with the command line: meshes, cameras, pictures and failures in the same words.
//!
//! A [`MeshArgument`] is [loaded](load), [`CameraArguments`] make a camera of its bounds, and what goes wrong is a [`Failure`], one line
//! that names the place and the mend. Files are written by [`execute`](crate::execute), with the words of a command.

pub use crate::args::MethodArguments;
pub use crate::camera::CameraArguments;
pub use crate::failure::{Failure, usage};
pub use crate::mesa::silence as silence_mesa;
pub use crate::mesh_argument::MeshArgument;
pub use crate::observer::{Observer, observed};
pub use crate::render::{method_of_picture, open_device, picture};

use crate::input;
use crate::output::Output;
use crate::winding::OrientArgument;
use silhouette_compare::registry::Entry;
use silhouette_compare::runner::NamedMesh;
use silhouette_core::Progress;
use silhouette_core::load::{LabelledMesh, Note};
use std::path::Path;

/// A mesh by its name on the command line, as it is wound, and what its reader noted.
///
/// # Errors
/// [`Failure`]: there is no such file or shape, or it cannot be read.
pub fn load(argument: &MeshArgument, progress: &dyn Progress) -> Result<(NamedMesh, Vec<Note>), Failure> {
    input::mesh_with_notes(argument, progress)
}

/// The same with what its file says of parts, materials and sharp edges.
///
/// # Errors
/// [`Failure`]: there is no such file or shape, or it cannot be read.
pub fn load_labelled(argument: &MeshArgument, progress: &dyn Progress) -> Result<(String, LabelledMesh), Failure> {
    input::silently_labelled(argument, progress)
}

/// Writes a file as the commands do: it appears whole or not at all.
///
/// # Errors
/// [`Failure`]: it cannot be written there.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    Output::create(Some(path), &[])?.write(bytes)
}

/// A mesh by its name on the command line as `render` reads it, for methods to be chosen later; a `.siltex` file is the mesh of its hull.
/// Faces of parts that are wound inside out are turned as with `--orient`, or noted.
///
/// # Errors
/// As [`load`].
pub fn open(argument: &MeshArgument, orient: bool, progress: &dyn Progress) -> Result<NamedMesh, Failure> {
    input::one(argument, OrientArgument { orient }.winding(true), progress)
}

/// That a method draws what an argument names, as `render` says it.
///
/// # Errors
/// [`Failure::Input`]: it is a silhouette texture, and the method draws none.
pub fn check_drawn_by(argument: &MeshArgument, method: &Entry) -> Result<(), Failure> {
    input::check_drawn_by(argument, method)
}
