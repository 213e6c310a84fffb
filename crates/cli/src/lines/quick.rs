//! `lines --quick`: the picture of face ids is drawn here, and lines are found by looking at it.

use super::of_finding;
use crate::failure::Failure;
use silhouette_core::{Camera, Progress};
use silhouette_gpu::MeshBuffers;
use silhouette_render::{AdapterChoice, FaceIdPass, Gpu};
use silhouette_visibility::{FaceIds, LineOptions, LineScene, Lines, QuickLineFinder};
use std::time::{Duration, Instant};

/// Pixels of ids along each side of a pixel of the view.
const SCALE: u32 = 2;

/// The lines, and the time that preparing took: adapter, pipeline and mesh. The time of drawing counts as projection.
/// `names` are the meshes' names, for errors.
pub fn find(
    scene: &LineScene,
    names: &str,
    camera: &Camera,
    options: &LineOptions,
    progress: &dyn Progress,
) -> Result<(Duration, Lines), Failure> {
    let started = Instant::now();
    let gpu = AdapterChoice::from_env().and_then(Gpu::new).map_err(Failure::run)?;
    let mut finder = QuickLineFinder::new(scene.clone(), progress)?;
    let buffers = MeshBuffers::new(gpu.device(), gpu.queue(), scene.mesh().mesh()).map_err(Failure::run)?;
    let mut pass = FaceIdPass::new(&gpu).map_err(Failure::run)?;
    let prepared = started.elapsed();

    let started = Instant::now();
    let drawn = pass.draw(&gpu, &buffers, camera, SCALE).map_err(Failure::run)?;
    let ids = FaceIds::new([drawn.width, drawn.height], drawn.values).map_err(Failure::run)?;
    let drawing = started.elapsed();
    let mut lines = finder.find(camera, options, &ids, progress).map_err(|error| of_finding(names, error))?;
    lines.stats.project += drawing;
    Ok((prepared, lines))
}
