//! `silhouettes extract`: silhouette edges, loops and curves as data; the edges of every view for viewers.

mod glb;
mod json;
mod obj;
mod svg;

use crate::args::{ExtractArguments, MethodArguments};
use crate::failure::Failure;
use crate::input;
use crate::output::Output;
use crate::progress::TerminalProgress;
use silhouette_compare::registry::{Capabilities, FoundEdges, Prepared, Registry};
use silhouette_compare::runner::NamedMesh;
use silhouette_core::method::{ExtractionStats, OptionValues};
use silhouette_core::{SilhouetteCurves, Topology, TriangleMesh, Viewpoint};
use std::path::Path;
use std::sync::Arc;

/// What was found in one view.
struct Extraction {
    mesh: Arc<TriangleMesh>,
    method: &'static str,
    topology: Arc<Topology>,
    viewpoint: Viewpoint,
    /// Of a method that extracts edges.
    edges: Option<FoundEdges>,
    /// Of a method that extracts curves.
    curves: Option<SilhouetteCurves>,
    stats: ExtractionStats,
}

/// The formats an extraction is written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Json,
    Svg,
    Obj,
}

/// What is to be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Wanted {
    /// What a method finds in one view.
    View(Format),
    /// The edges of every view, as GLB.
    EveryView,
}

/// Runs the command.
pub fn run(arguments: &ExtractArguments, registry: &Registry) -> Result<(), Failure> {
    let format = match wanted(arguments.output.as_deref())? {
        Wanted::View(format) => format,
        Wanted::EveryView => return edges_of_every_view(arguments),
    };
    if arguments.creases.is_some() {
        return Err(Failure::Input("--creases: only a .glb has hard edges; give -o a name that ends in it".into()));
    }
    let entry = registry.find(&arguments.method.method).map_err(Failure::input)?;
    let info = entry.info();
    let extracts = |can: Capabilities| can.edges || can.curves;
    if !extracts(entry.capabilities()) {
        let (name, known) = (info.name, registry.names(|entry| extracts(entry.capabilities())));
        return Err(Failure::Input(format!("--method {name} extracts no edges and no curves; choose {known}")));
    }
    let options = OptionValues::parse(info.options, arguments.method.set.iter().map(String::as_str))?;
    let output = Output::create(arguments.output.as_deref(), std::slice::from_ref(&arguments.mesh))?;
    let progress = TerminalProgress::new();
    let NamedMesh { name, mesh } =
        input::welded(&arguments.mesh, arguments.weld, arguments.orient.winding(false), &progress)?;
    let bounds = mesh.mesh().bounds().ok_or_else(|| Failure::Input(format!("{name}: has no face")))?;
    let viewpoint = arguments.camera.viewpoint(&bounds, mesh.mesh().origin())?;

    let prepared = entry.prepare(&mesh, &options, &progress);
    let mut prepared = prepared.map_err(|error| Failure::of_preparation(&name, info.name, error))?;
    let topology = mesh.artefact::<Topology>("extract", &progress)?;
    let (curves, of_curves) = curves_of(&mut prepared, &viewpoint).unzip();
    let (edges, of_edges) = prepared.find_edges(mesh.mesh(), &topology, &viewpoint).unzip();
    let stats = of_edges.or(of_curves).unwrap_or_default();
    let found =
        Extraction { method: info.name, mesh: Arc::clone(mesh.mesh()), topology, viewpoint, edges, curves, stats };
    let bytes = match format {
        Format::Json => json::write(&found)?,
        Format::Obj => obj::write(&found, &bounds),
        Format::Svg => svg::write(&found, &name, &arguments.camera.camera(&bounds, mesh.mesh().origin())?),
    };
    output.write(&bytes)
}

/// Writes the edges that viewers draw in any view.
fn edges_of_every_view(arguments: &ExtractArguments) -> Result<(), Failure> {
    let MethodArguments { method, set } = &arguments.method;
    if method != MethodArguments::DEFAULT || !set.is_empty() || !arguments.camera.is_default() {
        let mend = "leave out --method, --set and the camera, or choose .json, .svg or .obj";
        return Err(Failure::Input(format!("a .glb holds the edges of every view, whatever finds them; {mend}")));
    }
    let output = Output::create(arguments.output.as_deref(), std::slice::from_ref(&arguments.mesh))?;
    let progress = TerminalProgress::new();
    let mesh = input::welded(&arguments.mesh, arguments.weld, arguments.orient.winding(false), &progress)?;
    if mesh.mesh.mesh().face_count() == 0 {
        return Err(Failure::Input(format!("{}: has no face", mesh.name)));
    }
    output.write(&glb::write(&mesh, arguments.creases.unwrap_or(glb::DEFAULT_CREASE_DEG), &progress)?)
}

/// The curves that a method finds, and what that took.
fn curves_of(prepared: &mut Prepared, viewpoint: &Viewpoint) -> Option<(SilhouetteCurves, ExtractionStats)> {
    let mut curves = SilhouetteCurves::default();
    let stats = prepared.curves()?.extract_curves(viewpoint, &mut curves);
    Some((curves, stats))
}

fn wanted(path: Option<&Path>) -> Result<Wanted, Failure> {
    let Some(path) = path else { return Ok(Wanted::View(Format::Json)) };
    match path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase).as_deref() {
        Some("json") => Ok(Wanted::View(Format::Json)),
        Some("svg") => Ok(Wanted::View(Format::Svg)),
        Some("obj") => Ok(Wanted::View(Format::Obj)),
        Some("glb") => Ok(Wanted::EveryView),
        _ => Err(Failure::Input(format!(
            "{}: unknown kind of output; end its name in .json, .svg, .obj or .glb",
            path.display()
        ))),
    }
}
