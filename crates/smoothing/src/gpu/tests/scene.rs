//! A renderer whose buffers are read back.

use crate::SmoothingOptions;
use crate::gpu::settings::SmoothingUniform;
use crate::gpu::{Room, SmoothingPipelines, SmoothingRenderer};
use crate::smoothing::Smoothing;
use crate::tests::smoothing;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Camera, DepthDirection, Framing};
use silhouette_core::{TriangleMesh, weld};
use silhouette_gpu::{Color, FrameRenderer, FrameView, MeshBuffers, Shade};
use silhouette_render::{DEFAULT_FORMATS, Gpu, Image, Load, Target};
use silhouette_testing::directions::spread;
use silhouette_testing::{builtin, views};
use std::sync::Arc;

/// Of a mesh without triangles.
const NO_BOUNDS: Bounds = Bounds { min: DVec3::ZERO, max: DVec3::ZERO, center: DVec3::ZERO, radius: 1.0 };

/// Smooth shapes and shapes with features, closed and open.
pub(super) const SHAPES: [&str; 7] = ["icosphere:1", "torus:16,10", "blob:800", "cylinder", "gear", "cube", "grid:4,4"];

/// Views from all around, in a perspective and in parallel projection by turns.
pub(super) fn cameras(mesh: &TriangleMesh, count: usize) -> Vec<Camera> {
    sized_cameras(mesh, count, 256)
}

/// The same for square images of this side, in pixels.
pub(super) fn sized_cameras(mesh: &TriangleMesh, count: usize, side: u32) -> Vec<Camera> {
    let framing = |index| if index % 2 == 0 { views::PERSPECTIVE } else { Framing::Orthographic };
    let camera = |(index, direction)| views::framed(mesh, direction, framing(index), [side; 2]);
    spread(count).enumerate().map(camera).collect()
}

pub(super) fn method(name: &str, options: SmoothingOptions) -> Smoothing {
    smoothing(builtin(name), options)
}

pub(super) fn pipelines(gpu: &Gpu) -> Arc<SmoothingPipelines> {
    Arc::new(SmoothingPipelines::new(gpu.device(), DEFAULT_FORMATS, Shade::Lit(Color::WHITE)))
}

pub(super) fn picture(gpu: &Gpu, renderer: &mut dyn FrameRenderer, view: &FrameView) -> Image {
    renderer.prepare(gpu.device(), gpu.queue(), view).unwrap();
    let target = Target::new(gpu, view.viewport().size_px, DEFAULT_FORMATS).unwrap();
    let encode = |encoder: &mut wgpu::CommandEncoder| renderer.encode(encoder);
    gpu.draw_after(&target, Load::Clear([0.0; 4]), encode, |pass| renderer.draw(pass)).unwrap();
    target.read_color(gpu).unwrap()
}

pub(super) struct Scene<'a> {
    pub gpu: &'a Gpu,
    pub mesh: Arc<MeshBuffers>,
    pub renderer: SmoothingRenderer,
}

/// What a frame left in its buffers.
pub(super) struct Frame {
    pub settings: SmoothingUniform,
    /// In the local frame.
    pub local: Vec<Vec3>,
    /// In the mesh's own space.
    pub positions: Vec<DVec3>,
    pub normals: Vec<DVec3>,
    pub state: Vec<u32>,
    pub triangles: Vec<[u32; 3]>,
}

impl<'a> Scene<'a> {
    pub fn new(gpu: &'a Gpu, pipelines: &Arc<SmoothingPipelines>, method: &Smoothing) -> Self {
        Self::with_room(gpu, pipelines, method, Room::for_mesh(method))
    }

    pub fn with_room(gpu: &'a Gpu, pipelines: &Arc<SmoothingPipelines>, method: &Smoothing, room: Room) -> Self {
        let mesh = Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), method.shading_mesh().mesh()).unwrap());
        Self::of_buffers(gpu, pipelines, method, &mesh, room)
    }

    pub fn of_buffers(
        gpu: &'a Gpu,
        pipelines: &Arc<SmoothingPipelines>,
        method: &Smoothing,
        mesh: &Arc<MeshBuffers>,
        room: Room,
    ) -> Self {
        let renderer = SmoothingRenderer::with_room(gpu.device(), gpu.queue(), method, pipelines, mesh, room).unwrap();
        Self { gpu, mesh: Arc::clone(mesh), renderer }
    }

    /// With depths that hold the surface as well.
    pub fn view(&self, camera: &Camera) -> FrameView {
        let range = self.renderer.clip_range(camera, camera.clip_range(&self.mesh.bounds().unwrap_or(NO_BOUNDS)));
        FrameView::from_camera(camera, range, DepthDirection::Reversed).unwrap()
    }

    /// The picture of a view.
    pub fn picture(&mut self, camera: &Camera) -> Image {
        let view = self.view(camera);
        picture(self.gpu, &mut self.renderer, &view)
    }

    /// Runs the stages of a view and reads back what they leave.
    pub fn frame(&mut self, camera: &Camera) -> Frame {
        let view = self.view(camera);
        self.renderer.prepare(self.gpu.device(), self.gpu.queue(), &view).unwrap();
        let mut encoder = self.gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.renderer.encode(&mut encoder);
        self.gpu.queue().submit([encoder.finish()]);
        let (buffers, frame) = (self.renderer.buffers(), self.mesh.frame());
        let center = -frame.to_local(DVec3::ZERO).as_dvec3() * frame.unit();
        let vertices: Vec<[Vec3; 2]> = read(self.gpu, &buffers.vertices);
        let arguments: Vec<u32> = read(self.gpu, &buffers.arguments);
        let mut triangles: Vec<[u32; 3]> = read(self.gpu, &buffers.indices);
        triangles.truncate(arguments[0] as usize / 3);
        Frame {
            settings: buffers.settings,
            local: vertices.iter().map(|[position, _]| *position).collect(),
            positions: vertices.iter().map(|[position, _]| position.as_dvec3() * frame.unit() + center).collect(),
            normals: vertices.iter().map(|[_, normal]| normal.as_dvec3()).collect(),
            state: read(self.gpu, &buffers.state),
            triangles,
        }
    }
}

impl Frame {
    /// Whether a shading vertex is visible.
    pub fn is_visible(&self, group: usize) -> bool {
        self.state[group] != 0
    }

    /// Pieces of the silhouette segment of a face, 0 without one.
    pub fn pieces(&self, face: usize) -> u32 {
        self.state[self.settings.segments_at as usize + face] & 0xff
    }

    /// Triangles with three different corners.
    pub fn proper_triangles(&self) -> Vec<[u32; 3]> {
        self.triangles.iter().copied().filter(|&[a, b, c]| a != b && b != c && c != a).collect()
    }

    /// The triangles as a mesh, vertices at bitwise the same position merged.
    pub fn welded(&self) -> TriangleMesh {
        weld::weld_exact(&TriangleMesh::new(self.local.clone(), self.proper_triangles()).unwrap()).mesh
    }
}

/// The elements that a buffer holds.
pub(super) fn read<T: bytemuck::Pod>(gpu: &Gpu, buffer: &wgpu::Buffer) -> Vec<T> {
    let copy = gpu.device().create_buffer(&wgpu::BufferDescriptor {
        label: Some("read-back"),
        size: buffer.size(),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    encoder.copy_buffer_to_buffer(buffer, 0, &copy, 0, buffer.size());
    gpu.queue().submit([encoder.finish()]);
    copy.map_async(wgpu::MapMode::Read, .., |result| result.unwrap());
    gpu.device().poll(wgpu::PollType::wait_indefinitely()).unwrap();
    let bytes = copy.get_mapped_range(..).unwrap();
    bytes.chunks_exact(size_of::<T>()).map(bytemuck::pod_read_unaligned).collect()
}
