//! `silhouettes extract`: silhouette edges and loops as data.

mod json;
mod obj;
mod svg;

use crate::args::ExtractArguments;
use crate::failure::Failure;
use crate::input;
use crate::output::Output;
use crate::progress::TerminalProgress;
use silhouette_compare::registry::{Prepared, Registry};
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
pub fn run(arguments: &ExtractArguments, registry: &Registry) -> Result<(), Failure> {
    let format = format_of(arguments.output.as_deref())?;
    let entry = registry.find(&arguments.method.method).map_err(Failure::input)?;
    let info = entry.info();
    if !entry.capabilities().edges {
        let (name, known) = (info.name, registry.names(|entry| entry.capabilities().edges));
        return Err(Failure::Input(format!("--method {name} extracts no edges; choose {known}")));
    }
    let options = OptionValues::parse(info.options, arguments.method.set.iter().map(String::as_str))?;
    let output = Output::create(arguments.output.as_deref(), &[&arguments.mesh])?;
    let progress = TerminalProgress::new();
    let NamedMesh { name, mesh } = input::mesh(&arguments.mesh, &progress)?;
    let bounds = mesh.mesh().bounds().ok_or_else(|| Failure::Input(format!("{name}: has no face")))?;
    let viewpoint = arguments.camera.viewpoint(&bounds)?;

    let prepared = entry.prepare(&mesh, &options, &progress);
    let mut prepared = prepared.map_err(|error| Failure::of_preparation(&name, info.name, error))?;
    let topology = mesh.artefact::<Topology>("extract", &progress)?;
    let (edges, stats) = edges_of(&mut prepared, &viewpoint);
    let loops = loops_of(&mut prepared, &edges, mesh.mesh(), &topology, &viewpoint);
    let found = Extraction {
        method: info.name,
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

/// The edges that a method finds, and what that took.
fn edges_of(prepared: &mut Prepared, viewpoint: &Viewpoint) -> (SilhouetteEdges, ExtractionStats) {
    let mut edges = SilhouetteEdges::default();
    let stats = prepared.edges().map(|method| method.extract_edges(viewpoint, &mut edges));
    (edges, stats.unwrap_or_default())
}

/// The loops that a method finds; of one that finds edges only, the loops that hold these.
fn loops_of(
    prepared: &mut Prepared,
    edges: &SilhouetteEdges,
    mesh: &TriangleMesh,
    topology: &Topology,
    viewpoint: &Viewpoint,
) -> SilhouetteLoops {
    let mut loops = SilhouetteLoops::default();
    if let Some(method) = prepared.loops() {
        method.extract_loops(viewpoint, &mut loops);
    } else {
        LoopWalker::default().walk(topology, &FaceFacings::new(mesh, viewpoint), edges, &mut loops);
    }
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
