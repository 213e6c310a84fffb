//! `silhouettes lines`: visible and hidden lines as SVG for plotters, as JSON, or as glTF.

mod arguments;
mod quick;
mod smooth;
mod stats;

pub use arguments::LinesArguments;

use arguments::HealDistance;

use crate::failure::{Failure, note};
use crate::input;
use crate::output::Output;
use crate::progress::TerminalProgress;
use silhouette_core::heal::heal_t_junctions;
use silhouette_core::load::LabelledMesh;
use silhouette_core::origin::common_origin;
use silhouette_core::{EdgeId, Topology, TriangleMesh, VertexId};
use silhouette_visibility::plot::{self, GltfContainer, PlotError, PlotOptions};
use silhouette_visibility::{LineError, LineFinder, LineScene, Lines};
use std::path::Path;
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
    let output = Output::create(arguments.output.as_deref(), &arguments.meshes)?;
    let progress = TerminalProgress::new();

    let started = Instant::now();
    let meshes = meshes(arguments, &progress)?;
    let names = meshes.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>().join(", ");
    let scene = scene_of(&meshes, arguments.wants_materials(), &names)?;
    let bounds = scene.mesh().mesh().bounds();
    let bounds = bounds.ok_or_else(|| Failure::Input(format!("{names}: has no face")))?;
    let camera = arguments.camera.camera(&bounds, scene.mesh().mesh().origin())?;
    options.check(&camera).map_err(of_plotting)?;
    let load = started.elapsed();

    let started = Instant::now();
    let mut wanted = arguments.line_options();
    let scene = if arguments.smooth {
        let (scene, of_curves) = smooth::scene(&meshes, &camera, &wanted, &progress)?;
        wanted = of_curves;
        scene
    } else {
        scene
    };
    let (prepare, lines) = if arguments.quick {
        quick::find(&scene, &names, &camera, &wanted, &progress)?
    } else {
        let mut finder = LineFinder::new(scene.clone(), &progress)?;
        (started.elapsed(), finder.find(&camera, &wanted, &progress).map_err(|error| of_finding(&names, error))?)
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

/// The meshes with their names, welded and healed if that is asked for.
fn meshes(arguments: &LinesArguments, progress: &TerminalProgress) -> Result<Vec<(String, LabelledMesh)>, Failure> {
    let mut meshes = input::labelled_meshes(&arguments.meshes, progress)?;
    if let Some(distance) = arguments.weld {
        meshes.iter_mut().try_for_each(|(_, loaded)| input::weld(loaded, distance))?;
    }
    if let Some(distance) = arguments.heal {
        // Their vertices get other numbers, and no line is drawn along them.
        meshes.iter_mut().for_each(|(_, loaded)| loaded.feature_edges.clear());
        for (name, loaded) in &mut meshes {
            heal(name, loaded, distance)?;
        }
    }
    // One camera sees them all.
    let origin = common_origin(meshes.iter().map(|(_, loaded)| &loaded.mesh));
    for (_, loaded) in meshes.iter_mut().filter(|(_, loaded)| loaded.mesh.origin() != origin) {
        loaded.mesh = loaded.mesh.relative_to(origin).map_err(Failure::input)?;
    }
    // Lines are right whichever way faces point, and so are their kinds.
    let winding = arguments.orient.winding(false);
    meshes.iter_mut().for_each(|(name, loaded)| winding.apply(name, loaded));
    Ok(meshes)
}

/// Mends the T-junctions of a mesh.
fn heal(name: &str, loaded: &mut LabelledMesh, distance: HealDistance) -> Result<(), Failure> {
    let distance = match distance {
        HealDistance::Units(distance) => distance,
        HealDistance::Auto => {
            let extent = loaded.mesh.bounds().map_or(0.0, |bounds| (bounds.max - bounds.min).max_element());
            (extent * HEAL_SHARE) as f32
        }
    };
    let healed = heal_t_junctions(&loaded.mesh, distance);
    let healed = healed.map_err(|error| Failure::Input(format!("--heal: {error}")))?;
    if healed.mesh.face_count() == 0 && loaded.mesh.face_count() > 0 {
        return Err(Failure::Input(format!(
            "--heal: no face of {name} is higher than {distance}; give a smaller distance"
        )));
    }
    if healed.divided > 0 {
        note(format!("{name}: edges divided at T-junctions: {}", healed.divided));
    }
    if let Some(labels) = &mut loaded.labels {
        *labels = healed.face_of.iter().map(|face| labels[face.index()]).collect();
    }
    loaded.mesh = healed.mesh;
    Ok(())
}

/// How far a vertex may lie from an edge that it divides where no distance is given, as a share of the mesh's largest extent.
const HEAL_SHARE: f64 = 1e-6;

/// All meshes as one scene, with the labels of their faces if borders between them are wanted.
fn scene_of(meshes: &[(String, LabelledMesh)], wants_labels: bool, names: &str) -> Result<LineScene, Failure> {
    let only: Vec<&TriangleMesh> = meshes.iter().map(|(_, loaded)| &loaded.mesh).collect();
    let scene = LineScene::of_meshes(&only).map_err(Failure::input)?;
    if !wants_labels {
        return Ok(scene);
    }
    if meshes.iter().all(|(_, loaded)| loaded.labels.is_none()) {
        note(format!("{names}: all faces are of one material and group; --materials adds no line"));
    }
    // Faces of different meshes have no edge in common, so that their labels may be equal.
    let labels = meshes.iter().flat_map(|(_, loaded)| {
        let none = || vec![0; loaded.mesh.face_count()];
        loaded.labels.clone().unwrap_or_else(none)
    });
    scene.with_labels(labels.collect()).map_err(Failure::input)
}

/// The document, with each object's vertices numbered as in its own file, or as welded.
fn json(
    lines: &Lines,
    options: &PlotOptions,
    scene: &LineScene,
    meshes: &[(String, LabelledMesh)],
    progress: &TerminalProgress,
) -> Result<Vec<u8>, Failure> {
    let topology = scene.mesh().artefact::<Topology>("lines", progress)?;
    let counts = meshes.iter().map(|(_, loaded)| loaded.mesh.vertex_count() as u32);
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

/// The failure to find the lines of the meshes with these names.
fn of_finding(names: &str, error: LineError) -> Failure {
    match error {
        LineError::Cancelled(error) => error.into(),
        other => Failure::Input(format!("{names}: {other}")),
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
