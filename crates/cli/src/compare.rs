//! `silhouettes compare`: methods on meshes, measured for speed and accuracy, and the report.

pub mod arguments;

use crate::failure::{self, Failure};
use crate::input;
use crate::mesh_argument::MeshArgument;
use crate::output::check_writable;
use crate::progress::TerminalProgress;
use crate::render::{draws_itself, open_device};
use crate::winding::Winding;
use arguments::CompareArguments;
use silhouette_compare::metrics::PictureKind;
use silhouette_compare::metrics::table::MetricSpec;
use silhouette_compare::runner::{CompareConfig, NamedMesh, Subject};
use silhouette_compare::scaling::{ExtractionRow, read_rows};
use silhouette_compare::scene::{MeshSpec, Scene};
use silhouette_compare::sweep::{Budget, CellStore, Errors, Key, Refinement, Shard, ShardError, merge, run_shard};
use silhouette_compare::{Comparison, Profile, Registry, report};
use silhouette_core::Progress;
use silhouette_render::Gpu;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Runs the command.
pub fn run(arguments: &CompareArguments, registry: &Registry) -> Result<(), Failure> {
    let config = config(arguments, registry)?;
    let shard = shard(arguments)?;
    if shard.is_none() {
        report::check_target(&arguments.output).map_err(Failure::input)?;
    }
    check_writable(&arguments.output)?;
    let peers = read_peers(&arguments.peers)?;
    let progress = TerminalProgress::new();
    let depends = config.methods().iter().any(|choice| draws_itself(&choice.entry));
    let subjects = subjects(config.scene(), &arguments.meshes, arguments.orient.winding(depends), &progress)?;
    let gpu = open_device()?;
    let key = Key::of(&config, &subjects);
    if let Some(shard) = shard {
        let store = CellStore::open(&arguments.output, key).map_err(Failure::input)?;
        return run_shard(&config, &subjects, &store, shard, &gpu, &progress).map_err(of_shard);
    }
    let store = CellStore::open(&beside(&arguments.output, &key), key).map_err(Failure::input)?;
    let found = store.count();
    if found > 0 {
        let of = store.key().cells();
        failure::note(format!(
            "{found} of {of} cells were measured before, and are taken from {}",
            store.folder().display()
        ));
    }
    let measured = run_shard(&config, &subjects, &store, Shard::WHOLE, &gpu, &progress).map_err(of_shard);
    let measured = measured.and_then(|()| merge(std::slice::from_ref(&store), registry).map_err(Failure::run));
    let measured = measured.and_then(|mut comparison| {
        if let Some(time) = arguments.budget {
            let refinement =
                Refinement { config: &config, subjects: &subjects, registry, gpu: &gpu, progress: &progress };
            let budget = Budget { time, errors: errors(arguments.error) };
            let added = refinement.refine(&store, &mut comparison, &budget).map_err(of_shard)?;
            failure::note(match added {
                0 if !is_swept(&comparison) => {
                    "--budget: no option has several values; name one with --sweep".to_owned()
                }
                0 => {
                    "no value was added: the fronts are fine enough, or the budget is too small for one more".to_owned()
                }
                1 => "1 value was added within the budget".to_owned(),
                added => format!("{added} values were added within the budget"),
            });
        }
        Ok(comparison)
    });
    let mut comparison = match measured {
        Ok(comparison) => comparison,
        Err(failure) => return Err(after_failure(failure, store)),
    };
    note_left_out(&comparison);
    comparison.peers = peers;
    report::write(&comparison, &arguments.output).map_err(Failure::run)?;
    store.remove().map_err(Failure::run)
}

/// Notes which methods refused which mesh: no cell holds anything of them.
fn note_left_out(comparison: &Comparison) {
    comparison.left_out.iter().for_each(failure::note);
}

/// What the arguments have measured, on meshes of the caller's or, where there are none, on those of the scene; nothing is written.
///
/// # Errors
/// [`Failure`]: an argument or a mesh does not fit, or the run failed.
pub fn comparison(
    arguments: &CompareArguments,
    meshes: &[NamedMesh],
    gpu: &Gpu,
    registry: &Registry,
    progress: &dyn Progress,
) -> Result<Comparison, Failure> {
    let config = config(arguments, registry)?;
    let subjects = if meshes.is_empty() {
        subjects(config.scene(), &[], Winding::AsItIs, progress)?
    } else {
        let drawn = |(mesh, spec): (&NamedMesh, &MeshSpec)| subject(mesh.clone(), spec, Winding::AsItIs, progress);
        meshes.iter().zip(&config.scene().meshes).map(drawn).collect::<Result<_, _>>()?
    };
    let comparison = silhouette_compare::run(&config, &subjects, gpu, progress).map_err(Failure::of_comparison)?;
    note_left_out(&comparison);
    Ok(comparison)
}

/// Whether some method is there with several settings.
fn is_swept(comparison: &Comparison) -> bool {
    let methods: BTreeSet<_> = comparison.cells.iter().map(|cell| &cell.method).collect();
    let settings: BTreeSet<_> = comparison.cells.iter().map(|cell| (&cell.method, cell.options.to_string())).collect();
    settings.len() > methods.len()
}

/// The errors of the fronts: the one named for its kind of picture, and the leading one of the other.
fn errors(named: Option<&'static MetricSpec>) -> Errors {
    let of = |kind: PictureKind| named.filter(|metric| metric.kind == kind).unwrap_or_else(|| kind.leading_metric());
    Errors { lines: of(PictureKind::Lines), fill: of(PictureKind::Fill) }
}

/// The rows of several files.
pub fn read_peers(paths: &[PathBuf]) -> Result<Vec<ExtractionRow>, Failure> {
    let mut peers = Vec::new();
    for path in paths {
        peers.extend(read_rows(path).map_err(Failure::input)?);
    }
    Ok(peers)
}

/// The shard that is asked for, or that a Slurm job array makes of this process.
fn shard(arguments: &CompareArguments) -> Result<Option<Shard>, Failure> {
    if arguments.shard.is_some() {
        return Ok(arguments.shard);
    }
    let shard = Shard::of_slurm(|name| std::env::var(name).ok());
    let shard = shard.map_err(|error| Failure::Input(format!("--shard: {error}; give one")))?;
    if let Some(shard) = shard {
        if arguments.budget.is_some() || !arguments.peers.is_empty() {
            let line = "a Slurm job array measures shards, with which --budget and --peers do not go; leave them out";
            return Err(Failure::Input(line.to_owned()));
        }
        let output = arguments.output.display();
        failure::note(format!(
            "shard {shard} of a Slurm job array: {output} will hold cells; silhouettes merge makes the report"
        ));
    }
    Ok(shard)
}

/// Where the finished cells of a comparison are kept until its report is written.
fn beside(report: &Path, key: &Key) -> PathBuf {
    let report: PathBuf = report.components().collect();
    let mut name = report.file_name().unwrap_or_default().to_owned();
    name.push(format!(".cells-{}", key.digest()));
    report.with_file_name(name)
}

/// Says what was kept of a comparison that failed; leaves nothing behind where nothing was.
fn after_failure(failure: Failure, store: CellStore) -> Failure {
    let (kept, cells) = (store.count(), store.key().cells());
    if kept > 0 {
        let folder = store.folder().display();
        failure::note(format!("{kept} of {cells} cells are kept in {folder}; the same command goes on from there"));
    } else if let Err(error) = store.remove() {
        failure::note(error);
    }
    failure
}

fn of_shard(error: ShardError) -> Failure {
    match error {
        ShardError::Compare(error) => Failure::of_comparison(error),
        other => Failure::run(other),
    }
}

/// The scene named, or that of the profile, with what the command line overrides.
fn config(arguments: &CompareArguments, registry: &Registry) -> Result<CompareConfig, Failure> {
    let (mut scene, place) = match &arguments.scene {
        Some(path) => (Scene::load(path).map_err(Failure::input)?, path.display().to_string()),
        None => (Profile::from(arguments.profile).scene(), "compare".to_owned()),
    };
    if !arguments.methods.is_empty() {
        for name in &arguments.methods {
            registry.find(name).map_err(Failure::input)?;
        }
        scene.select(&arguments.methods);
    }
    for setting in &arguments.set {
        scene.set(setting, registry).map_err(|fault| Failure::Input(format!("--set {setting}: {fault}")))?;
    }
    scene.sweep(&arguments.sweep, registry).map_err(|fault| Failure::Input(format!("--sweep: {fault}")))?;
    if let Some(passes) = arguments.passes {
        scene.path.passes = passes;
    }
    if !arguments.meshes.is_empty() {
        scene.meshes = arguments.meshes.iter().map(|mesh| MeshSpec::Plain(mesh.to_string())).collect();
    }
    if let Some(faces) = arguments.simplify {
        let simplified = scene.simplify_meshes(faces.get());
        simplified.map_err(|fault| Failure::Input(format!("--simplify {faces}: {fault}")))?;
    }
    if let Some(axis) = arguments.up_axis {
        scene.path.up_axis = axis.into();
    }
    if scene.meshes.is_empty() {
        return Err(Failure::Input(format!(
            "{place}: meshes: none is listed; name one in the scene or as an argument"
        )));
    }
    CompareConfig::new(scene, registry).map_err(|fault| Failure::input(fault.in_scene(place)))
}

/// Loads the meshes of a scene, simplifies those that are to be drawn so, and loads those that others stand for. Where meshes
/// are `named` on the command line, they are those of the scene: its text could not hold every file name.
fn subjects(
    scene: &Scene,
    named: &[MeshArgument],
    winding: Winding,
    progress: &dyn Progress,
) -> Result<Vec<Subject>, Failure> {
    let of_scene: Vec<&str> = scene.meshes.iter().map(MeshSpec::mesh).collect();
    let meshes = input::meshes(named, &of_scene, winding, progress)?;
    meshes.into_iter().zip(&scene.meshes).map(|(mesh, spec)| subject(mesh, spec, winding, progress)).collect()
}

/// A mesh as a scene wants it drawn, and what it stands for.
fn subject(mesh: NamedMesh, spec: &MeshSpec, winding: Winding, progress: &dyn Progress) -> Result<Subject, Failure> {
    if let Some(faces) = spec.simplify() {
        let refused = |fault| Failure::Input(format!("{}: {fault}", mesh.name));
        return Subject::simplified(&mesh, faces).map_err(refused);
    }
    let origin = mesh.mesh.mesh().origin();
    let load = |name: &str| {
        let truth = input::mesh(&name.into(), winding, progress)?;
        let placed = truth.mesh.mesh().relative_to(origin);
        placed.map(Arc::new).map_err(|error| Failure::Input(format!("{name}: {error}")))
    };
    Ok(Subject { mesh, truth: spec.truth().map(load).transpose()? })
}
