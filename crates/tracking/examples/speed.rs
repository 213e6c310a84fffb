//! What tracking saves on an orbit: counted in faces, and in time over brute force with the same facing and completion.
//!
//!     cargo run --release -p silhouette-tracking --example speed -- MESH... [--step DEG] [--frames N] [--repeat N]
//!         [--elevation DEG] [--distance RADII] [--level RAD]
//!
//! where MESH is a file or `builtin:NAME`. The orbit is sampled: twelve arcs evenly around the mesh, each of as many
//! consecutive frames, of which the first is not counted. One thread; variants take turns arc by arc, so that caches
//! hold what they would in an application and a change of the machine's speed meets all alike; they do so several
//! times: a frame's time is its least, and the median over frames is shown.

use silhouette_core::glam::DVec3;
use silhouette_core::{NoProgress, PreparedMesh, SilhouetteLoops, TriangleMesh, Viewpoint, load, shapes};
use silhouette_tracking::{
    BruteForce, Concavity, ConnectivityTable, MeshPolicy, TestedEdges, TrackedEdges, Tracker, TrackerOptions,
    TrackingStats,
};
use std::error::Error;
use std::io::Write;
use std::sync::Arc;
use std::time::Instant;

/// The levels of the paper's table, in radians.
const LEVELS_RAD: [f32; 6] = [0.0, 0.01, 0.1, 0.2, 0.5, 1.0];

/// Arcs that sample the orbit.
const ARCS: u32 = 12;

/// A level circle around the mesh.
struct Path {
    step_deg: f64,
    frames: u32,
    repeat: u32,
    /// Above the horizon.
    elevation_deg: f64,
    /// Of the eye from the middle, in radii of the bounding sphere.
    distance_radii: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut path = Path { step_deg: 0.1, frames: 480, repeat: 3, elevation_deg: 18.0, distance_radii: 3.0 };
    let (mut meshes, mut levels_rad) = (Vec::new(), Vec::new());
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut value = || words.next().ok_or_else(|| format!("{word} needs a value"));
        match word.as_str() {
            "--elevation" => path.elevation_deg = value()?.parse()?,
            "--distance" => path.distance_radii = value()?.parse()?,
            "--step" => path.step_deg = value()?.parse()?,
            "--frames" => path.frames = value()?.parse()?,
            "--repeat" => path.repeat = value()?.parse()?,
            "--level" => levels_rad.push(value()?.parse()?),
            _ => meshes.push(word),
        }
    }
    if levels_rad.is_empty() {
        levels_rad.extend(LEVELS_RAD);
    }
    let mut out = std::io::stdout().lock();
    for name in &meshes {
        let mesh = match name.strip_prefix("builtin:") {
            Some(shape) => shapes::by_name(shape)?,
            None => load::load(name.as_ref())?,
        };
        measure(&mut out, name, mesh, &path, &levels_rad)?;
    }
    Ok(())
}

impl Path {
    fn arcs(&self, mesh: &TriangleMesh) -> Result<Vec<Vec<Viewpoint>>, Box<dyn Error>> {
        let bounds = mesh.bounds().ok_or("no faces")?;
        let (up, level) = self.elevation_deg.to_radians().sin_cos();
        let view = |angle_deg: f64| {
            let (sin, cos) = angle_deg.to_radians().sin_cos();
            let direction = DVec3::new(cos * level, up, sin * level);
            let eye = bounds.center + direction * (self.distance_radii * bounds.radius);
            Viewpoint::Perspective { eye: eye.as_vec3() }
        };
        let arc = |arc: u32| {
            let begin_deg = 24.0 + 360.0 * f64::from(arc) / f64::from(ARCS);
            (0..=self.frames / ARCS).map(|frame| view(begin_deg + self.step_deg * f64::from(frame))).collect()
        };
        Ok((0..ARCS).map(arc).collect())
    }
}

fn measure(
    out: &mut impl Write,
    name: &str,
    mesh: TriangleMesh,
    path: &Path,
    levels_rad: &[f32],
) -> Result<(), Box<dyn Error>> {
    let arcs = path.arcs(&mesh)?;
    let prepared = PreparedMesh::new(mesh);
    let edges = prepared.artefact::<TrackedEdges>("speed", &NoProgress)?;
    let table = prepared.artefact::<ConnectivityTable>("speed", &NoProgress)?;
    let faces = prepared.mesh().face_count();
    let (concave, boundary) = (edges.concave().len(), edges.boundary().len());
    let step_deg = path.step_deg;
    writeln!(
        out,
        "{name}: {faces} faces, {concave} concave and {boundary} boundary edges, {step_deg} degrees a frame"
    )?;

    let shared = || (Arc::clone(prepared.mesh()), Arc::clone(&table), Arc::clone(&edges));
    let (mesh, table_of, edges_of) = shared();
    let brute_force = BruteForce::new(mesh, table_of, edges_of);
    let in_fours = brute_force.clone().in_fours();
    let mut fliers = vec![Flier::BruteForce(Box::new(brute_force)), Flier::BruteForce(Box::new(in_fours))];
    for tested_edges in [TestedEdges::All, TestedEdges::Single] {
        for &level_rad in levels_rad {
            let concavity = Concavity::Above(level_rad);
            let mesh_policy = MeshPolicy::Cut;
            let options = TrackerOptions { concavity, tested_edges, mesh_policy, ..TrackerOptions::default() };
            let (mesh, table, edges) = shared();
            fliers.push(Flier::Tracker(Box::new(Tracker::new(mesh, table, edges, options)?)));
        }
    }
    let flown = fly(&arcs, path.repeat, &mut fliers);
    let base = &flown[0];
    let frames = base.frame_us.len() as f64;
    let (base_us, all) = (base.median_us(), base.half_edges as f64);
    let (half_edges, loops) = (all / frames, base.loops as f64 / frames);
    writeln!(out, "brute force: {base_us:.1} us, {half_edges:.0} half-edges in {loops:.1} loops")?;
    writeln!(out, "brute force, four faces at a time: {:.1} us", flown[1].median_us())?;
    writeln!(out, "tested                level  1/share     us  speed-up  missed%  loops  walks  steps  fresh")?;
    for (flier, flown) in fliers.iter().zip(&flown) {
        let Flier::Tracker(tracker) = flier else { continue };
        let us = flown.median_us();
        let per_share = frames * faces as f64 / flown.stats.faces_evaluated as f64;
        let (speed_up, missed) = (base_us / us, 100.0 * (1.0 - flown.half_edges as f64 / all));
        let counts = [flown.loops as u64, flown.stats.walks, flown.stats.walk_steps];
        let [loops, walks, steps] = counts.map(|count| count as f64 / frames);
        let TrackerOptions { tested_edges, concavity, .. } = tracker.options();
        let (tested, level, fresh) = (format!("{tested_edges:?}"), format!("{concavity:?}"), flown.fresh_frames);
        writeln!(
            out,
            "{tested:6} {level:>20} {per_share:8.2} {us:6.1} {speed_up:9.2} {missed:8.3} {loops:6.1} {walks:6.1} \
             {steps:6.1} {fresh:6}"
        )?;
    }
    Ok(())
}

/// What the frames of an orbit took together.
struct Flown {
    /// The least time of each frame.
    frame_us: Vec<f64>,
    stats: TrackingStats,
    loops: usize,
    half_edges: usize,
    /// Frames that were found by brute force.
    fresh_frames: usize,
}

impl Flown {
    fn new(frames: usize) -> Self {
        let (frame_us, stats) = (vec![f64::INFINITY; frames], TrackingStats::default());
        Self { frame_us, stats, loops: 0, half_edges: 0, fresh_frames: 0 }
    }

    fn count(&mut self, stats: &TrackingStats) {
        self.stats.faces_evaluated += stats.faces_evaluated;
        self.stats.walks += stats.walks;
        self.stats.walk_steps += stats.walk_steps;
        self.fresh_frames += usize::from(stats.brute_force.is_some());
    }

    fn median_us(&self) -> f64 {
        let mut sorted = self.frame_us.clone();
        sorted.sort_unstable_by(f64::total_cmp);
        sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN)
    }
}

/// What flies an orbit.
enum Flier {
    BruteForce(Box<BruteForce>),
    Tracker(Box<Tracker>),
}

impl Flier {
    fn start(&mut self) {
        if let Self::Tracker(tracker) = self {
            tracker.reset();
        }
    }

    fn frame(&mut self, view: &Viewpoint) -> &SilhouetteLoops {
        match self {
            Self::BruteForce(brute_force) => brute_force.update(view),
            Self::Tracker(tracker) => tracker.update(view),
        }
    }

    fn stats(&self) -> &TrackingStats {
        match self {
            Self::BruteForce(brute_force) => brute_force.stats(),
            Self::Tracker(tracker) => tracker.stats(),
        }
    }
}

fn fly(arcs: &[Vec<Viewpoint>], repeat: u32, fliers: &mut [Flier]) -> Vec<Flown> {
    let frames: usize = arcs.iter().map(|arc| arc.len() - 1).sum();
    let mut flown: Vec<Flown> = fliers.iter().map(|_| Flown::new(frames)).collect();
    for round in 0..repeat.max(1) {
        let mut first_frame = 0;
        for arc in arcs {
            for (flier, flown) in fliers.iter_mut().zip(&mut flown) {
                flier.start();
                flier.frame(&arc[0]);
                for (frame, view) in arc[1..].iter().enumerate() {
                    let start = Instant::now();
                    let loops = flier.frame(view);
                    let us = start.elapsed().as_secs_f64() * 1e6;
                    let least_us = &mut flown.frame_us[first_frame + frame];
                    *least_us = least_us.min(us);
                    if round == 0 {
                        flown.loops += loops.len();
                        flown.half_edges += loops.half_edges().len();
                        flown.count(flier.stats());
                    }
                }
            }
            first_frame += arc.len() - 1;
        }
    }
    flown
}
