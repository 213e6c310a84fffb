//! `silhouettes reproduce`: what a paper printed, measured here and set beside it.

use crate::args::ReproduceArguments;
use crate::failure::Failure;
use crate::input;
use crate::output::{Output, check_writable};
use crate::progress::TerminalProgress;
use crate::winding::Winding;
use silhouette_papers::{ALL, Paper, Run, check_target, find, terminal, write};
use silhouette_render::{AdapterChoice, Gpu};
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
    let open = || AdapterChoice::from_env().and_then(Gpu::new).map_err(Failure::gpu);
    let gpu = paper.needs_gpu.then(open).transpose()?;
    let run = Run { profile: arguments.profile.into(), meshes: &meshes, gpu: gpu.as_ref(), progress: &progress };
    let reproduction = paper
        .reproduce(&run)
        .map_err(|error| if error.is_of_input() { Failure::input(error) } else { Failure::run(error) })?;
    write(&reproduction, directory).map_err(Failure::run)?;
    let mut tables = Vec::new();
    terminal::write_tables(&reproduction, &mut tables).map_err(Failure::run)?;
    Output::Stdout.write(&tables)
}
