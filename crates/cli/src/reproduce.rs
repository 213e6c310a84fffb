//! `silhouettes reproduce`: what a paper printed, measured here and set beside it.

use crate::args::ReproduceArguments;
use crate::failure::Failure;
use crate::input;
use crate::output::{Output, check_writable};
use crate::progress::TerminalProgress;
use crate::render::open_device;
use crate::winding::Winding;
use silhouette_compare::{NamedMesh, Profile};
use silhouette_core::Progress;
use silhouette_papers::{ALL, Paper, Reproduction, Run, check_target, find, terminal, write};
use silhouette_render::Gpu;
use std::path::Path;

/// Runs the command. Where all papers are meant each paper is written to a folder below the one that is named.
pub fn run(arguments: &ReproduceArguments) -> Result<(), Failure> {
    let directory = &arguments.output;
    match find(&arguments.paper) {
        Some(paper) => run_paper(paper, arguments, directory),
        None => ALL.into_iter().try_for_each(|paper| run_paper(paper, arguments, &directory.join(paper.name))),
    }
}

fn run_paper(paper: &'static Paper, arguments: &ReproduceArguments, directory: &Path) -> Result<(), Failure> {
    check_target(directory).map_err(Failure::input)?;
    check_writable(directory)?;
    let progress = TerminalProgress::new();
    let meshes = input::meshes(&arguments.meshes, paper.default_meshes, Winding::AsItIs, &progress)?;
    let gpu = paper.needs_gpu.then(open_device).transpose()?;
    let reproduction = reproduction(paper, arguments.profile.into(), &meshes, gpu.as_ref(), &progress)?;
    write(&reproduction, directory).map_err(Failure::run)?;
    let mut tables = Vec::new();
    terminal::write_tables(&reproduction, &mut tables).map_err(Failure::run)?;
    Output::Stdout.write(&tables)
}

/// The meshes that a paper is measured on where none is named.
///
/// # Errors
/// [`Failure`]: the work was cancelled.
pub fn default_meshes(paper: &Paper, progress: &dyn Progress) -> Result<Vec<NamedMesh>, Failure> {
    input::meshes(&[], paper.default_meshes, Winding::AsItIs, progress)
}

/// What a paper printed, measured on these meshes; nothing is written.
///
/// # Errors
/// [`Failure`]: a mesh does not fit the paper, or the run failed.
pub fn reproduction(
    paper: &'static Paper,
    profile: Profile,
    meshes: &[NamedMesh],
    gpu: Option<&Gpu>,
    progress: &dyn Progress,
) -> Result<Reproduction, Failure> {
    let measured = paper.reproduce(&Run { profile, meshes, gpu, progress });
    measured.map_err(|error| if error.is_of_input() { Failure::input(error) } else { Failure::run(error) })
}
