//! Commands as calls, for programs that have their meshes in memory and take results as values: nothing is printed but notes, and no file
//! is written. Options are the words of the command line, so that they mean the same and are refused in the same text.

mod lines;

pub use crate::bake::{Baked, baked, metadata};
pub use crate::failure::with_notes;
pub use crate::input::{hull_of_texture, prepared};
pub use crate::lines::of_finding;
pub use crate::reproduce::{default_meshes, reproduction};
pub use crate::smooth::view_mesh;
pub use lines::{WantedLines, changed_mesh, write_lines};

use crate::args::{Arguments, Command};
use crate::compare;
use crate::failure::{Failure, usage};
use crate::recommend::{self, RecommendArguments};
use crate::{PROGRAM, methods, spoken};
use clap::FromArgMatches;
use silhouette_compare::recommend::{Check, Recommendation};
use silhouette_compare::runner::NamedMesh;
use silhouette_compare::{Comparison, Registry};
use silhouette_core::Progress;
use silhouette_render::Gpu;
use std::ffi::OsString;

/// What stands where a command wants the name of a mesh, and the caller has the mesh itself.
const IN_MEMORY: &str = "builtin:cube";

/// The command that words say, that of the program first.
pub(crate) fn arguments(
    words: impl IntoIterator<Item = OsString>,
    registry: &Registry,
) -> Result<Arguments, clap::Error> {
    let matches = methods::command(registry).try_get_matches_from(spoken::joined(words))?;
    Arguments::from_arg_matches(&matches)
}

/// The command of a name with words after it.
fn of_words(name: &str, words: &[String], registry: &Registry) -> Result<Command, Failure> {
    let words = [PROGRAM, name].into_iter().chain(words.iter().map(String::as_str));
    let arguments = arguments(words.map(OsString::from), registry).map_err(|error| usage(&error, PROGRAM))?;
    Ok(arguments.command)
}

fn with<'a>(words: &[String], more: impl IntoIterator<Item = &'a str>) -> Vec<String> {
    words.iter().cloned().chain(more.into_iter().map(str::to_owned)).collect()
}

/// What each method says of itself, as JSON.
///
/// # Errors
/// [`Failure::Run`]: never for the methods of this workspace.
pub fn methods(registry: &Registry) -> Result<String, Failure> {
    methods::json(registry.entries())
}

/// What words of `compare` measure on these meshes; on those of the scene, where there are none.
///
/// # Errors
/// [`Failure`]: a word or a mesh does not fit, or the run failed.
pub fn compare(
    words: &[String],
    meshes: &[NamedMesh],
    gpu: &Gpu,
    registry: &Registry,
    progress: &dyn Progress,
) -> Result<Comparison, Failure> {
    let names = meshes.iter().map(|mesh| mesh.name.as_str());
    let words = with(words, ["-o", "report", "--"].into_iter().chain(names));
    match of_words("compare", &words, registry)? {
        Command::Compare(arguments) => compare::comparison(&arguments, meshes, gpu, registry, progress),
        _ => unreachable!("the command is compare"),
    }
}

/// What words of `recommend` ask for.
pub struct Question(RecommendArguments);

impl Question {
    /// The question.
    ///
    /// # Errors
    /// [`Failure::Input`]: a word does not fit.
    pub fn of_words(words: &[String], registry: &Registry) -> Result<Self, Failure> {
        match of_words("recommend", &with(words, [IN_MEMORY]), registry)? {
            Command::Recommend(arguments) => Ok(Self(arguments)),
            _ => unreachable!("the command is recommend"),
        }
    }

    /// Whether pictures are measured, so that a device is wanted.
    pub fn needs_device(&self) -> bool {
        self.0.needs_device()
    }

    /// The answer for a mesh, and what its check found.
    ///
    /// # Errors
    /// [`Failure`]: the mesh has no face, or the run failed.
    pub fn answer(
        &self,
        mesh: &NamedMesh,
        gpu: Option<&Gpu>,
        registry: &Registry,
        progress: &dyn Progress,
    ) -> Result<(Recommendation, Option<Check>), Failure> {
        recommend::answer(&self.0, mesh, gpu, registry, progress)
    }
}
