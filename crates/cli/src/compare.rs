//! `silhouettes compare`: methods on meshes, measured for speed and accuracy, and the report.

use crate::args::CompareArguments;
use crate::failure::{self, Failure};
use crate::input;
use crate::output::check_writable;
use crate::progress::TerminalProgress;
use silhouette_compare::registry;
use silhouette_compare::runner::{CompareConfig, CompareError, MethodChoice};
use silhouette_compare::scaling::read_rows;
use silhouette_compare::{report, run as run_comparison};
use silhouette_core::method::OptionValues;
use silhouette_render::{AdapterChoice, Gpu};

/// What is compared on where no mesh is named: smooth, sharp and self-occluding.
const DEFAULT_MESHES: [&str; 3] = ["builtin:torus", "builtin:gear", "builtin:knot"];

/// Runs the command.
pub fn run(arguments: &CompareArguments) -> Result<(), Failure> {
    let mut config = CompareConfig::new(arguments.profile.into());
    if !arguments.methods.is_empty() {
        config.methods = arguments.methods.iter().map(|name| choice(name)).collect::<Result<_, _>>()?;
    }
    report::check_target(&arguments.output).map_err(Failure::input)?;
    check_writable(&arguments.output)?;
    let mut peers = Vec::new();
    for path in &arguments.peers {
        peers.extend(read_rows(path).map_err(Failure::input)?);
    }
    let progress = TerminalProgress::new();
    let meshes = input::meshes(&arguments.meshes, &DEFAULT_MESHES, &progress)?;
    let gpu = AdapterChoice::from_env().and_then(Gpu::new).map_err(Failure::gpu)?;
    let mut comparison = run_comparison(&config, &meshes, &gpu, &progress).map_err(failed)?;
    for cell in &comparison.left_out {
        failure::note(cell);
    }
    comparison.peers = peers;
    report::write(&comparison, &arguments.output).map_err(Failure::run)?;
    Ok(())
}

fn choice(name: &str) -> Result<MethodChoice, Failure> {
    let entry = registry::find(name).map_err(Failure::input)?;
    Ok(MethodChoice { entry, options: OptionValues::defaults(entry.info.options) })
}

fn failed(error: CompareError) -> Failure {
    match error {
        input @ (CompareError::Nothing { .. } | CompareError::SameName { .. } | CompareError::EmptyMesh { .. }) => {
            Failure::input(input)
        }
        other => Failure::run(other),
    }
}
