//! `silhouettes lines`: visible and hidden lines as SVG for plotters, as JSON, or as glTF.

mod arguments;
mod quick;
mod stats;

pub use arguments::LinesArguments;

use crate::failure::{Failure, note};
use crate::input;
use crate::output::Output;
use crate::progress::TerminalProgress;
use silhouette_compare::runner::NamedMesh;
use silhouette_core::{EdgeId, Topology, TriangleMesh, VertexId};
use silhouette_visibility::plot::{self, GltfContainer, PlotError, PlotOptions};
use silhouette_visibility::{LineError, LineFinder, LineScene, Lines};
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

/// The formats that lines are written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Svg,
    Json,
    Gltf(GltfContainer),
}

/// Runs the command.
pub fn run(arguments: &LinesArguments) -> Result<(), Failure> {
    match arguments.threads {
        None => draw(arguments),
        Some(threads) => {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(usize::from(threads)).build();
            pool.map_err(Failure::run)?.install(|| draw(arguments))
        }
    }
}

fn draw(arguments: &LinesArguments) -> Result<(), Failure> {
    let format = format_of(arguments.output.as_deref())?;
    let options = arguments.plot_options()?;
    let inputs: Vec<_> = arguments.meshes.iter().map(String::as_str).collect();
    let output = Output::create(arguments.output.as_deref(), &inputs)?;
    let progress = TerminalProgress::new();

    let started = Instant::now();
    let meshes = input::meshes(&arguments.meshes, &[], &progress)?;
    let scene = scene_of(&meshes)?;
    let bounds = scene.mesh().mesh().bounds();
    let names = meshes.iter().map(|mesh| mesh.name.as_str()).collect::<Vec<_>>().join(", ");
    let bounds = bounds.ok_or_else(|| Failure::Input(format!("{names}: has no face")))?;
    let camera = arguments.camera.camera(&bounds)?;
    options.check(&camera).map_err(of_plotting)?;
    let load = started.elapsed();

    let started = Instant::now();
    let wanted = arguments.line_options();
    let (prepare, lines) = if arguments.quick {
        quick::find(&scene, &camera, &wanted, &progress)?
    } else {
        let mut finder = LineFinder::new(scene.clone(), &progress)?;
        (started.elapsed(), finder.find(&camera, &wanted, &progress).map_err(of_finding)?)
    };

    let mut bytes = Vec::new();
    let mut drawing = None;
    match format {
        Format::Svg => {
            let drawing = drawing.insert(plot::plot(&lines, &options, &progress).map_err(of_plotting)?);
            tell_what_is_cut_off(drawing, &options);
            drawing.write_svg(&format!("Lines of {names}"), &mut bytes).map_err(Failure::run)?;
        }
        Format::Json => bytes = json(&lines, &options, &scene, &meshes, &progress)?,
        Format::Gltf(container) => {
            plot::write_gltf(&lines, &options, container, &mut bytes).map_err(Failure::run)?;
        }
    }
    if arguments.stats {
        stats::print(&stats::Report { load, prepare, lines: &lines, drawing: drawing.as_ref(), bytes: bytes.len() });
    }
    output.write(&bytes)
}

/// One mesh keeps what is already known of it; several become one.
fn scene_of(meshes: &[NamedMesh]) -> Result<LineScene, Failure> {
    if let [only] = meshes {
        return Ok(LineScene::new(Arc::clone(&only.mesh)));
    }
    let meshes: Vec<&TriangleMesh> = meshes.iter().map(|mesh| &**mesh.mesh.mesh()).collect();
    LineScene::of_meshes(&meshes).map_err(Failure::input)
}

/// The document, with each object's vertices numbered as in its own file.
fn json(
    lines: &Lines,
    options: &PlotOptions,
    scene: &LineScene,
    meshes: &[NamedMesh],
    progress: &TerminalProgress,
) -> Result<Vec<u8>, Failure> {
    let topology = scene.mesh().artefact::<Topology>("lines", progress)?;
    let counts = meshes.iter().map(|mesh| mesh.mesh.mesh().vertex_count() as u32);
    let firsts: Vec<u32> = counts
        .scan(0, |next, count| {
            let first = *next;
            *next += count;
            Some(first)
        })
        .collect();
    let end_points = |object: u32, edge: EdgeId| {
        topology.end_points(edge).map(|vertex| VertexId::new(vertex.get() - firsts[object as usize]))
    };
    let placement = plot::placement(lines, options).map_err(of_plotting)?;
    let mut bytes = Vec::new();
    plot::write_json(lines, &placement, &end_points, &mut bytes).map_err(Failure::run)?;
    Ok(bytes)
}

fn tell_what_is_cut_off(drawing: &plot::Drawing, options: &PlotOptions) {
    let (cut_off, drawn) = (drawing.stats.cut_off, drawing.stats.drawn);
    // Less than this share is rounding.
    if cut_off > 1e-6 * (cut_off + drawn) {
        let share = 100.0 * cut_off / (cut_off + drawn);
        let unit = options.unit.suffix();
        note(format!(
            "{cut_off:.1}{unit} of lines ({share:.1} %) lie off the page at this scale and are cut off; choose a larger --page or a smaller --scale"
        ));
    }
}

fn of_plotting(error: PlotError) -> Failure {
    match error {
        PlotError::Cancelled(error) => error.into(),
        PlotError::ScaleOfPerspective => Failure::Input(format!("--scale: {error}; add --ortho fit")),
        error => Failure::input(error),
    }
}

fn of_finding(error: LineError) -> Failure {
    match error {
        LineError::Cancelled(error) => error.into(),
        error => Failure::input(error),
    }
}

fn format_of(path: Option<&Path>) -> Result<Format, Failure> {
    let Some(path) = path else { return Ok(Format::Svg) };
    match path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase).as_deref() {
        Some("svg") => Ok(Format::Svg),
        Some("json") => Ok(Format::Json),
        Some("gltf") => Ok(Format::Gltf(GltfContainer::Text)),
        Some("glb") => Ok(Format::Gltf(GltfContainer::Binary)),
        _ => Err(Failure::Input(format!(
            "{}: unknown kind of output; end its name in .svg, .json, .gltf or .glb",
            path.display()
        ))),
    }
}
