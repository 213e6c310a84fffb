//! `silhouettes lines`: visible and hidden lines as SVG, PDF, DXF or HP-GL, as JSON, or as glTF.

mod arguments;
mod format;
mod parts;
mod quick;
mod section;
mod shown;
mod smooth;
mod stats;
mod surprises;
mod views;

pub use arguments::LinesArguments;
pub use shown::{Shown, changed};

use format::{Format, PageFormat};

use crate::failure::{Failure, note, with_notes};
use crate::input;
use crate::mesh_argument::MeshArgument;
use crate::observer::{self, observed};
use crate::output::Output;
use crate::progress::TerminalProgress;
use silhouette_core::load::LabelledMesh;
use silhouette_core::{EdgeId, Progress, Topology, VertexId};
use silhouette_visibility::plot::{self, Fit, PlotError, PlotOptions};
use silhouette_visibility::{LineError, LineScene, Lines};
use std::time::Instant;

/// Runs the command.
pub fn run(arguments: &LinesArguments) -> Result<(), Failure> {
    with_threads(arguments.threads, || draw(arguments, None, &TerminalProgress::new()))
}

/// Writes the file of meshes that the caller has in memory, in place of those that are named.
pub fn write(
    arguments: &LinesArguments,
    meshes: Vec<(String, LabelledMesh)>,
    progress: &dyn Progress,
) -> Result<(), Failure> {
    with_threads(arguments.threads, || draw(arguments, Some(meshes), progress))
}

/// Works with so many threads, or with as many as the machine runs.
fn with_threads(threads: Option<u16>, work: impl FnOnce() -> Result<(), Failure> + Send) -> Result<(), Failure> {
    let Some(threads) = threads else { return work() };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(usize::from(threads)).build();
    // Whoever observes the calling thread observes its work, and gets its notes.
    let observer = observer::current();
    let (done, notes) = pool.map_err(Failure::run)?.install(|| match observer {
        Some(observer) => observed(observer, || with_notes(work)),
        None => with_notes(work),
    });
    notes.into_iter().for_each(note);
    done
}

fn draw(
    arguments: &LinesArguments,
    in_memory: Option<Vec<(String, LabelledMesh)>>,
    progress: &dyn Progress,
) -> Result<(), Failure> {
    let format = Format::of(arguments.output.as_deref())?;
    let mut options = arguments.plot_options()?;
    if arguments.views.views.is_some() && !matches!(format, Format::Page(_)) {
        let mend = "end the output's name in .svg, .pdf, .dxf or .hpgl";
        return Err(Failure::Input(format!("--views: several views need a page; {mend}")));
    }
    if arguments.views.views.is_some() && options.sheet.is_some_and(|sheet| sheet.fit == Fit::View) {
        return Err(Failure::Input(
            "--views: several views are as large as their lines allow; leave out --fit view".into(),
        ));
    }
    if options.fill.is_some() && !format.fills() {
        note("--fill: only SVG, PDF and DXF have fills; nothing is filled");
    }
    let masks = arguments.parts.mask.iter().map(|mask| MeshArgument::from(mask.as_str()));
    let inputs: Vec<MeshArgument> = arguments.meshes.iter().cloned().chain(masks).collect();
    let output = Output::create(arguments.output.as_deref(), &inputs)?;

    let started = Instant::now();
    let meshes = match in_memory {
        Some(meshes) => meshes,
        None => input::labelled_meshes(&arguments.meshes, progress)?,
    };
    let shown = Shown::of(meshes, arguments, progress)?;
    let Shown { names, meshes, scene, .. } = &shown;
    options.object_names = shown.parts.names().to_vec();
    let views = views::Views::of(arguments, &shown.bounds, scene.mesh().mesh().origin())?;
    for camera in views.cameras() {
        options.check(camera).map_err(of_plotting)?;
    }
    let topology = scene.mesh().artefact::<Topology>("lines", progress)?;
    let each: Vec<_> = meshes.iter().map(|(name, _)| name.as_str()).collect();
    surprises::note_meshes(scene, &topology, &each, arguments);
    let load = started.elapsed();

    let (prepare, lines) = views.find(&shown, arguments, matches!(format, Format::Page(_)), progress)?;

    let mut bytes = Vec::new();
    let mut drawing = None;
    match format {
        Format::Page(format) => {
            let drawing = drawing.insert(views.plot(&lines, arguments, &options, progress)?);
            tell_what_is_cut_off(drawing, &options);
            let title = format!("Lines of {names}");
            let written = match format {
                PageFormat::Svg => drawing.write_svg(&title, &mut bytes),
                PageFormat::Pdf => drawing.write_pdf(&title, &mut bytes),
                PageFormat::Dxf => drawing.write_dxf(&mut bytes),
                PageFormat::Hpgl => drawing.write_hpgl(&mut bytes),
            };
            written.map_err(Failure::run)?;
        }
        Format::Json => bytes = json(&lines[0], &options, scene, meshes, progress)?,
        Format::Gltf(container) => {
            plot::write_gltf(&lines[0], &options, container, &mut bytes).map_err(Failure::run)?;
        }
    }
    surprises::note_empty(scene, &lines[0], drawing.as_ref(), arguments);
    if arguments.stats {
        stats::print(&stats::Report { load, prepare, lines: &lines, drawing: drawing.as_ref(), bytes: bytes.len() });
    }
    output.write(&bytes)
}

/// The document, with each object's vertices numbered as in its own file, or as welded.
fn json(
    lines: &Lines,
    options: &PlotOptions,
    scene: &LineScene,
    meshes: &[(String, LabelledMesh)],
    progress: &dyn Progress,
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
    // Objects may be parts of meshes, so that the vertex says which mesh it is of.
    let of_its_mesh = |vertex: VertexId| {
        let mesh = firsts.partition_point(|&first| first <= vertex.get()) - 1;
        VertexId::new(vertex.get() - firsts[mesh])
    };
    let end_points = |edge: EdgeId| topology.end_points(edge).map(of_its_mesh);
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
pub fn of_finding(names: &str, error: LineError) -> Failure {
    match error {
        LineError::Cancelled(error) => error.into(),
        other => Failure::Input(format!("{names}: {other}")),
    }
}
