//! `silhouettes lines`: visible and hidden lines as SVG, PDF, DXF or HP-GL, as JSON, or as glTF.

mod arguments;
mod format;
mod parts;
mod quick;
mod section;
mod smooth;
mod stats;
mod surprises;
mod views;

pub use arguments::LinesArguments;

use arguments::HealDistance;
use format::{Format, PageFormat};
use parts::Parts;

use crate::failure::{Failure, note};
use crate::input;
use crate::mesh_argument::MeshArgument;
use crate::output::Output;
use crate::progress::TerminalProgress;
use silhouette_core::heal::{NEAR_SHARE, heal_t_junctions};
use silhouette_core::load::LabelledMesh;
use silhouette_core::mesh::Bounds;
use silhouette_core::origin::common_origin;
use silhouette_core::{EdgeId, Topology, TriangleMesh, VertexId};
use silhouette_visibility::plot::{self, Fit, PlotError, PlotOptions};
use silhouette_visibility::{LineError, LineScene, Lines};
use std::time::Instant;

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
    let progress = TerminalProgress::new();

    let started = Instant::now();
    let (mut meshes, parts) = meshes(arguments, &progress)?;
    let names = meshes.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>().join(", ");
    options.object_names = parts.names().to_vec();
    let bounds = bounds(&meshes, parts.masks(&meshes).as_deref());
    let bounds = bounds.ok_or_else(|| {
        let all_masked = meshes.iter().any(|(_, loaded)| loaded.mesh.face_count() > 0);
        let reason = if all_masked { "--mask hides all that could be drawn; name fewer parts" } else { "has no face" };
        Failure::Input(format!("{names}: {reason}"))
    })?;
    let section_edges = section::cut(&mut meshes, arguments.sections(), &names)?;
    let scene = scene_of(&meshes, arguments.wants_materials(), &names)?;
    let scene = scene.with_section_edges(section_edges).map_err(Failure::input)?;
    let masks = parts.masks(&meshes);
    let drawn = masks.as_ref().map(|masks| parts::without_masks(&scene, masks)).transpose()?;
    let views = views::Views::of(arguments, &bounds, scene.mesh().mesh().origin())?;
    for camera in views.cameras() {
        options.check(camera).map_err(of_plotting)?;
    }
    let topology = scene.mesh().artefact::<Topology>("lines", &progress)?;
    let each: Vec<_> = meshes.iter().map(|(name, _)| name.as_str()).collect();
    surprises::note_meshes(&scene, &topology, &each, arguments);
    let load = started.elapsed();

    let shown = views::Shown { names: &names, meshes: &meshes, parts: &parts, scene: &scene, masks, drawn };
    let (prepare, lines) = views.find(&shown, arguments, matches!(format, Format::Page(_)), &progress)?;

    let mut bytes = Vec::new();
    let mut drawing = None;
    match format {
        Format::Page(format) => {
            let drawing = drawing.insert(views.plot(&lines, arguments, &options, &progress)?);
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
        Format::Json => bytes = json(&lines[0], &options, &scene, &meshes, &progress)?,
        Format::Gltf(container) => {
            plot::write_gltf(&lines[0], &options, container, &mut bytes).map_err(Failure::run)?;
        }
    }
    surprises::note_empty(&scene, &lines[0], drawing.as_ref(), arguments);
    if arguments.stats {
        stats::print(&stats::Report { load, prepare, lines: &lines, drawing: drawing.as_ref(), bytes: bytes.len() });
    }
    output.write(&bytes)
}

/// What the meshes span together but for masks, before they are cut, so that pictures with and without a section lie upon each
/// other.
fn bounds(meshes: &[(String, LabelledMesh)], is_mask: Option<&[bool]>) -> Option<Bounds> {
    let faces = meshes.iter().flat_map(|(_, loaded)| {
        let positions = loaded.mesh.positions();
        loaded.mesh.triangles().iter().map(move |corners| corners.map(|vertex| positions[vertex as usize]))
    });
    let drawn: Vec<_> = faces.enumerate().filter(|(face, _)| !is_mask.is_some_and(|masks| masks[*face])).collect();
    Bounds::of(drawn.iter().flat_map(|(_, corners)| *corners))
}

/// The meshes with their names, welded and healed if that is asked for, and what their parts are.
fn meshes(
    arguments: &LinesArguments,
    progress: &TerminalProgress,
) -> Result<(Vec<(String, LabelledMesh)>, Parts), Failure> {
    let mut meshes = input::labelled_meshes(&arguments.meshes, progress)?;
    let parts = parts::select(&mut meshes, &arguments.parts, arguments.smooth, progress)?;
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
    for (name, loaded) in meshes.iter_mut().filter(|(_, loaded)| loaded.mesh.origin() != origin) {
        loaded.mesh = loaded.mesh.relative_to(origin).map_err(Failure::input)?;
        input::note_rounding(name, &loaded.mesh);
    }
    // Lines are right whichever way faces point, and so are their kinds.
    let winding = arguments.orient.winding(false);
    for (name, loaded) in &mut meshes {
        winding.apply(name, loaded, progress)?;
    }
    Ok((meshes, parts))
}

/// Mends the T-junctions of a mesh.
fn heal(name: &str, loaded: &mut LabelledMesh, distance: HealDistance) -> Result<(), Failure> {
    let distance = match distance {
        HealDistance::Units(distance) => distance,
        HealDistance::Auto => {
            let extent = loaded.mesh.bounds().map_or(0.0, |bounds| (bounds.max - bounds.min).max_element());
            (extent * NEAR_SHARE) as f32
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
    if let Some(parts) = &mut loaded.parts {
        *parts = parts.of_faces(healed.face_of.iter().copied());
    }
    loaded.mesh = healed.mesh;
    Ok(())
}

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
