//! What tracking saves on an orbit: counted in faces, and in time over brute force with the same facing and completion.
//!
//! `cargo run --release -p silhouette-tracking --example speed -- MESH... [--step DEG] [--frames N]`
//! where MESH is a file or `builtin:NAME`. One thread; each variant flies the whole orbit in turn, so that caches hold what
//! they would in an application; medians are shown.

use silhouette_core::glam::DVec3;
use silhouette_core::{NoProgress, PreparedMesh, SilhouetteLoops, TriangleMesh, Viewpoint, load, shapes};
use silhouette_tracking::{BruteForce, Concavity, FacingPlanes, TestedEdges, TrackedEdges, Tracker, TrackingOptions};
use std::error::Error;
use std::io::Write;
use std::sync::Arc;
use std::time::Instant;

/// The levels of the paper's table, in radians, and Markosian's.
const LEVELS: [Concavity; 7] = [
    Concavity::Above(0.0),
    Concavity::Above(0.01),
    Concavity::Above(0.1),
    Concavity::Above(0.2),
    Concavity::Above(0.5),
    Concavity::Above(1.0),
    Concavity::Ignored,
];

fn main() -> Result<(), Box<dyn Error>> {
    let mut meshes = Vec::new();
    let mut path = Path { step_deg: 0.1, frames: 500, elevation_rad: 0.31, distance_radii: 3.0 };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut value = || words.next().ok_or_else(|| format!("{word} needs a value"));
        match word.as_str() {
            "--elevation" => path.elevation_rad = value()?.parse::<f64>()?.to_radians(),
            "--distance" => path.distance_radii = value()?.parse()?,
            "--step" => path.step_deg = value()?.parse()?,
            "--frames" => path.frames = value()?.parse()?,
            _ => meshes.push(word),
        }
    }
    let mut out = std::io::stdout().lock();
    for name in &meshes {
        let mesh = match name.strip_prefix("builtin:") {
            Some(shape) => shapes::by_name(shape)?,
            None => load::load(name.as_ref())?,
        };
        measure(&mut out, name, mesh, &path)?;
    }
    Ok(())
}

/// A level circle around the mesh.
struct Path {
    step_deg: f64,
    frames: u32,
    /// Above the horizon.
    elevation_rad: f64,
    /// Of the eye from the middle, in radii of the bounding sphere.
    distance_radii: f64,
}

impl Path {
    fn views(&self, mesh: &TriangleMesh) -> Result<Vec<Viewpoint>, Box<dyn Error>> {
        let bounds = mesh.bounds().ok_or("no faces")?;
        let eye = |frame: u32| {
            let (sin, cos) = (self.step_deg.to_radians() * f64::from(frame) + 0.417).sin_cos();
            let (up, level) = self.elevation_rad.sin_cos();
            let direction = DVec3::new(cos * level, up, sin * level);
            Viewpoint::Perspective {
                eye: (bounds.center + direction * (self.distance_radii * bounds.radius)).as_vec3(),
            }
        };
        Ok((0..self.frames.max(2)).map(eye).collect())
    }
}

fn measure(out: &mut impl Write, name: &str, mesh: TriangleMesh, path: &Path) -> Result<(), Box<dyn Error>> {
    let views = path.views(&mesh)?;
    let (step_deg, frames) = (path.step_deg, views.len() as u32);
    let prepared = PreparedMesh::new(mesh);
    let edges = prepared.artefact::<TrackedEdges>("speed", &NoProgress)?;
    let planes = prepared.artefact::<FacingPlanes>("speed", &NoProgress)?;
    let faces = prepared.mesh().face_count() as f64;
    let (concave, border) = (edges.concave().len(), edges.border().len());
    writeln!(out, "{name}: {faces} faces, {concave} concave edges, {border} border edges, {step_deg} deg a frame")?;

    let mut brute_force = BruteForce::new(Arc::clone(prepared.mesh()), Arc::clone(&edges), Arc::clone(&planes));
    let mut trackers = Vec::new();
    for tested_edges in [TestedEdges::All, TestedEdges::Single] {
        for concavity in LEVELS {
            let options = TrackingOptions {
                concavity,
                tested_edges,
                mesh_policy: silhouette_tracking::MeshPolicy::Cut,
                ..TrackingOptions::default()
            };
            let (mesh, edges, planes) = (Arc::clone(prepared.mesh()), Arc::clone(&edges), Arc::clone(&planes));
            trackers.push(Measured::new(Tracker::new(mesh, edges, planes, options)?));
        }
    }
    let mut brute_force_us = Vec::new();
    let (mut loops, mut half_edges) = (0, 0);
    let mut all = Vec::new();
    for view in &views {
        let (us, found) = timed(|| brute_force.update(view));
        brute_force_us.push(us);
        (loops, half_edges) = (loops + found.len(), half_edges + found.half_edges().len());
        all.push(found.half_edges().len());
    }
    for tracker in &mut trackers {
        views.iter().zip(&all).for_each(|(view, &all)| tracker.update(view, all));
    }
    let base = median(&mut brute_force_us);
    let per_frame = |count: usize| count as f64 / f64::from(frames);
    writeln!(
        out,
        "  brute force {base:.1} us, {:.0} half-edges in {:.1} loops",
        per_frame(half_edges),
        per_frame(loops)
    )?;
    writeln!(
        out,
        "  tested level  share  1/share  us  speed-up  edges-missed%  walks  steps  fruitless  strayed  events"
    )?;
    for tracker in &mut trackers {
        tracker.report(out, faces, f64::from(frames - 1), base)?;
    }
    Ok(())
}

struct Measured {
    tracker: Tracker,
    us: Vec<f64>,
    faces: u64,
    walks: [u64; 4],
    missed: f64,
    events: usize,
    brute_force: u32,
}

impl Measured {
    fn new(tracker: Tracker) -> Self {
        Self { tracker, us: Vec::new(), faces: 0, walks: [0; 4], missed: 0.0, events: 0, brute_force: 0 }
    }

    fn update(&mut self, view: &Viewpoint, all: usize) {
        let is_first = self.tracker.loops().is_empty() && self.us.is_empty() && self.brute_force == 0;
        let (us, loops) = timed(|| self.tracker.update(view));
        let found = loops.half_edges().len();
        let stats = *self.tracker.stats();
        self.brute_force += u32::from(stats.brute_force.is_some());
        if is_first {
            return;
        }
        self.us.push(us);
        self.missed += 1.0 - found as f64 / all.max(1) as f64;
        self.faces += stats.faces_evaluated;
        let walks = [stats.walks, stats.walk_steps, stats.fruitless_walks, stats.strayed_walks];
        self.walks.iter_mut().zip(walks).for_each(|(sum, count)| *sum += count);
        self.events += self.tracker.events().len();
    }

    fn report(&mut self, out: &mut impl Write, faces: f64, frames: f64, base: f64) -> std::io::Result<()> {
        let share = self.faces as f64 / frames / faces;
        let us = median(&mut self.us);
        let options = self.tracker.options();
        let [walks, steps, fruitless, strayed] = self.walks.map(|count| count as f64 / frames);
        let (missed, events) = (self.missed / frames * 100.0, self.events as f64 / frames);
        let (tested, level) = (format!("{:?}", options.tested_edges), format!("{:?}", options.concavity));
        let (inverse, speed_up) = (1.0 / share, base / us);
        writeln!(
            out,
            "  {tested:6} {level:11} {share:.4} {inverse:5.2} {us:7.1} {speed_up:5.2}  {missed:6.3}  {walks:.1} {steps:.1} \
             {fruitless:.2} {strayed:.2} {events:.2}  brute-force frames {}",
            self.brute_force
        )
    }
}

fn timed<'a>(work: impl FnOnce() -> &'a SilhouetteLoops) -> (f64, &'a SilhouetteLoops) {
    let start = Instant::now();
    let loops = work();
    (start.elapsed().as_secs_f64() * 1e6, loops)
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
