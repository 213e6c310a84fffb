//! Methods, meshes, cameras and pictures that the tests share.

use silhouette_baselines::{GbufferFilter, InvertedHull, JumpFlood};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::mesh::TriangleMesh;
use silhouette_core::method::MethodOptions;
use silhouette_core::shapes::{Sphere, Torus};
use silhouette_core::view::{Camera, Projection};
use silhouette_gpu::{DrawsLines, FrameRenderer, FrameView, MeshBuffers, TargetFormats};
use silhouette_render::{DEFAULT_FORMATS, Gpu, Image, Load, Target};
use silhouette_testing::prepare::prepared;
use std::sync::Arc;

/// Grey ground, so that white interiors, black ink and nothing at all are three values.
const GROUND: [f64; 4] = [0.5, 0.5, 0.5, 1.0];
pub const GROUND_VALUE: u8 = 128;

/// A method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lines {
    Hull,
    Filter,
    Flood,
}

impl Lines {
    pub const ALL: [Self; 3] = [Self::Hull, Self::Filter, Self::Flood];

    /// A renderer with options given by words.
    pub fn renderer(
        self,
        gpu: &Gpu,
        mesh: &TriangleMesh,
        words: &[&str],
        formats: TargetFormats,
        buffers: &Arc<MeshBuffers>,
    ) -> Box<dyn FrameRenderer> {
        match self {
            Self::Hull => renderer_of::<InvertedHull>(gpu, mesh, words, formats, buffers),
            Self::Filter => renderer_of::<GbufferFilter>(gpu, mesh, words, formats, buffers),
            Self::Flood => renderer_of::<JumpFlood>(gpu, mesh, words, formats, buffers),
        }
    }

    /// The picture of a view, in a target as large as its viewport.
    pub fn picture(self, gpu: &Gpu, mesh: &TriangleMesh, words: &[&str], view: &FrameView) -> Image {
        let mut renderer = self.renderer(gpu, mesh, words, DEFAULT_FORMATS, &buffers(gpu, mesh));
        renderer.prepare(gpu.device(), gpu.queue(), view).unwrap();
        draw_with(gpu, &*renderer, view.viewport().size_px, DEFAULT_FORMATS)
    }

    /// The picture of what a camera shows.
    pub fn seen(self, gpu: &Gpu, mesh: &TriangleMesh, words: &[&str], camera: &Camera) -> Image {
        self.picture(gpu, mesh, words, &view(mesh, camera, DEFAULT_FORMATS))
    }
}

fn renderer_of<M: DrawsLines>(
    gpu: &Gpu,
    mesh: &TriangleMesh,
    words: &[&str],
    formats: TargetFormats,
    buffers: &Arc<MeshBuffers>,
) -> Box<dyn FrameRenderer> {
    let method = M::new(&prepared(mesh.clone()), M::Options::parse(words.iter().copied()).unwrap()).unwrap();
    let renderer = gpu.scoped(|| {
        let pipelines = Arc::new(method.pipelines(gpu.device(), formats)?);
        method.renderer(gpu.device(), gpu.queue(), &pipelines, buffers)
    });
    Box::new(renderer.unwrap().unwrap())
}

pub fn buffers(gpu: &Gpu, mesh: &TriangleMesh) -> Arc<MeshBuffers> {
    Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh).unwrap())
}

/// What a camera shows, with room before and behind the mesh.
pub fn view(mesh: &TriangleMesh, camera: &Camera, formats: TargetFormats) -> FrameView {
    let mut range = camera.clip_range(&mesh.bounds().unwrap());
    (range.near, range.far) = (0.8 * range.near, 1.2 * range.far);
    FrameView::from_camera(camera, range, formats.depth_direction).unwrap()
}

pub fn draw_with(gpu: &Gpu, renderer: &dyn FrameRenderer, size: [u32; 2], formats: TargetFormats) -> Image {
    draw_passes(gpu, |encoder| renderer.encode(encoder), |pass| renderer.draw(pass), size, formats)
}

pub fn draw_passes(
    gpu: &Gpu,
    encode: impl FnOnce(&mut wgpu::CommandEncoder),
    draw: impl FnOnce(&mut wgpu::RenderPass<'_>),
    size: [u32; 2],
    formats: TargetFormats,
) -> Image {
    let target = Target::new(gpu, size, formats).unwrap();
    gpu.draw_after(&target, Load::Clear(GROUND), encode, draw).unwrap();
    target.read_color(gpu).unwrap()
}

pub fn count(image: &Image, matches: impl Fn(u8) -> bool) -> usize {
    image.rgba.chunks_exact(4).filter(|pixel| matches(pixel[0])).count()
}

/// Pixels of ink.
pub fn ink(image: &Image) -> usize {
    count(image, |value| value == 0)
}

pub fn is_ink(image: &Image, x: f64, y: f64) -> bool {
    image.pixel(x as u32, y as u32)[0] == 0
}

/// Pixels that differ by more than a shade.
pub fn differing(a: &Image, b: &Image) -> usize {
    let close = |a: &[u8], b: &[u8]| a.iter().zip(b).all(|(a, b)| a.abs_diff(*b) < 24);
    a.rgba.chunks_exact(4).zip(b.rgba.chunks_exact(4)).filter(|(a, b)| !close(a, b)).count()
}

pub fn camera(eye: DVec3, fov_deg: f64, size: [u32; 2]) -> Camera {
    let projection = Projection::Perspective { fov_y_rad: fov_deg.to_radians() };
    Camera::new(eye.as_vec3(), Vec3::ZERO, Vec3::Y, projection, size).unwrap()
}

/// From the front, above and right.
pub fn three_quarter(distance: f64, size: u32) -> Camera {
    camera(distance * DVec3::new(0.55, 0.35, 1.0).normalize(), 40.0, [size; 2])
}

pub fn torus() -> TriangleMesh {
    Torus::default().mesh(96, 48).unwrap()
}

pub fn sphere() -> TriangleMesh {
    Sphere { radius: 1.0 }.icosphere(5).unwrap()
}

/// A square of side 2 across the z axis, facing along it.
pub fn square(z: f32) -> TriangleMesh {
    let positions = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| Vec3::new(x, y, z));
    TriangleMesh::new(positions.to_vec(), vec![[0, 1, 2], [0, 2, 3]]).unwrap()
}

/// A camera on the z axis that shows a unit sphere with a radius of `share` of the picture's height, and that radius in pixels.
pub fn sphere_view(fov_deg: f64, share: f64, size: u32) -> (Camera, f64) {
    // The tangent of the sphere's angular radius, over that of half the field of view, is twice the share.
    let tangent = 2.0 * share * (0.5 * fov_deg.to_radians()).tan();
    let distance = (1.0 + 1.0 / (tangent * tangent)).sqrt();
    (camera(DVec3::Z * distance, fov_deg, [size; 2]), share * f64::from(size))
}

/// How wide a ring the ink is, on average, that lies around a circle, `beside` of it outside.
pub fn ring_width_px(ink_px: f64, radius_px: f64, beside: f64) -> f64 {
    // area = pi ((r + b w)^2 - (r - (1 - b) w)^2) = pi w (2 r + (2 b - 1) w)
    let area = ink_px / std::f64::consts::PI;
    let skew = 2.0 * beside - 1.0;
    if skew == 0.0 {
        area / (2.0 * radius_px)
    } else {
        ((radius_px * radius_px + skew * area).sqrt() - radius_px) / skew
    }
}
