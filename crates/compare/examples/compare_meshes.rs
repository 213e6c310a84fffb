//! Compares every method on the meshes named and writes the report:
//! `cargo run --release --example compare_meshes -- bunny.obj armadillo.obj report`.

use silhouette_compare::{CompareConfig, NamedMesh, Profile, Registry, report, run};
use silhouette_core::{NoProgress, PreparedMesh, load};
use silhouette_render::{AdapterChoice, Gpu};
use std::error::Error;
use std::path::Path;
use std::sync::Arc;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (directory, paths) =
        arguments.split_last().ok_or("name one or more meshes, then a directory for the report")?;
    report::check_target(Path::new(directory))?;
    let mut meshes = Vec::new();
    for path in paths {
        let mesh = load::load(Path::new(path))?;
        meshes.push(NamedMesh { name: path.clone(), mesh: Arc::new(PreparedMesh::new(mesh)) }.into());
    }
    let gpu = Gpu::new(AdapterChoice::from_env()?)?;
    let comparison =
        run(&CompareConfig::new(Profile::Quick.scene(), &Registry::builtin())?, &meshes, &gpu, &NoProgress)?;
    report::write(&comparison, Path::new(directory))?;
    Ok(())
}
