//! Frames of a mesh beside frames of its texture, by distance:
//! `cargo run --release -p silhouette-texture --example frame_times -- MESH FILE.siltex`, for OBJ, PLY and OFF files and
//! `builtin:NAME`.
//!
//! Both draw lit surfaces of 512 x 512 pixels in turn, every frame twice, of which the second is timed.

#![allow(clippy::print_stdout, reason = "an example that prints")]

use silhouette_core::view::{Camera, Framing, ViewPreset};
use silhouette_core::{Method, PreparedMesh, load, shapes};
use silhouette_gpu::{
    Color, Cull, FillPipelines, FillRenderer, FillStyle, FillsImage, FrameRenderer, FrameView, MeshBuffers, Shade,
};
use silhouette_render::{AdapterChoice, DEFAULT_FORMATS, Gpu, Load, Target};
use silhouette_texture::method::Textures;
use silhouette_texture::{Texture, TextureOptions, siltex};
use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

/// Distances, over that from which all of the mesh is seen.
const DISTANCES: [f64; 6] = [0.6, 1.0, 2.0, 4.0, 8.0, 16.0];
const ROUNDS: usize = 9;
const SIZE: [u32; 2] = [512; 2];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [name, file] = &arguments[..] else { return Err("give a mesh and its .siltex file".into()) };
    let mesh = match name.strip_prefix("builtin:") {
        Some(shape) => shapes::by_name(shape)?,
        None => load::load(name.as_ref())?,
    };
    let bounds = mesh.bounds().ok_or("the mesh has no faces")?;
    let gpu = Gpu::new(AdapterChoice::from_env()?)?;
    let (device, queue) = (gpu.device(), gpu.queue());
    let buffers = Arc::new(MeshBuffers::new(device, queue, &mesh)?);

    let style = FillStyle { shade: Shade::Lit(Color::WHITE), cull: Cull::None };
    let fill = Arc::new(FillPipelines::new(device, DEFAULT_FORMATS, style));
    let mut fine = FillRenderer::new(device, &fill, &buffers);
    let given = Textures::given(siltex::read(file.as_ref())?.texture);
    let prepared = Arc::new(PreparedMesh::new(mesh).with_artefact(given));
    let method = Texture::new(&prepared, TextureOptions::default())?;
    let pipelines = Arc::new(method.pipelines(device, DEFAULT_FORMATS)?);
    let mut texture = method.renderer(device, queue, &pipelines, &buffers)?;

    let target = Target::new(&gpu, SIZE, DEFAULT_FORMATS)?;
    println!("{}\ndistance  mesh ms  texture ms  mesh / texture", gpu.adapter());
    for distance in DISTANCES {
        let (direction, up) = ViewPreset::default().directions();
        let framing = Framing::Perspective { fov_y_rad: std::f64::consts::FRAC_PI_4 };
        let near = Camera::framing(&bounds, direction, up, framing, SIZE)?;
        let eye = near.target() + (near.eye() - near.target()) * distance as f32;
        let camera = Camera::new(eye, near.target(), near.up(), near.projection(), SIZE)?;
        let mut times = [const { Vec::new() }; 2];
        for _ in 0..ROUNDS {
            let renderers: [&mut dyn FrameRenderer; 2] = [&mut fine, &mut texture];
            for (renderer, times) in renderers.into_iter().zip(&mut times) {
                frame_ms(&gpu, &target, renderer, &camera, &buffers)?;
                times.push(frame_ms(&gpu, &target, renderer, &camera, &buffers)?);
            }
        }
        let [mesh_ms, texture_ms] = times.map(|mut times| {
            times.sort_by(f64::total_cmp);
            times[times.len() / 2]
        });
        println!("{distance:8.1}  {mesh_ms:7.2}  {texture_ms:10.2}  {:14.1}", mesh_ms / texture_ms);
    }
    Ok(())
}

fn frame_ms(
    gpu: &Gpu,
    target: &Target,
    renderer: &mut dyn FrameRenderer,
    camera: &Camera,
    mesh: &MeshBuffers,
) -> Result<f64, Box<dyn Error>> {
    let bounds = mesh.bounds().ok_or("the mesh has no faces")?;
    // The hull reaches beyond the mesh. Where a plane cut it, the mesh itself would be drawn.
    let range = renderer.clip_range(camera, camera.clip_range(&bounds));
    let view = FrameView::from_camera(camera, range, DEFAULT_FORMATS.depth_direction)?;
    let start = Instant::now();
    renderer.prepare(gpu.device(), gpu.queue(), &view)?;
    let prepare_ms = start.elapsed().as_secs_f64() * 1000.0;
    if let Some(warning) = renderer.warning() {
        return Err(warning.into());
    }
    let ground = Load::Clear([1.0; 4]);
    let pass = gpu.draw_after(target, ground, |encoder| renderer.encode(encoder), |pass| renderer.draw(pass))?;
    Ok(prepare_ms + pass.wall_ms)
}
