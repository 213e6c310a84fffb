//! `silhouettes compare`: methods on meshes, measured for speed and accuracy, and the report.

use crate::args::{CompareArguments, ProfileArgument};
use crate::failure::Failure;
use crate::input;
use crate::output::check_writable;
use crate::progress::TerminalProgress;
use silhouette_compare::record::Profile;
use silhouette_compare::registry;
use silhouette_compare::runner::{CompareConfig, CompareError, MethodChoice, NamedMesh};
use silhouette_compare::scaling::read_rows;
use silhouette_compare::{report, run as run_comparison};
use silhouette_core::method::OptionValues;
use silhouette_render::{AdapterChoice, Gpu};

/// What is compared on where no mesh is named: smooth, sharp and self-occluding.
const DEFAULT_MESHES: [&str; 3] = ["builtin:torus", "builtin:gear", "builtin:knot"];

/// Runs the command.
pub fn run(arguments: &CompareArguments) -> Result<(), Failure> {
    let mut config = CompareConfig::new(match arguments.profile {
        ProfileArgument::Quick => Profile::Quick,
        ProfileArgument::Full => Profile::Full,
    });
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
    let defaults = DEFAULT_MESHES.map(str::to_owned);
    let named = if arguments.meshes.is_empty() { &defaults[..] } else { &arguments.meshes[..] };
    let mut meshes = named.iter().map(|mesh| input::mesh(mesh, &progress)).collect::<Result<Vec<_>, _>>()?;
    tell_apart(&mut meshes, named);
    let gpu = AdapterChoice::from_env().and_then(Gpu::new).map_err(Failure::run)?;
    let mut comparison = run_comparison(&config, &meshes, &gpu, &progress).map_err(failure)?;
    comparison.peers = peers;
    report::write(&comparison, &arguments.output).map_err(Failure::run)?;
    Ok(())
}

/// Files of the same name in several folders go by their paths, as they were given.
fn tell_apart(meshes: &mut [NamedMesh], arguments: &[String]) {
    let names: Vec<_> = meshes.iter().map(|mesh| mesh.name.clone()).collect();
    for (mesh, argument) in meshes.iter_mut().zip(arguments) {
        if names.iter().filter(|&name| *name == mesh.name).count() > 1 {
            mesh.name.clone_from(argument);
        }
    }
}

fn choice(name: &str) -> Result<MethodChoice, Failure> {
    let entry = registry::find(name).map_err(Failure::input)?;
    Ok(MethodChoice { entry, options: OptionValues::defaults(entry.info.options) })
}

fn failure(error: CompareError) -> Failure {
    match error {
        input @ (CompareError::Nothing { .. } | CompareError::SameName { .. } | CompareError::EmptyMesh { .. }) => {
            Failure::input(input)
        }
        other => Failure::run(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::{PreparedMesh, TriangleMesh};
    use std::sync::Arc;

    #[test]
    fn only_files_of_the_same_name_go_by_their_paths() {
        let mesh = Arc::new(PreparedMesh::new(TriangleMesh::new(vec![], vec![]).unwrap()));
        let named = |name: &str| NamedMesh { name: name.to_owned(), mesh: Arc::clone(&mesh) };
        let mut meshes = [named("m.obj"), named("x.obj"), named("m.obj")];
        tell_apart(&mut meshes, &["a/m.obj", "a/x.obj", "b/m.obj"].map(str::to_owned));
        assert_eq!(meshes.map(|mesh| mesh.name), ["a/m.obj", "x.obj", "b/m.obj"]);
    }
}
