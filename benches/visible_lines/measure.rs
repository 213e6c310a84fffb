//! One mesh: prepared for each case with each number of threads, then all of them in turn, a few views at a time.

use crate::row::{CameraNumbers, Counts, LinesRow, Stages};
use crate::threads::Threads;
use silhouette_compare::camera_path::Orbit;
use silhouette_compare::cost::Spread;
use silhouette_compare::machine::describe_machine;
use silhouette_compare::scaling::OURS;
use silhouette_core::glam::DVec3;
use silhouette_core::method::PrepareError;
use silhouette_core::view::{Framing, Projection, ViewError, ViewPreset};
use silhouette_core::{Camera, Cancelled, NoProgress, PreparedMesh, TriangleMesh};
use silhouette_visibility::{Chains, LineError, LineFinder, LineOptions, LineScene, LineStats, Lines, Outline};
use std::collections::BTreeMap;
use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Vertical field of view: that of the command line, which the scripts of benches/peers take over.
const FOV_DEG: f64 = 40.0;

const SIZE: [u32; 2] = [1024, 1024];

/// Why a mesh was not measured.
#[derive(Debug, thiserror::Error)]
pub enum MeasureError {
    #[error("{mesh}: the mesh has no triangle")]
    Empty { mesh: String },
    #[error(transparent)]
    View(#[from] ViewError),
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    #[error(transparent)]
    Lines(#[from] LineError),
}

/// What is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Metric {
    /// Visible lines in perspective.
    Visible,
    /// Visible and hidden lines in perspective.
    All,
    /// The outline alone, in an orthographic view: what other tools yield.
    Outline,
}

impl Metric {
    fn name(self) -> &'static str {
        match self {
            Self::Visible => "visible",
            Self::All => "all",
            Self::Outline => "outline",
        }
    }

    fn framing(self) -> Framing {
        match self {
            Self::Visible | Self::All => Framing::Perspective { fov_y_rad: FOV_DEG.to_radians() },
            Self::Outline => Framing::Orthographic,
        }
    }
}

/// What is measured and how the finder is prepared. Each has a finder of its own, which learns of edges in one view what it
/// knows in the next.
const CASES: [(Metric, &str); 6] = [
    (Metric::Visible, PLAIN),
    (Metric::Visible, MANY_VIEWS),
    (Metric::All, PLAIN),
    (Metric::All, MANY_VIEWS),
    (Metric::Outline, PLAIN),
    (Metric::Outline, MANY_VIEWS),
];

const PLAIN: &str = "plain";
const MANY_VIEWS: &str = "many-views";

/// Views that one finder is timed in before the next takes its turn: other tools, too, draw view after view.
const SEQUENCE: usize = 4;

/// How long it finds the view before those, untimed: until its data are where its last view left them, and the system has
/// put its threads, which waited while others took their turns, on processors of their own.
const WARM_UP: Duration = Duration::from_millis(40);

/// Which views are timed.
const VIEWS: [&str; 2] = ["still", "orbit"];

/// One case with one number of threads.
struct Prepared {
    finder: LineFinder,
    prepare: Duration,
    topology: Duration,
    tree: Duration,
    bytes: u64,
    first: Duration,
    /// For each kind of views.
    cells: [Cell; VIEWS.len()],
}

/// Times and counts over views of one kind.
#[derive(Default)]
struct Cell {
    times_ms: Vec<f64>,
    stats: Vec<LineStats>,
    chains: Vec<f64>,
    points: Vec<f64>,
    length_px: Vec<f64>,
    area_px: Vec<f64>,
}

impl Cell {
    fn push(&mut self, lines: &Lines, took: Duration) {
        self.times_ms.push(milliseconds(took));
        self.stats.push(lines.stats);
        self.chains.push(lines.chains.len() as f64);
        self.points.push(lines.chains.point_count() as f64);
        self.length_px.push(lines.chains.iter().map(|chain| chain.length_px()).sum());
        self.area_px.push(lines.outline.area_px());
    }
}

impl Prepared {
    /// Prepares a mesh that nothing was derived from, and finds the lines of a first view, all on the current threads.
    fn new(mesh: &Arc<TriangleMesh>, case: usize, first: &Camera) -> Result<Self, MeasureError> {
        let prepared = Arc::new(PreparedMesh::new(Arc::clone(mesh)));
        let scene = LineScene::new(Arc::clone(&prepared));
        let start = Instant::now();
        let finder = if CASES[case].1 == PLAIN {
            LineFinder::new(scene, &NoProgress)?
        } else {
            LineFinder::for_many_views(scene, &NoProgress)?
        };
        let prepare = start.elapsed();
        let report = prepared.report();
        let build_time = |name: &str| {
            report.iter().find(|artefact| artefact.name == name).map_or(Duration::ZERO, |artefact| artefact.build_time)
        };
        let mut made = Self {
            prepare,
            topology: build_time("topology"),
            tree: build_time("face-tree"),
            bytes: report.iter().map(|artefact| artefact.bytes as u64).sum(),
            first: Duration::ZERO,
            finder,
            cells: Default::default(),
        };
        let start = Instant::now();
        black_box(made.find(case, first)?);
        made.first = start.elapsed();
        Ok(made)
    }

    fn find(&mut self, case: usize, camera: &Camera) -> Result<Lines, LineError> {
        let max_invisibility = match CASES[case].0 {
            Metric::Visible => 0,
            Metric::All => u32::MAX,
            Metric::Outline => {
                let outline = self.finder.outline(camera, &NoProgress)?;
                let (origin, chains, stats) = (DVec3::ZERO, Chains::default(), LineStats::default());
                return Ok(Lines { camera: *camera, origin, chains, outline, stats });
            }
        };
        self.finder.find(camera, &LineOptions { max_invisibility, ..LineOptions::default() }, &NoProgress)
    }

    /// Times views that follow each other on the current threads, after some runs of the one before them; yields what it
    /// found.
    fn time(
        &mut self,
        case: usize,
        views: usize,
        before: &Camera,
        cameras: &[Camera],
    ) -> Result<Vec<(Chains, Outline)>, LineError> {
        let begun = Instant::now();
        while begun.elapsed() < WARM_UP {
            black_box(self.find(case, before)?);
        }
        let mut found = Vec::with_capacity(cameras.len());
        for camera in cameras {
            let start = Instant::now();
            let lines = black_box(self.find(case, camera)?);
            self.cells[views].push(&lines, start.elapsed());
            found.push((lines.chains, lines.outline));
        }
        Ok(found)
    }
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1000.0
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    Spread::of(&values.collect::<Vec<_>>()).map_or(0.0, |spread| spread.median)
}

/// Measures a mesh in `views` views of an orbit, and as often in the view that peers are given, between them. Rows of one
/// case follow each other.
///
/// # Panics
/// If the lines depend on the number of threads, or on how the finder was prepared: what is wrong is not timed.
pub fn measure_mesh(
    name: &str,
    mesh: TriangleMesh,
    views: u32,
    all_threads: &[Threads],
) -> Result<Vec<LinesRow>, MeasureError> {
    let Some(bounds) = mesh.bounds() else { return Err(MeasureError::Empty { mesh: name.to_owned() }) };
    let mut cameras = BTreeMap::new();
    for (metric, _) in CASES {
        let (direction, up) = ViewPreset::ThreeQuarter.directions();
        let still = Camera::framing(&bounds, direction, up, metric.framing(), SIZE)?;
        cameras.insert(metric, (still, Orbit::turn(metric.framing(), SIZE, views).cameras(&bounds)?));
    }

    let mesh = Arc::new(mesh);
    // Each case with each number of threads: one beside the other.
    let mut runs: Vec<(usize, &Threads, Prepared)> = Vec::new();
    for case in 0..CASES.len() {
        for threads in all_threads {
            runs.push((case, threads, threads.install(|| Prepared::new(&mesh, case, &cameras[&CASES[case].0].0))?));
        }
    }
    let count = runs.len();
    for first in (0..views as usize).step_by(SEQUENCE) {
        for kind in 0..VIEWS.len() {
            let mut expected: BTreeMap<Metric, Vec<(Chains, Outline)>> = BTreeMap::new();
            // Who comes first changes, so that none is always the one behind an idle or a busy moment.
            for place in (0..count).map(|turn| (first / SEQUENCE + turn) % count) {
                let (case, threads, prepared) = &mut runs[place];
                let metric = CASES[*case].0;
                let (still, orbit) = &cameras[&metric];
                let of_orbit = &orbit[first..(first + SEQUENCE).min(orbit.len())];
                let before = &orbit[(first + orbit.len() - 1) % orbit.len()];
                let stills = vec![*still; of_orbit.len()];
                let (before, sequence) = [(still, &stills[..]), (before, of_orbit)][kind];
                let found = threads.install(|| prepared.time(*case, kind, before, sequence))?;
                let expected = expected.entry(metric).or_insert_with(|| found.clone());
                assert!(*expected == found, "{name}: what is found depends on threads or preparation");
            }
        }
    }
    let shared = Shared { mesh: name.to_owned(), faces: mesh.face_count() as u64, machine: describe_machine() };
    let rows_of = |(case, threads, prepared): &(usize, &Threads, Prepared)| {
        let (still, orbit) = &cameras[&CASES[*case].0];
        [still, &orbit[0]]
            .iter()
            .enumerate()
            .map(|(kind, camera)| row(&shared, *case, (kind, camera), threads, prepared))
            .collect::<Vec<_>>()
    };
    Ok(runs.iter().flat_map(rows_of).collect())
}

/// What all rows of a mesh share.
struct Shared {
    mesh: String,
    faces: u64,
    machine: String,
}

fn row(
    shared: &Shared,
    case: usize,
    (kind, camera): (usize, &Camera),
    threads: &Threads,
    prepared: &Prepared,
) -> LinesRow {
    let ((metric, finder), cell) = (CASES[case], &prepared.cells[kind]);
    let spread = Spread::of(&cell.times_ms).expect("at least one view is timed");
    let stage = |of: fn(&LineStats) -> Duration| median(cell.stats.iter().map(|stats| milliseconds(of(stats))));
    let count = |of: fn(&LineStats) -> u64| median(cell.stats.iter().map(|stats| of(stats) as f64));
    LinesRow {
        tool: OURS,
        mesh: shared.mesh.clone(),
        faces: shared.faces,
        metric: metric.name(),
        finder,
        views: VIEWS[kind],
        runs: cell.times_ms.len() as u32,
        threads: threads.count,
        median_ms: spread.median,
        p95_ms: spread.p95,
        first_ms: milliseconds(prepared.first),
        prepare_ms: milliseconds(prepared.prepare),
        topology_ms: milliseconds(prepared.topology),
        tree_ms: milliseconds(prepared.tree),
        prepared_bytes: prepared.bytes,
        stages_ms: Stages {
            extract: stage(|stats| stats.extract),
            project: stage(|stats| stats.project),
            decide: stage(|stats| stats.decide),
            chain: stage(|stats| stats.chain),
        },
        counts: Counts {
            edges: count(|stats| stats.edges),
            contours: count(|stats| stats.contours),
            pairs: count(|stats| stats.pairs),
            events: count(|stats| stats.events),
            sight_lines: count(|stats| stats.sight_lines),
            pieces: count(|stats| stats.pieces),
            chains: median(cell.chains.iter().copied()),
            points: median(cell.points.iter().copied()),
            length_px: median(cell.length_px.iter().copied()),
            area_px: median(cell.area_px.iter().copied()),
        },
        camera: numbers(camera),
        machine: shared.machine.clone(),
    }
}

fn numbers(camera: &Camera) -> CameraNumbers {
    let [eye, target, up] = [camera.eye(), camera.target(), camera.up()].map(|vector| vector.to_array());
    let (fov_deg, height) = match camera.projection() {
        Projection::Perspective { .. } => (Some(FOV_DEG), None),
        Projection::Orthographic { height } => (None, Some(height)),
    };
    CameraNumbers { eye, target, up, fov_deg, height, size: camera.size() }
}
