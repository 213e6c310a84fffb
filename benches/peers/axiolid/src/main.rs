//! Visible and hidden pieces of edges by `axiolid-hidden-lines` and by ours: times, view by view in turn, and whether the
//! pieces agree. Both are exact, by different means, so that this holds one against the other.
//!
//! `cargo run --release --ignore-rust-version -- MESH... [--views 8] [--runs 3] [-o rows.jsonl]`
//!
//! Orthographic views, which are all that it draws: the first along (1, 1, 1), the others around the mesh. Silhouette and
//! boundary edges, on one thread. Timed are visible pieces alone: all that it does, since it prepares nothing, and of ours a
//! view that the finder has seen before, one that a new finder has not, a view of a finder for many views, and the
//! preparation together with a first view. Compared are visible and hidden pieces: for each edge the length that is visible
//! and the length that is drawn.

use axiolid_contracts::ExecutionOptions;
use axiolid_core::{Frame3, Point3, Tolerance, Vec3 as Axis};
use axiolid_hidden_lines::ScalarHiddenLines;
use axiolid_mesh::TriMesh;
use axiolid_mesh_hidden_lines_contract::{
    EdgeSelection, HiddenLineLimits, HiddenLineMesh, HiddenLineOutcome, HiddenLineRequest, MeshHiddenLines, MeshId,
    MeshRole, OrthographicView, Visibility,
};
use clap::Parser;
use serde::Serialize;
use silhouette_compare::camera_path::Orbit;
use silhouette_compare::cost::Spread;
use silhouette_compare::machine::describe_machine;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::mesh::Bounds;
use silhouette_core::topology::Topology;
use silhouette_core::view::Projection;
use silhouette_core::{Camera, NoProgress, PreparedMesh, Viewpoint, load};
use silhouette_visibility::{LineFinder, LineOptions, LineScene, Lines, SegmentSource};
use std::collections::BTreeMap;
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Instant;

/// Steps of an eye's coordinates within its distance: so few that `eye - target` is exact.
const STEPS: f64 = 4096.0;

#[derive(Parser)]
struct Arguments {
    /// Manifold meshes, wound consistently
    #[arg(required = true, value_name = "MESH")]
    meshes: Vec<PathBuf>,
    /// Views, the first of them isometric
    #[arg(long, default_value_t = 8)]
    views: u32,
    /// Runs of each view, of which the fastest counts
    #[arg(long, default_value_t = 3)]
    runs: u32,
    /// JSON Lines file for the rows, one per mesh
    #[arg(short, long)]
    output: Option<PathBuf>,
}

/// One mesh: medians over the views, in milliseconds.
#[derive(Serialize)]
struct Row {
    tool: &'static str,
    mesh: String,
    faces: usize,
    views: u32,
    runs: u32,
    threads: u32,
    /// Its time of a view.
    median_ms: f64,
    /// Ours of a view that the finder has seen, of the first view of a finder, of a view of a finder for many views, and of
    /// the preparation together with a first view.
    ours_seen_ms: f64,
    ours_new_ms: f64,
    ours_many_ms: f64,
    ours_prepared_ms: f64,
    /// Medians of the ratios of its times to ours.
    ratio_seen: f64,
    ratio_new: f64,
    ratio_many: f64,
    ratio_prepared: f64,
    /// Edges in the isometric view, by both.
    iso_edges: [usize; 2],
    agreement: Agreement,
    machine: String,
}

/// How well pieces agree over all views.
#[derive(Serialize, Default)]
struct Agreement {
    /// Edges that one draws and the other does not.
    only_one: usize,
    /// Edges that both draw.
    edges: usize,
    /// Lengths of visible pieces and of all pieces, by both, in object units.
    visible: [f64; 2],
    drawn: [f64; 2],
    /// Largest differences of an edge's visible length and drawn length, in radii of the mesh.
    most_visible: f64,
    most_drawn: f64,
}

/// Visible and drawn length of each edge, by its vertices.
type Pieces = BTreeMap<[u32; 2], [f64; 2]>;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let rows = pool.map_err(Into::into).and_then(|pool| pool.install(|| run(&arguments)));
    match rows.and_then(|rows| write(&rows, &arguments)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("axiolid-lines: {error}");
            ExitCode::FAILURE
        }
    }
}

type Failure = Box<dyn Error + Send + Sync>;

fn write(rows: &[Row], arguments: &Arguments) -> Result<(), Failure> {
    let lines: Vec<String> = rows.iter().map(serde_json::to_string).collect::<Result<_, _>>()?;
    let text = lines.join("\n") + "\n";
    match &arguments.output {
        Some(path) => std::fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))?,
        None => print!("{text}"),
    }
    Ok(())
}

fn run(arguments: &Arguments) -> Result<Vec<Row>, Failure> {
    arguments.meshes.iter().map(|path| measure(path, arguments)).collect()
}

fn measure(path: &PathBuf, arguments: &Arguments) -> Result<Row, Failure> {
    let mesh = Arc::new(load::load(path)?);
    let bounds = mesh.bounds().ok_or("no face")?;
    let theirs = TriMesh::new(
        mesh.positions().iter().map(|p| Point3::new(p.x.into(), p.y.into(), p.z.into())).collect(),
        mesh.triangles().iter().flatten().copied().collect(),
    );
    let topology = Topology::new(&mesh);
    let new_scene = || LineScene::new(Arc::new(PreparedMesh::new(Arc::clone(&mesh))));
    let scene = new_scene();
    let mut plain = LineFinder::new(scene.clone(), &NoProgress)?;
    let mut many = LineFinder::for_many_views(new_scene(), &NoProgress)?;
    let visible_only = LineOptions::default();
    let all = LineOptions { max_invisibility: u32::MAX, ..LineOptions::default() };

    let mut times: [Vec<f64>; 5] = Default::default();
    let (mut agreement, mut iso_edges) = (Agreement::default(), None);
    for camera in cameras(&bounds, arguments.views)? {
        let mut fastest = [f64::INFINITY; 5];
        plain.find(&camera, &visible_only, &NoProgress)?;
        for _ in 0..arguments.runs {
            let mut new = LineFinder::new(scene.clone(), &NoProgress)?;
            let runs: [&mut dyn FnMut() -> Result<(), Failure>; 5] = [
                &mut || draw(&theirs, &camera, false).map(drop),
                &mut || Ok(drop(plain.find(&camera, &visible_only, &NoProgress)?)),
                &mut || Ok(drop(new.find(&camera, &visible_only, &NoProgress)?)),
                &mut || Ok(drop(many.find(&camera, &visible_only, &NoProgress)?)),
                &mut || Ok(drop(LineFinder::new(new_scene(), &NoProgress)?.find(&camera, &visible_only, &NoProgress)?)),
            ];
            for (run, fastest) in runs.into_iter().zip(&mut fastest) {
                let start = Instant::now();
                run()?;
                *fastest = fastest.min(start.elapsed().as_secs_f64() * 1e3);
            }
        }
        times.iter_mut().zip(fastest).for_each(|(times, fastest)| times.push(fastest));
        let pieces = [
            their_pieces(&draw(&theirs, &camera, true)?),
            our_pieces(&plain.find(&camera, &all, &NoProgress)?, &topology),
        ];
        iso_edges.get_or_insert(pieces.each_ref().map(Pieces::len));
        agreement.add(&pieces, bounds.radius);
    }
    let median = |values: &[f64]| Spread::of(values).map_or(0.0, |spread| spread.median);
    let ratio = |ours: usize| median(&times[0].iter().zip(&times[ours]).map(|(a, b)| a / b).collect::<Vec<_>>());
    Ok(Row {
        tool: "axiolid-hidden-lines 0.1.2",
        mesh: path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        faces: mesh.face_count(),
        views: arguments.views,
        runs: arguments.runs,
        threads: 1,
        median_ms: median(&times[0]),
        ours_seen_ms: median(&times[1]),
        ours_new_ms: median(&times[2]),
        ours_many_ms: median(&times[3]),
        ours_prepared_ms: median(&times[4]),
        ratio_seen: ratio(1),
        ratio_new: ratio(2),
        ratio_many: ratio(3),
        ratio_prepared: ratio(4),
        iso_edges: iso_edges.unwrap_or_default(),
        agreement,
        machine: describe_machine(),
    })
}

/// Orthographic cameras that see all of the mesh from directions that 32-bit floats hold exactly.
fn cameras(bounds: &Bounds, views: u32) -> Result<Vec<Camera>, Failure> {
    let distance = (2.0 * bounds.radius).log2().ceil().exp2();
    let exact = |point: DVec3| ((point * STEPS / distance).round() * (distance / STEPS)).as_vec3();
    let target = exact(bounds.center);
    let around = Orbit::eyes(bounds, views.max(2) - 1, 1.0).into_iter().map(|eye| eye.as_dvec3() - bounds.center);
    let directions = std::iter::once(DVec3::ONE).chain(around);
    let camera = |direction: DVec3| {
        let eye = target + exact(direction * (distance / direction.abs().max_element()));
        let projection = Projection::Orthographic { height: 2.2 * bounds.radius };
        Ok(Camera::new(eye, target, Vec3::Y, projection, [1024, 1024])?)
    };
    directions.take(views as usize).map(camera).collect()
}

fn draw(mesh: &TriMesh, camera: &Camera, hidden: bool) -> Result<HiddenLineOutcome, Failure> {
    let Viewpoint::Orthographic { toward_viewer } = camera.viewpoint() else { unreachable!("all are orthographic") };
    // Products and a common factor: so the isometric view is exact.
    let toward = toward_viewer.as_dvec3();
    let right = DVec3::Y.cross(toward);
    let up = toward.cross(right);
    let axis = |axis: DVec3| {
        let unit = axis * axis.length_recip();
        Axis::new(unit.x, unit.y, unit.z)
    };
    let frame = Frame3 { origin: Point3::ZERO, x: axis(right), y: axis(up), z: axis(toward) };
    let meshes = [HiddenLineMesh::new(MeshId(0), MeshRole::Sheet, mesh)];
    let edges = EdgeSelection::new(None).with_hidden(hidden);
    let limits = HiddenLineLimits::new(1, usize::MAX, usize::MAX, usize::MAX, usize::MAX);
    let request = HiddenLineRequest::new(&meshes, OrthographicView::new(frame), edges, limits);
    let options = ExecutionOptions::new(Tolerance::new(1e-9, 1e-9)?);
    ScalarHiddenLines::new().hidden_lines(&request, &options).map_err(|error| format!("{error:?}").into())
}

fn their_pieces(outcome: &HiddenLineOutcome) -> Pieces {
    let mut pieces = Pieces::new();
    for segment in &outcome.segments {
        let length = (segment.end - segment.start).length();
        add(&mut pieces, segment.source.vertices, length, segment.visibility == Visibility::Visible);
    }
    pieces
}

fn our_pieces(lines: &Lines, topology: &Topology) -> Pieces {
    let scale = lines.camera.pixels_per_unit(1.0);
    let mut pieces = Pieces::new();
    for chain in lines.chains.iter() {
        for (index, source) in chain.sources.iter().enumerate() {
            let SegmentSource::Edge(edge) = *source else { unreachable!("only edges are asked for") };
            let [from, to] = chain.segment_pixels(index);
            add(&mut pieces, topology.edges()[edge], from.distance(to) / scale, chain.style.invisibility == 0);
        }
    }
    pieces
}

fn add(pieces: &mut Pieces, vertices: [u32; 2], length: f64, visible: bool) {
    let [visible_length, drawn] = pieces.entry(vertices).or_default();
    *drawn += length;
    *visible_length += if visible { length } else { 0.0 };
}

impl Agreement {
    fn add(&mut self, [theirs, ours]: &[Pieces; 2], radius: f64) {
        self.only_one += theirs.keys().filter(|edge| !ours.contains_key(*edge)).count();
        self.only_one += ours.keys().filter(|edge| !theirs.contains_key(*edge)).count();
        for (index, pieces) in [theirs, ours].into_iter().enumerate() {
            self.visible[index] += pieces.values().map(|[visible, _]| visible).sum::<f64>();
            self.drawn[index] += pieces.values().map(|[_, drawn]| drawn).sum::<f64>();
        }
        for (edge, of_theirs) in theirs {
            let Some(of_ours) = ours.get(edge) else { continue };
            self.edges += 1;
            self.most_visible = self.most_visible.max((of_theirs[0] - of_ours[0]).abs() / radius);
            self.most_drawn = self.most_drawn.max((of_theirs[1] - of_ours[1]).abs() / radius);
        }
    }
}
