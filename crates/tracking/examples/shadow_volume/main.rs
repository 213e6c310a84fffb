//! Shadow volumes from tracked silhouette loops, checked for closedness and counted against ray casts.
//!
//!     cargo run --release -p silhouette-tracking --example shadow_volume -- [MESH [FRAMES]]
//!
//! where MESH is a file or `builtin:NAME`. A light goes around the mesh, a degree a frame; its loops are tracked from
//! frame to frame and extruded. `volume` (with `facings`) is what to lift out into a renderer, `check` how it is known
//! to be right. Exit codes: 0 done, 1 a check or the output failed, 2 bad input.

mod check;
mod facings;
#[cfg(test)]
mod tests;
mod volume;

use check::{EdgeCount, LitScene, ShadowCount, Surface, count_edges, count_shadows};
use silhouette_core::glam::DVec3;
use silhouette_core::mesh::Bounds;
use silhouette_core::{NoProgress, PreparedMesh, TriangleMesh, Viewpoint, load, shapes};
use silhouette_tracking::{Accuracy, ConnectivityTable, MeshPolicy, TrackedEdges, Tracker, TrackerOptions};
use std::error::Error;
use std::io::Write;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::{Duration, Instant};
use volume::{Caps, Reach, ShadowVolume};

const DEFAULT_MESH: &str = "builtin:knot";
const DEFAULT_FRAMES: u32 = 90;
/// Of the light from the middle of the mesh, in radii of the mesh.
const LIGHT_DISTANCE: f64 = 2.6;
/// How far volumes reach where they are finite, in radii: beyond every point that the check looks at.
const FINITE_REACH: f64 = 9.0;
/// Frames of each row that are checked, and at how many points.
const CHECKED_FRAMES: u32 = 4;
const SAMPLES: u32 = 60;

/// Why the program ends early.
#[derive(Debug, thiserror::Error)]
enum Failure {
    #[error("{0}")]
    BadInput(Box<dyn Error>),
    #[error("{0}")]
    Run(Box<dyn Error>),
}

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let failure = match run(&words, &mut std::io::stdout().lock()) {
        Ok(()) => return ExitCode::SUCCESS,
        Err(failure) => failure,
    };
    // Nobody is left to be told if that fails too.
    let _ = writeln!(std::io::stderr(), "shadow_volume: {failure}");
    ExitCode::from(if matches!(failure, Failure::BadInput(_)) { 2 } else { 1 })
}

fn run(words: &[String], out: &mut impl Write) -> Result<(), Failure> {
    let (name, frames) = arguments(words).map_err(|error| Failure::BadInput(error.into()))?;
    let mesh = read(name).map_err(Failure::BadInput)?;
    let scene = Scene::new(mesh).map_err(Failure::BadInput)?;
    report(out, name, &scene, frames).map_err(Failure::Run)
}

/// The mesh's name and the number of frames.
fn arguments(words: &[String]) -> Result<(&str, u32), String> {
    let frames = match words.get(1) {
        None => DEFAULT_FRAMES,
        Some(word) => {
            let frames = word.parse().ok().filter(|&frames| frames > 0);
            frames.ok_or_else(|| format!("FRAMES cannot be '{word}'; give a whole number from 1"))?
        }
    };
    if let Some(word) = words.get(2) {
        return Err(format!("'{word}' is one argument too many; usage: shadow_volume [MESH [FRAMES]]"));
    }
    Ok((words.first().map_or(DEFAULT_MESH, String::as_str), frames))
}

fn read(name: &str) -> Result<TriangleMesh, Box<dyn Error>> {
    Ok(match name.strip_prefix("builtin:") {
        Some(shape) => shapes::by_name(shape)?,
        None => load::load(name.as_ref())?,
    })
}

/// A mesh with all that its trackers and volumes share.
struct Scene {
    mesh: Arc<TriangleMesh>,
    edges: Arc<TrackedEdges>,
    table: Arc<ConnectivityTable>,
    bounds: Bounds,
}

impl Scene {
    fn new(mesh: TriangleMesh) -> Result<Self, Box<dyn Error>> {
        let bounds = mesh.bounds().ok_or("the mesh has no faces, so it casts no shadow; give one that has")?;
        let prepared = PreparedMesh::new(mesh);
        let edges = prepared.artefact("shadow_volume", &NoProgress)?;
        let table = prepared.artefact("shadow_volume", &NoProgress)?;
        Ok(Self { mesh: Arc::clone(prepared.mesh()), edges, table, bounds })
    }

    /// Edges that cannot be tracked across are cut: each of their faces has a boundary edge there.
    fn tracker(&self) -> Result<Tracker, Box<dyn Error>> {
        // A volume is closed only if no loop is missing.
        let accuracy = Accuracy::Exact;
        let options = TrackerOptions { accuracy, mesh_policy: MeshPolicy::Cut, ..TrackerOptions::default() };
        Ok(Tracker::new(Arc::clone(&self.mesh), Arc::clone(&self.table), Arc::clone(&self.edges), options)?)
    }

    fn volume(&self, caps: Caps, reach: Reach) -> Result<ShadowVolume, Box<dyn Error>> {
        Ok(ShadowVolume::new(Arc::clone(&self.mesh), Arc::clone(&self.table), caps, reach)?)
    }

    /// Every rule that is valid for this mesh.
    fn rules(&self) -> &'static [Caps] {
        match Caps::fitting(&self.table, &self.mesh) {
            Caps::FrontAndBack => &[Caps::FrontAndBack, Caps::FrontTwice, Caps::Doubled],
            Caps::FrontTwice | Caps::Doubled => &[Caps::FrontTwice, Caps::Doubled],
        }
    }

    fn reaches(&self) -> [Reach; 2] {
        [Reach::Infinite, Reach::Finite { distance: (FINITE_REACH * self.bounds.radius) as f32 }]
    }

    /// The light of one frame.
    fn light(&self, kind: LightKind, angle_deg: f64) -> Viewpoint {
        let (sin, cos) = (angle_deg + 24.0).to_radians().sin_cos();
        let toward = DVec3::new(cos, 0.61 + 0.3 * sin, sin).normalize();
        match kind {
            LightKind::Point => {
                let eye = self.bounds.center + toward * (LIGHT_DISTANCE * self.bounds.radius);
                Viewpoint::Perspective { eye: eye.as_vec3() }
            }
            LightKind::Directional => Viewpoint::Orthographic { toward_viewer: toward.as_vec3() },
        }
    }
}

#[derive(Debug, Clone, Copy)]
enum LightKind {
    Point,
    Directional,
}

/// What the frames of one row said.
#[derive(Default)]
struct Row {
    track: Vec<Duration>,
    extrude: Vec<Duration>,
    loops: usize,
    /// Triangles of the last frame: front cap, sides, back cap.
    triangles: [usize; 3],
    edges: EdgeCount,
    shadows: ShadowCount,
}

fn report(out: &mut impl Write, name: &str, scene: &Scene, frames: u32) -> Result<(), Box<dyn Error>> {
    let (faces, cuts) = (scene.mesh.face_count(), scene.table.defects().len());
    let fitting = Caps::fitting(&scene.table, &scene.mesh);
    let kind = if fitting == Caps::FrontAndBack { "closed" } else { "open" };
    writeln!(out, "{name}: {faces} faces, {kind}, {cuts} edges cut; caps that fit: {fitting:?}; {frames} frames")?;
    writeln!(
        out,
        "light        caps          reach     track us  extrude us  loops    front    sides     back  multiple  \
         unmatched  points  shadow  skipped  wrong"
    )?;
    let mut bad = 0;
    for kind in [LightKind::Point, LightKind::Directional] {
        for &caps in scene.rules() {
            for reach in scene.reaches() {
                let row = fly(scene, kind, caps, reach, frames)?;
                let [kind, caps] = [format!("{kind:?}"), format!("{caps:?}")];
                let reach = if reach == Reach::Infinite { "infinite" } else { "finite" };
                let (track_us, extrude_us) = (median_us(row.track), median_us(row.extrude));
                let (loops, [front, sides, back]) = (row.loops as f64 / f64::from(frames), row.triangles);
                let EdgeCount { multiple, unmatched, .. } = row.edges;
                let ShadowCount { samples, shadowed, skipped, wrong } = row.shadows;
                writeln!(
                    out,
                    "{kind:11}  {caps:12}  {reach:8}  {track_us:8.1}  {extrude_us:10.1}  {loops:5.1}  {front:7}  \
                     {sides:7}  {back:7}  {multiple:8}  {unmatched:9}  {samples:6}  {shadowed:6}  {skipped:7}  \
                     {wrong:5}"
                )?;
                bad += unmatched + wrong as usize;
            }
        }
    }
    if bad > 0 {
        return Err("a volume is open, or disagrees with ray casts: see the columns 'unmatched' and 'wrong'".into());
    }
    Ok(())
}

/// Takes a light around the mesh and extrudes its loops, one volume for all frames.
fn fly(scene: &Scene, kind: LightKind, caps: Caps, reach: Reach, frames: u32) -> Result<Row, Box<dyn Error>> {
    let (mut tracker, mut volume) = (scene.tracker()?, scene.volume(caps, reach)?);
    let mut row = Row::default();
    let checked_every = frames.div_ceil(CHECKED_FRAMES);
    for frame in 0..frames {
        let light = scene.light(kind, f64::from(frame));
        let start = Instant::now();
        let loops = tracker.update(&light);
        row.track.push(start.elapsed());
        let start = Instant::now();
        volume.extrude(&light, loops);
        row.extrude.push(start.elapsed());
        row.loops += loops.len();
        row.triangles = [volume.front_cap().len(), volume.sides().len(), volume.back_cap().len()];
        if frame % checked_every == 0 {
            let surface = Surface { positions: volume.positions(), triangles: volume.triangles() };
            let lit = LitScene { mesh: &scene.mesh, light: &light, caps };
            row.edges.add(count_edges(surface.triangles));
            row.shadows.add(count_shadows(surface, lit, SAMPLES));
        }
    }
    Ok(row)
}

fn median_us(mut times: Vec<Duration>) -> f64 {
    times.sort_unstable();
    times.get(times.len() / 2).map_or(f64::NAN, |time| time.as_secs_f64() * 1e6)
}
