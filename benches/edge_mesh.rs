//! Frames of the edge mesh over plain rendering of the same mesh, in one run.
//!
//! `cargo bench -p silhouette-benches --bench edge_mesh -- [SIZE [MESH...]]`, a mesh being a file or `builtin:NAME`. Without
//! arguments: 512 pixels, a mesh of 1.1 million faces at rest and one of 100 thousand faces that moves.
//!
//! Each round prepares, encodes and draws one frame by every row in turn, from a view that no row has seen before; medians of the
//! rounds. A frame ends when the device is done. Ink of the rows that draw the same edges is compared before anything is timed.

#![allow(clippy::print_stdout, reason = "the table is the output")]

use silhouette_core::glam::{DMat4, DVec3, Vec3};
use silhouette_core::method::NoOptions;
use silhouette_core::{ExtractsEdges, Method, MethodOptions, NoProgress, PreparedMesh, Topology, shapes};
use silhouette_edge_mesh::{EdgeMesh, EdgeMeshOptions};
use silhouette_extraction::{BruteForce, BruteForceSimd};
use silhouette_gpu::{
    Color, DrawsLines, EdgeRenderer, FillPipelines, FillRenderer, FillStyle, FrameRenderer, FrameView, Interior,
    MeshBuffers, Pen, PenPlacement, StrokePipelines, StrokeRenderer, StrokeStyle,
};
use silhouette_render::{AdapterChoice, DEFAULT_FORMATS, Gpu, Load, Target, view_of_mesh};
use silhouette_testing::views;
use std::error::Error;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

const ROUNDS: usize = 15;
const WIDTH_PX: f64 = 2.0;

/// Rows of the edge mesh: label and options.
const EDGE_MESH: [(&str, &str); 7] = [
    ("compacted", "path=compacted"),
    ("compacted, facing=device", "path=compacted facing=device"),
    ("vertex-stage", "path=vertex-stage"),
    ("vertex-stage, facing=device", "path=vertex-stage facing=device"),
    ("compacted, cull=back", "path=compacted cull=back"),
    ("vertex-stage, cull=back", "path=vertex-stage cull=back"),
    ("compacted, ridges and valleys", "path=compacted ridge-angle=30 valley-angle=30"),
];

type Row = (String, Box<dyn FrameRenderer>);

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    let size: u32 = arguments.first().map_or(Ok(512), |size| size.parse())?;
    let gpu = Gpu::new(AdapterChoice::from_env()?)?;
    println!("{}, {size} x {size}", gpu.adapter());
    if arguments.len() > 1 {
        for name in &arguments[1..] {
            at_rest(&gpu, name, size)?;
            moving(&gpu, name, size)?;
        }
    } else {
        at_rest(&gpu, "builtin:blob:1111216", size)?;
        moving(&gpu, "builtin:blob:100000", size)?;
    }
    Ok(())
}

fn loaded(name: &str) -> Result<Arc<PreparedMesh>, Box<dyn Error>> {
    let mesh = match name.strip_prefix("builtin:") {
        Some(shape) => shapes::by_name(shape)?,
        None => silhouette_core::load::load(Path::new(name))?,
    };
    Ok(Arc::new(PreparedMesh::new(mesh)))
}

fn plain(gpu: &Gpu, buffers: &Arc<MeshBuffers>) -> Row {
    let pipelines = Arc::new(FillPipelines::new(gpu.device(), DEFAULT_FORMATS, FillStyle::PAPER));
    ("plain rendering".to_owned(), Box::new(FillRenderer::new(gpu.device(), &pipelines, buffers)))
}

fn edge_mesh_rows(gpu: &Gpu, mesh: &Arc<PreparedMesh>, buffers: &Arc<MeshBuffers>) -> Result<Vec<Row>, Box<dyn Error>> {
    let mut rows = Vec::new();
    for (label, words) in EDGE_MESH {
        let method = EdgeMesh::new(mesh, EdgeMeshOptions::parse(words.split(' '))?)?;
        let pipelines = Arc::new(method.pipelines(gpu.device(), DEFAULT_FORMATS)?);
        let renderer = method.renderer(gpu.device(), gpu.queue(), &pipelines, buffers)?;
        rows.push((label.to_owned(), Box::new(renderer) as Box<dyn FrameRenderer>));
    }
    Ok(rows)
}

/// Edges found on the CPU and uploaded as strokes.
fn extracted<E: Method<Options = NoOptions> + ExtractsEdges>(
    gpu: &Gpu,
    mesh: &Arc<PreparedMesh>,
    buffers: &Arc<MeshBuffers>,
) -> Result<Row, Box<dyn Error>> {
    let style = StrokeStyle {
        pen: Pen { width_px: WIDTH_PX, placement: PenPlacement::Outside },
        interior: Interior::Paper(Color::WHITE),
        ..StrokeStyle::default()
    };
    let pipelines = Arc::new(StrokePipelines::new(gpu.device(), DEFAULT_FORMATS, style));
    let strokes = StrokeRenderer::new(gpu.device(), &pipelines, buffers);
    let topology = mesh.artefact::<Topology>("bench", &NoProgress)?;
    let extractor = E::new(mesh, NoOptions)?;
    let renderer = EdgeRenderer::new(extractor, Arc::clone(mesh.mesh()), topology, strokes);
    Ok((format!("extraction and upload, {}", E::INFO.name), Box::new(renderer)))
}

fn at_rest(gpu: &Gpu, name: &str, size: u32) -> Result<(), Box<dyn Error>> {
    let mesh = loaded(name)?;
    let buffers = Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh.mesh())?);
    let mut rows = vec![plain(gpu, &buffers)];
    rows.extend(edge_mesh_rows(gpu, &mesh, &buffers)?);
    rows.push(extracted::<BruteForce>(gpu, &mesh, &buffers)?);
    rows.push(extracted::<BruteForceSimd>(gpu, &mesh, &buffers)?);
    println!("{name}, {} faces, at rest", mesh.mesh().face_count());
    table(gpu, &buffers, rows, size)
}

/// The mesh in a position buffer, as if a stage of the caller's wrote it in each frame.
fn moving(gpu: &Gpu, name: &str, size: u32) -> Result<(), Box<dyn Error>> {
    let mesh = loaded(name)?;
    let bounds = mesh.mesh().bounds().ok_or("a mesh without triangles")?;
    let local: Vec<u8> = mesh.mesh().positions().iter().flat_map(Vec3::to_array).flat_map(f32::to_ne_bytes).collect();
    let positions = gpu.device().create_buffer(&wgpu::BufferDescriptor {
        label: Some("positions"),
        size: local.len() as u64,
        usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu.queue().write_buffer(&positions, 0, &local);
    let triangles = mesh.mesh().triangles();
    let buffers = MeshBuffers::from_position_buffer(gpu.device(), gpu.queue(), positions, triangles, bounds)?;
    let buffers = Arc::new(buffers);
    let mut rows = vec![plain(gpu, &buffers)];
    rows.extend(edge_mesh_rows(gpu, &mesh, &buffers)?);
    println!("{name}, {} faces, positions from a buffer of the caller's", mesh.mesh().face_count());
    table(gpu, &buffers, rows, size)
}

fn table(gpu: &Gpu, buffers: &Arc<MeshBuffers>, mut rows: Vec<Row>, size: u32) -> Result<(), Box<dyn Error>> {
    let target = Target::new(gpu, [size; 2], DEFAULT_FORMATS)?;
    let bounds = buffers.bounds().ok_or("a mesh without triangles")?;
    let camera =
        silhouette_core::Camera::framing(&bounds, DVec3::new(0.55, 0.35, 1.0), Vec3::Y, views::PERSPECTIVE, [size; 2])?;
    let mut inks = vec![0; rows.len()];
    let mut times = vec![(Vec::new(), Vec::new()); rows.len()];
    for round in 0..=ROUNDS {
        let about_middle = DMat4::from_translation(bounds.center)
            * DMat4::from_rotation_y(0.11 * round as f64)
            * DMat4::from_translation(-bounds.center);
        let view: FrameView = view_of_mesh(&camera, buffers)?.with_model(about_middle)?;
        for (row, (_, renderer)) in rows.iter_mut().enumerate() {
            let start = Instant::now();
            renderer.prepare(gpu.device(), gpu.queue(), &view)?;
            let prepared = start.elapsed();
            let renderer = &*renderer;
            let encode = |encoder: &mut wgpu::CommandEncoder| renderer.encode(encoder);
            gpu.draw_after(&target, Load::Clear([1.0; 4]), encode, |pass| renderer.draw(pass))?;
            // The first round compiles.
            if round > 0 {
                times[row].0.push(start.elapsed().as_secs_f64() * 1e3);
                times[row].1.push(prepared.as_secs_f64() * 1e3);
            } else {
                inks[row] = target.read_color(gpu)?.rgba.chunks_exact(4).filter(|pixel| pixel[0] < 128).count();
            }
        }
    }
    for row in 2..7 {
        let (first, ink) = (inks[1], inks[row]);
        assert!(first > 100 && ink.abs_diff(first) * 100 <= first, "{}: {ink} pixels, not {first}", rows[row].0);
    }
    let median = |mut times: Vec<f64>| {
        times.sort_by(f64::total_cmp);
        times[times.len() / 2]
    };
    let medians: Vec<[f64; 2]> = times.into_iter().map(|(frame, cpu)| [median(frame), median(cpu)]).collect();
    for ((label, _), ([frame, cpu], ink)) in rows.iter().zip(medians.iter().zip(inks)) {
        println!(
            "  {label:<40} {frame:7.1} ms, {:5.2} of plain; prepare {cpu:6.2} ms; {ink} px of ink",
            frame / medians[0][0]
        );
    }
    Ok(())
}
