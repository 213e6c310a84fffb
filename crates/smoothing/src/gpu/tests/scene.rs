//! A renderer whose buffers are read back.

use crate::gpu::buffers::FrameBuffers;
use crate::gpu::{Room, SmoothingPipelines, SmoothingRenderer};
use crate::smoothing::Smoothing;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::view::Camera;
use silhouette_gpu::{Color, FrameRenderer as _, FrameView, LocalFrame, MeshBuffers, Shade};
use silhouette_render::{DEFAULT_FORMATS, Gpu, view_of_mesh};
use std::sync::Arc;

pub(super) struct Scene<'a> {
    pub gpu: &'a Gpu,
    pub mesh: Arc<MeshBuffers>,
    pub renderer: SmoothingRenderer,
}

/// What a frame left in its buffers, in the mesh's own space.
pub(super) struct Frame {
    pub positions: Vec<DVec3>,
    pub normals: Vec<DVec3>,
    pub state: Vec<u32>,
    pub sums: Vec<[u32; 4]>,
    pub triangles: Vec<[u32; 3]>,
}

pub(super) fn pipelines(gpu: &Gpu) -> Arc<SmoothingPipelines> {
    Arc::new(SmoothingPipelines::new(gpu.device(), DEFAULT_FORMATS, Shade::Lit(Color::WHITE)))
}

impl<'a> Scene<'a> {
    pub fn new(gpu: &'a Gpu, pipelines: &Arc<SmoothingPipelines>, method: &Smoothing, room: Room) -> Self {
        let mesh = Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), method.shading_mesh().mesh()).unwrap());
        let renderer =
            SmoothingRenderer::with_room(gpu.device(), gpu.queue(), method, pipelines, &mesh, room).unwrap();
        Self { gpu, mesh, renderer }
    }

    pub fn view(&self, camera: &Camera) -> FrameView {
        view_of_mesh(camera, &self.mesh).unwrap()
    }

    /// Runs the stages of a view and reads back what they leave.
    pub fn frame(&mut self, camera: &Camera) -> Frame {
        let view = self.view(camera);
        self.renderer.prepare(self.gpu.device(), self.gpu.queue(), &view).unwrap();
        let mut encoder = self.gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.renderer.encode(&mut encoder);
        self.gpu.queue().submit([encoder.finish()]);
        Frame::read(self.gpu, self.renderer.buffers(), self.mesh.frame())
    }
}

impl Frame {
    fn read(gpu: &Gpu, buffers: &FrameBuffers, frame: &LocalFrame) -> Self {
        let center = -frame.to_local(DVec3::ZERO).as_dvec3() * frame.unit();
        let vertices: Vec<[Vec3; 2]> = read(gpu, &buffers.vertices);
        let arguments: Vec<u32> = read(gpu, &buffers.arguments);
        let mut triangles: Vec<[u32; 3]> = read(gpu, &buffers.indices);
        triangles.truncate(arguments[0] as usize / 3);
        Self {
            positions: vertices.iter().map(|[position, _]| position.as_dvec3() * frame.unit() + center).collect(),
            normals: vertices.iter().map(|[_, normal]| normal.as_dvec3()).collect(),
            state: read(gpu, &buffers.state),
            sums: read(gpu, &buffers.sums),
            triangles,
        }
    }
}

fn read<T: bytemuck::Pod>(gpu: &Gpu, buffer: &wgpu::Buffer) -> Vec<T> {
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
