//! `silhouettes reproduce`: what a paper printed, measured here and set beside it.

use crate::args::ReproduceArguments;
use crate::failure::{self, Failure};
use crate::input;
use crate::output::{Output, check_writable};
use crate::progress::TerminalProgress;
use silhouette_compare::reproduce::tracking::{self, ReproduceError, table::write_table};
use silhouette_core::method::PrepareError;
use silhouette_render::{AdapterChoice, Gpu};

/// What is flown around where no mesh is named: bumps that hide and reveal each other.
const DEFAULT_MESHES: [&str; 1] = ["builtin:blob:20000"];

/// Runs the command. One paper is all papers so far.
pub fn run(arguments: &ReproduceArguments) -> Result<(), Failure> {
    let directory = &arguments.output;
    tracking::check_target(directory).map_err(Failure::input)?;
    check_writable(directory)?;
    let progress = TerminalProgress::new();
    let meshes = input::meshes(&arguments.meshes, &DEFAULT_MESHES, &progress)?;
    if arguments.meshes.is_empty() {
        failure::note("the paper's bunny is not shipped; name its file to have its rows beside the paper's");
    }
    let gpu = AdapterChoice::from_env().and_then(Gpu::new).map_err(|error| error.to_string());
    if let Err(why) = &gpu {
        failure::note(format!("visible length stays unknown: {why}"));
    }
    let gpu = gpu.as_ref().map_err(String::as_str);
    let reproduction = tracking::run(arguments.profile.into(), &meshes, gpu, &progress).map_err(failed)?;
    tracking::write(&reproduction, directory).map_err(Failure::run)?;
    let mut table = Vec::new();
    write_table(&reproduction, &mut table).map_err(Failure::run)?;
    Output::Stdout.write(&table)
}

fn failed(error: ReproduceError) -> Failure {
    match error {
        input @ (ReproduceError::NoMesh
        | ReproduceError::EmptyMesh { .. }
        | ReproduceError::Prepare { source: PrepareError::Mesh(_), .. }) => Failure::input(input),
        other => Failure::run(other),
    }
}
