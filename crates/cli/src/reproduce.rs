//! `silhouettes reproduce`: what a paper printed, measured here and set beside it.

use crate::args::{PaperArgument, ReproduceArguments};
use crate::failure::{self, Failure};
use crate::input;
use crate::output::{Output, check_writable};
use crate::progress::TerminalProgress;
use silhouette_compare::record::Profile;
use silhouette_core::method::PrepareError;
use silhouette_papers::{check_target, hall_2003 as tracking, raskar_cohen_1999 as image_precision};
use silhouette_render::{AdapterChoice, Gpu};
use std::path::Path;

/// What is flown around where no mesh is named: bumps that hide and reveal each other.
const TRACKING_MESHES: [&str; 1] = ["builtin:blob:20000"];

/// What is drawn where no mesh is named: meshes as large as the paper's Venus, Face and machine room.
const IMAGE_PRECISION_MESHES: [&str; 3] = ["builtin:blob:5672", "builtin:blob:13408", "builtin:machine-room"];

/// Runs the command. All papers are written to a folder each below the one that is named.
pub fn run(arguments: &ReproduceArguments) -> Result<(), Failure> {
    let directory = &arguments.output;
    match arguments.paper {
        PaperArgument::Tracking => run_tracking(arguments, directory),
        PaperArgument::ImagePrecision => run_image_precision(arguments, directory),
        PaperArgument::All => {
            run_tracking(arguments, &directory.join("tracking"))?;
            run_image_precision(arguments, &directory.join("image-precision"))
        }
    }
}

fn run_tracking(arguments: &ReproduceArguments, directory: &Path) -> Result<(), Failure> {
    check_target(directory).map_err(Failure::input)?;
    check_writable(directory)?;
    let progress = TerminalProgress::new();
    let meshes = input::meshes(&arguments.meshes, &TRACKING_MESHES, &progress)?;
    if arguments.meshes.is_empty() {
        failure::note("the paper's bunny is not shipped; name its file to have its rows beside the paper's");
    }
    let reproduction = tracking::run(arguments.profile.into(), &meshes, &progress).map_err(tracking_failed)?;
    tracking::write(&reproduction, directory).map_err(Failure::run)?;
    let mut table = Vec::new();
    tracking::table::write_table(&reproduction, &mut table).map_err(Failure::run)?;
    Output::Stdout.write(&table)
}

fn run_image_precision(arguments: &ReproduceArguments, directory: &Path) -> Result<(), Failure> {
    check_target(directory).map_err(Failure::input)?;
    check_writable(directory)?;
    let progress = TerminalProgress::new();
    let meshes = input::meshes(&arguments.meshes, &IMAGE_PRECISION_MESHES, &progress)?;
    let gpu = AdapterChoice::from_env().and_then(Gpu::new).map_err(Failure::gpu)?;
    let profile: Profile = arguments.profile.into();
    let reproduction = image_precision::run(profile, &meshes, &gpu, &progress)
        .map_err(|error| if error.is_of_input() { Failure::input(error) } else { Failure::run(error) })?;
    image_precision::write(&reproduction, directory).map_err(Failure::run)?;
    let mut table = Vec::new();
    image_precision::table::write_table(&reproduction, &mut table).map_err(Failure::run)?;
    Output::Stdout.write(&table)
}

fn tracking_failed(error: tracking::ReproduceError) -> Failure {
    use tracking::ReproduceError::{EmptyMesh, NoMesh, Prepare};
    match error {
        input @ (NoMesh | EmptyMesh { .. } | Prepare { source: PrepareError::Mesh(_), .. }) => Failure::input(input),
        other => Failure::run(other),
    }
}
