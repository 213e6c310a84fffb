//! `silhouettes extract`: silhouette edges and loops as data.

mod json;
mod obj;
mod svg;

use crate::args::ExtractArguments;
use crate::failure::Failure;
use crate::input;
use crate::output::Output;
use crate::progress::TerminalProgress;
use silhouette_compare::registry::{self, Prepared, Yields};
use silhouette_compare::runner::NamedMesh;
use silhouette_core::loops::{LoopWalker, start_vertex};
use silhouette_core::method::{ExtractionStats, OptionValues};
use silhouette_core::{FaceFacings, SilhouetteEdges, SilhouetteLoops, Topology, TriangleMesh, VertexId, Viewpoint};
use std::path::Path;
use std::sync::Arc;

/// What was found in one view.
struct Extraction {
    mesh: Arc<TriangleMesh>,
    method: &'static str,
    viewpoint: Viewpoint,
    /// Vertices of each silhouette edge, lower one first, sorted.
    edges: Vec<[VertexId; 2]>,
    /// Those that are boundary edges, sorted.
    boundary: Vec<[VertexId; 2]>,
    /// Vertices of each loop, in order.
    loops: Vec<Vec<VertexId>>,
    stats: ExtractionStats,
}

/// The formats an extraction is written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Json,
    Svg,
    Obj,
}

/// Runs the command.
pub fn run(arguments: &ExtractArguments) -> Result<(), Failure> {
    let format = format_of(arguments.output.as_deref())?;
    let entry = registry::find(&arguments.method.method).map_err(Failure::input)?;
    if entry.yields == Yields::Lines {
        let (name, known) = (entry.info.name, extractors());
        return Err(Failure::Input(format!("--method {name} draws lines but extracts no edges; choose {known}")));
    }
    let options = OptionValues::parse(entry.info.options, arguments.method.set.iter().map(String::as_str))?;
    let output = Output::create(arguments.output.as_deref(), &[&arguments.mesh])?;
    let progress = TerminalProgress::new();
    let NamedMesh { name, mesh } = input::mesh(&arguments.mesh, &progress)?;
    let bounds = mesh.mesh().bounds().ok_or_else(|| Failure::Input(format!("{name}: has no face")))?;
    let viewpoint = arguments.camera.viewpoint(&bounds)?;

    let prepared = entry.prepare(&mesh, &options, &progress);
    let failed = |error| Failure::of_preparation(&name, entry.info.name, error);
    let Prepared::Edges(mut method) = prepared.map_err(failed)? else {
        unreachable!("methods that draw lines were refused above")
    };
    let mut edges = SilhouetteEdges::default();
    let stats = method.extract_edges(&viewpoint, &mut edges);
    let topology = mesh.artefact::<Topology>("extract", &progress)?;
    let loops = loops_through(&edges, mesh.mesh(), &topology, &viewpoint);
    let found = Extraction {
        method: entry.info.name,
        viewpoint,
        edges: edges.iter().map(|edge| topology.end_points(edge)).collect(),
        boundary: edges.boundary(&topology).map(|edge| topology.end_points(edge)).collect(),
        loops: loops
            .iter()
            .map(|half_edges| half_edges.iter().map(|&h| start_vertex(mesh.mesh(), h)).collect())
            .collect(),
        stats,
        mesh: Arc::clone(mesh.mesh()),
    };
    let bytes = match format {
        Format::Json => json::write(&found)?,
        Format::Obj => obj::write(&found),
        Format::Svg => svg::write(&found, &name, &arguments.camera.camera(&bounds)?),
    };
    output.write(&bytes)
}

/// The loops that hold these edges.
fn loops_through(
    edges: &SilhouetteEdges,
    mesh: &TriangleMesh,
    topology: &Topology,
    viewpoint: &Viewpoint,
) -> SilhouetteLoops {
    let facings = FaceFacings::new(mesh, viewpoint);
    let mut loops = SilhouetteLoops::default();
    LoopWalker::default().walk(topology, &facings, edges, &mut loops);
    loops
}

fn format_of(path: Option<&Path>) -> Result<Format, Failure> {
    let Some(path) = path else { return Ok(Format::Json) };
    match path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase).as_deref() {
        Some("json") => Ok(Format::Json),
        Some("svg") => Ok(Format::Svg),
        Some("obj") => Ok(Format::Obj),
        _ => Err(Failure::Input(format!(
            "{}: unknown kind of output; end its name in .json, .svg or .obj",
            path.display()
        ))),
    }
}

fn extractors() -> String {
    let names = registry::all().iter().filter(|entry| entry.yields != Yields::Lines);
    names.map(|entry| entry.info.name).collect::<Vec<_>>().join(", ")
}
