//! What exact visible lines cost, and how often pictures decide otherwise:
//! `cargo run --release --example visible_lines -- MESH...`
//!
//! Each mesh is seen in six views around it at 512 x 512 pixels. Times are the best of three, and of them the median over
//! the views. Disagreements are shares of length in pixels, over all views: a depth picture of 4 x 4 samples per pixel against
//! the exact decision on every silhouette edge, visible or hidden; the quick mode's lines, from ids at 1 and 2 pixels per
//! pixel, against the exact ones.

mod depth_buffer;
mod nearness;
mod stretches;

use depth_buffer::{Disagreement, disagreement};
use nearness::Nearness;
use silhouette_compare::camera_path::Orbit;
use silhouette_compare::truth::finder::silhouette_options;
use silhouette_compare::truth::{TruthFinder, pen};
use silhouette_core::view::{Camera, Framing};
use silhouette_core::{NoProgress, PreparedMesh, Topology, load};
use silhouette_gpu::{MeshBuffers, Pen, PenPlacement};
use silhouette_render::{AdapterChoice, DEFAULT_SUPERSAMPLING, FaceIdPass, Gpu, ReferenceRenderer};
use silhouette_visibility::{FaceIds, LineOptions, LineScene, QuickLineFinder};
use std::error::Error;
use std::sync::Arc;
use std::time::Instant;
use stretches::Stretches;

const PEN: Pen = Pen { width_px: 2.0, placement: PenPlacement::Centred };

/// Views around a mesh.
const VIEWS: u32 = 6;

/// Pictures in pixels.
const SIZE: [u32; 2] = [512; 2];

/// Pixels of the id picture along each side of a pixel.
const SCALES: [u32; 2] = [1, 2];

/// A difference this close to a line that is there hardly shows in a picture.
const NEAR_PX: f64 = 1.0;

/// How often a time is taken, for its best.
const REPEATS: u32 = 3;

/// Lengths in pixels of what the quick mode drew.
#[derive(Default, Clone, Copy)]
struct Quick {
    missed_px: f64,
    missed_far_off_px: f64,
    extra_px: f64,
    extra_far_off_px: f64,
}

/// What a mesh showed, times in milliseconds per view.
#[derive(Default)]
struct Seen {
    truth_ms: Vec<f64>,
    pen_ms: Vec<f64>,
    lines_ms: Vec<f64>,
    ids_ms: [Vec<f64>; 2],
    quick_ms: [Vec<f64>; 2],
    visible_px: f64,
    depth: Disagreement,
    quick: [Quick; 2],
}

fn main() -> Result<(), Box<dyn Error>> {
    let gpu = Gpu::new(AdapterChoice::from_env()?)?;
    for path in std::env::args().skip(1) {
        let mesh = Arc::new(PreparedMesh::new(load::load(path.as_ref())?));
        let bounds = mesh.mesh().bounds().ok_or("the mesh has no face")?;
        let framing = Framing::Perspective { fov_y_rad: 45.0_f64.to_radians() };
        let views = Orbit::turn(framing, SIZE, VIEWS).cameras(&bounds)?;
        print(&path, mesh.mesh().face_count(), &look(&gpu, &mesh, &views)?);
    }
    Ok(())
}

fn look(gpu: &Gpu, mesh: &Arc<PreparedMesh>, views: &[Camera]) -> Result<Seen, Box<dyn Error>> {
    let topology = mesh.artefact::<Topology>("visible lines", &NoProgress)?;
    let mut truth = TruthFinder::new(mesh, &NoProgress)?;
    let mut quick = QuickLineFinder::new(LineScene::new(Arc::clone(mesh)), &NoProgress)?;
    let buffers = Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh.mesh())?);
    let (mut reference, mut id_pass) = (ReferenceRenderer::new(gpu)?, FaceIdPass::new(gpu)?);
    let every = LineOptions { max_invisibility: u32::MAX, ..silhouette_options() };
    let mut seen = Seen::default();
    // The first view warms up caches and pipelines.
    for (number, camera) in views[..1].iter().chain(views).enumerate() {
        let mut one = Seen::default();
        let found = timed(&mut one.truth_ms, || truth.find(camera, &NoProgress))?;
        timed(&mut one.pen_ms, || pen::draw(&found.visible, PEN, camera.size()));
        let lines = timed(&mut one.lines_ms, || truth.find_lines(camera, &silhouette_options(), &NoProgress))?;
        let exact = Stretches::visible(&lines.chains, mesh.mesh(), &topology);
        one.visible_px = exact.length_px();

        let depth = reference.depth(gpu, &buffers, camera, DEFAULT_SUPERSAMPLING)?;
        let all = truth.find_lines(camera, &every, &NoProgress)?;
        one.depth = disagreement(&all, &depth, mesh.mesh(), &topology);

        for (at, scale) in SCALES.into_iter().enumerate() {
            let ids = timed(&mut one.ids_ms[at], || id_pass.draw(gpu, &buffers, camera, scale))?;
            let ids = FaceIds::new([ids.width, ids.height], ids.values)?;
            let find = || quick.find(camera, &silhouette_options(), &ids, &NoProgress);
            let lines = timed(&mut one.quick_ms[at], find)?;
            let drawn = Stretches::visible(&lines.chains, mesh.mesh(), &topology);
            let both = exact.overlap_px(&drawn);
            one.quick[at] = Quick {
                missed_px: exact.length_px() - both,
                missed_far_off_px: Nearness::new(&drawn, NEAR_PX).length_beyond_px(&exact),
                extra_px: drawn.length_px() - both,
                extra_far_off_px: Nearness::new(&exact, NEAR_PX).length_beyond_px(&drawn),
            };
        }
        if number > 0 {
            seen.add(one);
        }
    }
    Ok(seen)
}

/// Works [`REPEATS`] times and keeps the best time and the last result.
fn timed<T>(times_ms: &mut Vec<f64>, mut work: impl FnMut() -> T) -> T {
    let mut once = || {
        let start = Instant::now();
        let result = work();
        (start.elapsed().as_secs_f64() * 1e3, result)
    };
    let (mut best, mut result) = once();
    for _ in 1..REPEATS {
        let (time, again) = once();
        best = best.min(time);
        result = again;
    }
    times_ms.push(best);
    result
}

impl Seen {
    fn add(&mut self, view: Self) {
        self.truth_ms.extend(view.truth_ms);
        self.pen_ms.extend(view.pen_ms);
        self.lines_ms.extend(view.lines_ms);
        self.visible_px += view.visible_px;
        self.depth.add(&view.depth);
        for at in 0..SCALES.len() {
            self.ids_ms[at].extend(&view.ids_ms[at]);
            self.quick_ms[at].extend(&view.quick_ms[at]);
            let (sum, seen) = (&mut self.quick[at], view.quick[at]);
            sum.missed_px += seen.missed_px;
            sum.missed_far_off_px += seen.missed_far_off_px;
            sum.extra_px += seen.extra_px;
            sum.extra_far_off_px += seen.extra_far_off_px;
        }
    }
}

fn median(times_ms: &[f64]) -> f64 {
    let mut sorted = times_ms.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}

#[allow(clippy::print_stdout, reason = "an example's output")]
fn print(path: &str, faces: usize, seen: &Seen) {
    let percent = |part: f64, whole: f64| 100.0 * part / whole;
    let [truth, pen, lines] = [&seen.truth_ms, &seen.pen_ms, &seen.lines_ms].map(|times| median(times));
    println!("{path}: {faces} faces");
    println!("  truth {truth:.1} ms (exact lines {lines:.1}), its pen {pen:.1} ms; {:.0} px visible", seen.visible_px);
    let depth = &seen.depth;
    println!(
        "  depth picture: {:.2} % of {:.0} px differ: {:.2} % hidden but called visible, {:.2} % visible but called hidden; \
         {:.2} % of the visible length is called visible and more than a pixel off",
        100.0 * depth.share(),
        depth.length_px,
        percent(depth.wrongly_visible_px, depth.length_px),
        percent(depth.wrongly_hidden_px, depth.length_px),
        percent(depth.far_off_px, depth.visible_px),
    );
    for (at, scale) in SCALES.into_iter().enumerate() {
        let (quick, share) = (seen.quick[at], |px| percent(px, seen.visible_px));
        println!(
            "  quick, {scale} x: ids {:.1} ms, lines {:.1} ms",
            median(&seen.ids_ms[at]),
            median(&seen.quick_ms[at])
        );
        println!(
            "    {:.2} % missed ({:.2} % more than a pixel off), {:.2} % too much ({:.2} % more than a pixel off)",
            share(quick.missed_px),
            share(quick.missed_far_off_px),
            share(quick.extra_px),
            share(quick.extra_far_off_px),
        );
    }
}
