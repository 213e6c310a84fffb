//! What instances of one mesh cost to set up: pipelines and mesh buffers are made once, and each instance has a renderer.
//!
//! `cargo run --release -p silhouette-image-precision --example instances -- MESH [COUNT]`, a mesh being a file or
//! `builtin:NAME`. Medians of 7 rounds in turn.

#![allow(clippy::print_stdout, reason = "an example that prints a table")]

use silhouette_core::glam::DMat4;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::method::Method;
use silhouette_core::prepared::PreparedMesh;
use silhouette_core::shapes::by_name;
use silhouette_core::view::{Camera, Framing};
use silhouette_gpu::{DrawsLines, FrameRenderer, MeshBuffers};
use silhouette_image_precision::{ImagePrecision, ImagePrecisionOptions, Renderer};
use silhouette_render::{AdapterChoice, DEFAULT_FORMATS, Gpu, Load, Target, view_of_mesh};
use std::error::Error;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

const ROUNDS: usize = 7;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().ok_or("name a mesh")?;
    let count: usize = arguments.next().map_or(Ok(100), |count| count.parse())?;
    let mesh = match name.strip_prefix("builtin:") {
        Some(shape) => by_name(shape)?,
        None => silhouette_core::load::load(Path::new(&name))?,
    };
    let mesh = Arc::new(PreparedMesh::new(mesh));
    let gpu = Gpu::new(AdapterChoice::from_env()?)?;
    let mut times = [Vec::new(), Vec::new()];
    for round in 0..=ROUNDS {
        for (times, count) in times.iter_mut().zip([1, count]) {
            let start = Instant::now();
            let (renderers, buffers) = set_up(&gpu, &mesh, count)?;
            let ms = start.elapsed().as_secs_f64() * 1e3;
            draw(&gpu, renderers, &buffers)?;
            // The first round compiles shaders that later ones find in the driver's cache.
            if round > 0 {
                times.push(ms);
            }
        }
    }
    let [one, many] = times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        times[times.len() / 2]
    });
    let faces = mesh.mesh().face_count();
    println!("{name}, {faces} faces: one {one:.1} ms, {count} instances {many:.1} ms, {:.2} times one", many / one);
    Ok(())
}

/// Everything from the method's options to renderers that are ready for their first frame.
fn set_up(
    gpu: &Gpu,
    mesh: &Arc<PreparedMesh>,
    count: usize,
) -> Result<(Vec<Renderer>, Arc<MeshBuffers>), Box<dyn Error>> {
    let method = ImagePrecision::new(mesh, ImagePrecisionOptions::default())?;
    let pipelines = Arc::new(method.pipelines(gpu.device(), DEFAULT_FORMATS)?);
    let buffers = Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh.mesh())?);
    let renderer = |_| method.renderer(gpu.device(), gpu.queue(), &pipelines, &buffers);
    let renderers = (0..count).map(renderer).collect::<Result<_, _>>()?;
    gpu.check()?;
    Ok((renderers, buffers))
}

/// Draws all instances side by side, so that what was set up is used.
fn draw(gpu: &Gpu, mut renderers: Vec<Renderer>, buffers: &Arc<MeshBuffers>) -> Result<(), Box<dyn Error>> {
    let bounds = buffers.bounds().ok_or("a mesh without triangles")?;
    let framing = Framing::Perspective { fov_y_rad: 0.7 };
    let camera = Camera::framing(&bounds, DVec3::new(0.5, 0.4, 1.0), Vec3::Y, framing, [256; 2])?;
    let view = view_of_mesh(&camera, buffers)?;
    let across = (renderers.len() as f64).sqrt().ceil();
    for (index, renderer) in renderers.iter_mut().enumerate() {
        let place = DVec3::new(index as f64 % across, (index as f64 / across).floor(), 0.0) / across - 0.5;
        let model = DMat4::from_translation(bounds.center + place * bounds.radius)
            * DMat4::from_scale(DVec3::splat(1.0 / across))
            * DMat4::from_translation(-bounds.center);
        renderer.prepare(gpu.device(), gpu.queue(), &view.with_model(model)?)?;
    }
    let target = Target::new(gpu, camera.size(), DEFAULT_FORMATS)?;
    let encode = |encoder: &mut _| renderers.iter().for_each(|renderer| renderer.encode(encoder));
    gpu.draw_after(&target, Load::Clear([1.0; 4]), encode, |pass| {
        renderers.iter().for_each(|renderer| renderer.draw(pass));
    })?;
    Ok(())
}
