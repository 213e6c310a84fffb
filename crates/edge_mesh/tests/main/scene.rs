//! Meshes, cameras, pictures and lists that the tests share.

use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::view::{ClipRange, Framing, Projection, Viewpoint};
use silhouette_core::{Camera, Method, MethodOptions, PreparedMesh, TriangleMesh};
use silhouette_edge_mesh::drawn_edges::DrawnEdges;
use silhouette_edge_mesh::{EdgeMesh, EdgeMeshOptions, Renderer};
use silhouette_gpu::{DrawsLines, FrameRenderer, FrameView, MeshBuffers, TargetFormats};
use silhouette_render::{DEFAULT_FORMATS, Gpu, Image, Load, Target, view_of_mesh};
use silhouette_testing::{directions, views};
use std::sync::Arc;

/// Grey ground, so that paper, black ink and nothing at all are three values.
pub const GROUND: [f64; 4] = [0.5, 0.5, 0.5, 1.0];

/// Both paths.
pub const PATHS: [&str; 2] = ["path=compacted", "path=vertex-stage"];

pub fn method(mesh: &TriangleMesh, words: &[&str]) -> EdgeMesh {
    let options = EdgeMeshOptions::parse(words.iter().copied()).unwrap();
    EdgeMesh::new(&Arc::new(PreparedMesh::new(mesh.clone())), options).unwrap()
}

pub fn buffers(gpu: &Gpu, mesh: &TriangleMesh) -> Arc<MeshBuffers> {
    Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh).unwrap())
}

pub fn renderer_of(gpu: &Gpu, method: &EdgeMesh, buffers: &Arc<MeshBuffers>, formats: TargetFormats) -> Renderer {
    gpu.scoped(|| {
        let pipelines = Arc::new(method.pipelines(gpu.device(), formats).unwrap());
        method.renderer(gpu.device(), gpu.queue(), &pipelines, buffers).unwrap()
    })
    .unwrap()
}

pub fn renderer(gpu: &Gpu, mesh: &TriangleMesh, words: &[&str]) -> Renderer {
    renderer_of(gpu, &method(mesh, words), &buffers(gpu, mesh), DEFAULT_FORMATS)
}

/// A picture of a view that is prepared.
pub fn draw_with(gpu: &Gpu, renderer: &Renderer, size: [u32; 2], formats: TargetFormats) -> Image {
    let target = Target::new(gpu, size, formats).unwrap();
    gpu.draw_after(&target, Load::Clear(GROUND), |encoder| renderer.encode(encoder), |pass| renderer.draw(pass))
        .unwrap();
    target.read_color(gpu).unwrap()
}

/// A picture of a view.
pub fn picture_of(gpu: &Gpu, mesh: &TriangleMesh, words: &[&str], view: &FrameView) -> Image {
    let mut renderer = renderer(gpu, mesh, words);
    renderer.prepare(gpu.device(), gpu.queue(), view).unwrap();
    draw_with(gpu, &renderer, view.viewport().size_px, DEFAULT_FORMATS)
}

/// A picture of what a camera sees, with depths tight around the mesh.
pub fn picture(gpu: &Gpu, mesh: &TriangleMesh, camera: &Camera, words: &[&str]) -> Image {
    picture_of(gpu, mesh, words, &view_of_mesh(camera, &buffers(gpu, mesh)).unwrap())
}

/// The lists that the device makes for a view.
pub fn drawn(gpu: &Gpu, renderer: &mut Renderer, view: &FrameView) -> DrawnEdges {
    renderer.prepare(gpu.device(), gpu.queue(), view).unwrap();
    draw_with(gpu, renderer, view.viewport().size_px, DEFAULT_FORMATS);
    let Some(lists) = renderer.drawn_edges() else { return DrawnEdges::default() };
    let [silhouettes, features] = lists.map(|list| words_of(gpu, list));
    DrawnEdges::of_words(&silhouettes, &features)
}

/// The words of a buffer on the device.
pub fn words_of(gpu: &Gpu, buffer: &wgpu::Buffer) -> Vec<u32> {
    let readable = gpu.device().create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: buffer.size(),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    encoder.copy_buffer_to_buffer(buffer, 0, &readable, 0, buffer.size());
    gpu.queue().submit([encoder.finish()]);
    readable.map_async(wgpu::MapMode::Read, .., |result| result.unwrap());
    gpu.device().poll(wgpu::PollType::wait_indefinitely()).unwrap();
    let bytes = readable.get_mapped_range(..).unwrap();
    bytes.chunks_exact(4).map(|word| u32::from_le_bytes(word.try_into().unwrap())).collect()
}

pub fn framed(mesh: &TriangleMesh, size: u32) -> Camera {
    framed_as(mesh, views::PERSPECTIVE, size)
}

pub fn framed_as(mesh: &TriangleMesh, framing: Framing, size: u32) -> Camera {
    views::framed(mesh, DVec3::new(0.55, 0.35, 1.0), framing, [size; 2])
}

/// Pixels whose red `matches`.
pub fn count(image: &Image, matches: impl Fn(u8) -> bool) -> usize {
    image.rgba.chunks_exact(4).filter(|pixel| matches(pixel[0])).count()
}

pub fn ink(image: &Image) -> usize {
    count(image, |value| value == 0)
}

/// Pixels that differ by more than a tenth.
pub fn differing(a: &Image, b: &Image) -> usize {
    let close = |a: &[u8], b: &[u8]| a.iter().zip(b).all(|(a, b)| a.abs_diff(*b) < 24);
    a.rgba.chunks_exact(4).zip(b.rgba.chunks_exact(4)).filter(|(a, b)| !close(a, b)).count()
}

/// A view whose viewpoint is that of a camera, whatever lies before or behind it.
pub fn any_view(mesh: &TriangleMesh, camera: &Camera) -> FrameView {
    let radius = mesh.bounds().map_or(1.0, |bounds| bounds.radius);
    let near = 1e-3 * radius;
    FrameView::from_camera(camera, ClipRange { near, far: 1e9 * near }, DEFAULT_FORMATS.depth_direction).unwrap()
}

/// Views from places that are hard to get right, and from around a mesh.
pub fn hard_views(mesh: &TriangleMesh) -> Vec<FrameView> {
    let center = mesh.bounds().unwrap().center.as_vec3();
    let radius = mesh.bounds().unwrap().radius as f32;
    let hard = views::hard_viewpoints(mesh, 3).into_iter().filter_map(|viewpoint| {
        let target = center + Vec3::new(0.01, 0.02, 0.03) * radius;
        let camera = match viewpoint {
            Viewpoint::Perspective { eye } => {
                let projection = Projection::Perspective { fov_y_rad: 0.8 };
                Camera::new(eye, target, (target - eye).any_orthogonal_vector(), projection, [8; 2])
            }
            Viewpoint::Orthographic { toward_viewer } => {
                let away = toward_viewer.normalize() * radius * 2.0;
                let projection = Projection::Orthographic { height: f64::from(radius) * 2.0 };
                Camera::new(center + away, center, away.any_orthogonal_vector(), projection, [8; 2])
            }
        };
        camera.ok()
    });
    let around = directions::spread(4).map(|direction| views::framed(mesh, direction, views::PERSPECTIVE, [8; 2]));
    hard.chain(around).map(|camera| any_view(mesh, &camera)).collect()
}
