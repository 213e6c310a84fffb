//! Meshes, cameras and pictures that the tests share.

use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::mesh::TriangleMesh;
use silhouette_core::method::{Method, MethodOptions};
use silhouette_core::prepared::PreparedMesh;
use silhouette_core::shapes::Torus;
use silhouette_core::view::{Camera, ClipRange, Framing, Projection};
use silhouette_gpu::{DrawsLines, FrameRenderer, FrameView, MeshBuffers, RendererError, TargetFormats};
use silhouette_image_precision::{ImagePrecision, ImagePrecisionOptions, Renderer};
use silhouette_render::{Gpu, Image, Load, Target};
use std::sync::Arc;

/// Grey ground, so that white front faces, black ink and nothing at all are three values.
const PAPER: [f64; 4] = [0.5, 0.5, 0.5, 1.0];

pub struct Drawn {
    pub image: Image,
    pub warning: Option<String>,
}

pub fn draw(gpu: &Gpu, mesh: &TriangleMesh, camera: &Camera, words: &[&str], formats: TargetFormats) -> Drawn {
    draw_within(gpu, mesh, camera, words, formats, None)
}

pub fn draw_within(
    gpu: &Gpu,
    mesh: &TriangleMesh,
    camera: &Camera,
    words: &[&str],
    formats: TargetFormats,
    range: Option<ClipRange>,
) -> Drawn {
    let mut renderer = renderer(gpu, mesh, words, formats).unwrap();
    let view = view_of(&renderer, mesh, camera, formats, range);
    renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
    Drawn { image: draw_with(gpu, &renderer, camera.size(), formats), warning: renderer.warning() }
}

/// A renderer with options given by words.
pub fn renderer(
    gpu: &Gpu,
    mesh: &TriangleMesh,
    words: &[&str],
    formats: TargetFormats,
) -> Result<Renderer, RendererError> {
    renderer_of(gpu, mesh, words, formats, &buffers(gpu, mesh))
}

pub fn buffers(gpu: &Gpu, mesh: &TriangleMesh) -> Arc<MeshBuffers> {
    Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh).unwrap())
}

/// The same with the caller's buffers of the mesh.
pub fn renderer_of(
    gpu: &Gpu,
    mesh: &TriangleMesh,
    words: &[&str],
    formats: TargetFormats,
    buffers: &Arc<MeshBuffers>,
) -> Result<Renderer, RendererError> {
    let options = ImagePrecisionOptions::parse(words.iter().copied()).unwrap();
    let prepared = Arc::new(PreparedMesh::new(mesh.clone()));
    let method = ImagePrecision::new(&prepared, options).unwrap();
    gpu.scoped(|| {
        let pipelines = Arc::new(method.pipelines(gpu.device(), formats)?);
        method.renderer(gpu.device(), gpu.queue(), &pipelines, buffers)
    })
    .unwrap()
}

/// What a camera shows within `range`, or else within the depths that hold what is drawn.
pub fn view_of(
    renderer: &Renderer,
    mesh: &TriangleMesh,
    camera: &Camera,
    formats: TargetFormats,
    range: Option<ClipRange>,
) -> FrameView {
    let tight = mesh.bounds().map(|bounds| renderer.clip_range(camera, camera.clip_range(&bounds)));
    let range = range.or(tight).unwrap_or(ClipRange { near: 0.1, far: 10.0 });
    FrameView::from_camera(camera, range, formats.depth_direction).unwrap()
}

pub fn draw_with(gpu: &Gpu, renderer: &Renderer, size: [u32; 2], formats: TargetFormats) -> Image {
    let target = Target::new(gpu, size, formats).unwrap();
    let encode = |encoder: &mut _| renderer.encode(encoder);
    gpu.draw_after(&target, Load::Clear(PAPER), encode, |pass| renderer.draw(pass)).unwrap();
    target.read_color(gpu).unwrap()
}

pub fn count(image: &Image, matches: impl Fn(u8) -> bool) -> usize {
    image.rgba.chunks_exact(4).filter(|pixel| matches(pixel[0])).count()
}

pub fn ink(image: &Image) -> usize {
    count(image, |value| value == 0)
}

pub fn framed(mesh: &TriangleMesh, size: u32) -> Camera {
    framed_as(mesh, Framing::Perspective { fov_y_rad: 0.7 }, size)
}

pub fn framed_as(mesh: &TriangleMesh, framing: Framing, size: u32) -> Camera {
    let bounds = mesh.bounds().unwrap();
    Camera::framing(&bounds, DVec3::new(0.55, 0.35, 1.0), Vec3::Y, framing, [size; 2]).unwrap()
}

pub fn torus() -> TriangleMesh {
    Torus::default().mesh(96, 48).unwrap()
}

/// A unit sphere from 3 radii at 512 x 512 pixels.
pub fn sphere_camera() -> Camera {
    let eye = (DVec3::new(0.55, 0.35, 1.0).normalize() * 3.0).as_vec3();
    let projection = Projection::Perspective { fov_y_rad: std::f64::consts::FRAC_PI_4 };
    Camera::new(eye, Vec3::ZERO, Vec3::Y, projection, [512; 2]).unwrap()
}

/// Radius of its outline in pixels.
pub fn sphere_radius_px() -> f64 {
    sphere_camera().pixels_per_unit(1.0) / 8.0_f64.sqrt()
}
