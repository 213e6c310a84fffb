//! Where a frame's time goes: plain rendering, front faces alone, what is listed before the pass, and the pass, for
//! `screen` and `fatten`. Medians of 15 frames in turn, in milliseconds and over plain rendering of all faces.
//!
//! `cargo run --release -p silhouette-image-precision --example stages -- SIZE MESH...`, a mesh being a file or
//! `builtin:NAME`.

#![allow(clippy::print_stdout, reason = "an example that prints a table")]

use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::method::{Method, MethodOptions};
use silhouette_core::prepared::PreparedMesh;
use silhouette_core::shapes::by_name;
use silhouette_core::view::{Camera, Framing};
use silhouette_gpu::{Cull, DrawsLines, FillPipelines, FillRenderer, FillStyle, FrameRenderer, FrameView, MeshBuffers};
use silhouette_image_precision::{ImagePrecision, ImagePrecisionOptions, Renderer};
use silhouette_render::{AdapterChoice, DEFAULT_FORMATS, Gpu, Load, Target, view_of_mesh};
use std::error::Error;
use std::path::Path;
use std::sync::Arc;

const FRAMES: usize = 15;
const PAPER: [f64; 4] = [1.0; 4];

/// Label and options of what is timed; `equal` draws front faces and back faces, and nothing else.
const VARIANTS: [(&str, &str); 5] = [
    ("front and back faces", "variant=equal"),
    ("screen", "variant=screen"),
    ("fatten", "variant=fatten"),
    ("fatten, no clamp", "variant=fatten fatten-clamp=0"),
    ("charcoal", "variant=charcoal interior=paper"),
];

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let size: u32 = arguments.next().ok_or("name a size in pixels and meshes")?.parse()?;
    let gpu = Gpu::new(AdapterChoice::from_env()?)?;
    for name in arguments {
        let mesh = match name.strip_prefix("builtin:") {
            Some(shape) => by_name(shape)?,
            None => silhouette_core::load::load(Path::new(&name))?,
        };
        profile(&gpu, &name, &Arc::new(PreparedMesh::new(mesh)), size)?;
    }
    Ok(())
}

fn profile(gpu: &Gpu, name: &str, mesh: &Arc<PreparedMesh>, size: u32) -> Result<(), Box<dyn Error>> {
    let bounds = mesh.mesh().bounds().ok_or("a mesh without triangles")?;
    let framing = Framing::Perspective { fov_y_rad: 0.7 };
    let camera = Camera::framing(&bounds, DVec3::new(0.55, 0.35, 1.0), Vec3::Y, framing, [size; 2])?;
    let target = Target::new(gpu, [size; 2], DEFAULT_FORMATS)?;
    let buffers = Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh.mesh())?);
    let view = view_of_mesh(&camera, &buffers)?;
    let mut fills = Vec::new();
    for cull in [Cull::None, Cull::Back] {
        let style = FillStyle { cull, ..FillStyle::PAPER };
        let pipelines = Arc::new(FillPipelines::new(gpu.device(), DEFAULT_FORMATS, style));
        let mut fill = FillRenderer::new(gpu.device(), &pipelines, &buffers);
        fill.prepare(gpu.device(), gpu.queue(), &view)?;
        fills.push(fill);
    }
    let mut renderers: Vec<Renderer> = Vec::new();
    for (_, words) in VARIANTS {
        let method = ImagePrecision::new(mesh, ImagePrecisionOptions::parse(words.split(' '))?)?;
        let pipelines = Arc::new(method.pipelines(gpu.device(), DEFAULT_FORMATS)?);
        let mut renderer = method.renderer(gpu.device(), gpu.queue(), &pipelines, &buffers)?;
        let range = renderer.clip_range(&camera, camera.clip_range(&bounds));
        let view = FrameView::from_camera(&camera, range, DEFAULT_FORMATS.depth_direction)?;
        renderer.prepare(gpu.device(), gpu.queue(), &view)?;
        renderers.push(renderer);
    }

    // One column of times for each fill, and two for each renderer: all of it, and its pass alone.
    let mut times = vec![Vec::new(); fills.len() + 2 * renderers.len()];
    for frame in 0..=FRAMES {
        let mut column = 0;
        let mut note = |ms: f64| {
            if frame > 0 {
                times[column].push(ms);
            }
            column += 1;
        };
        for fill in &fills {
            note(gpu.draw(&target, Load::Clear(PAPER), |pass| fill.draw(pass))?.wall_ms);
        }
        for renderer in &renderers {
            let encode = |encoder: &mut _| renderer.encode(encoder);
            note(gpu.draw_after(&target, Load::Clear(PAPER), encode, |pass| renderer.draw(pass))?.wall_ms);
            // The list of the previous frame is still there.
            note(gpu.draw(&target, Load::Clear(PAPER), |pass| renderer.draw(pass))?.wall_ms);
        }
    }
    let medians: Vec<f64> = times
        .iter_mut()
        .map(|times| {
            times.sort_by(f64::total_cmp);
            times[times.len() / 2]
        })
        .collect();
    let plain = medians[0];
    println!(
        "{name}, {} faces, {size} x {size}: plain {plain:.1} ms, front faces {:.1} ms",
        mesh.mesh().face_count(),
        medians[1]
    );
    for ((label, _), pair) in VARIANTS.iter().zip(medians[2..].chunks_exact(2)) {
        let [all, pass] = [pair[0], pair[1]];
        println!("  {label:<22} {:5.2} = {all:6.1} ms: listing {:6.1}, pass {pass:6.1}", all / plain, all - pass);
    }
    Ok(())
}
