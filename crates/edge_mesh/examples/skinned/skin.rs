//! Linear blend skinning on the device.

use crate::beam::weight;
use silhouette_core::TriangleMesh;
use silhouette_core::glam::Mat4;
#[cfg(test)]
use silhouette_core::glam::Vec3;
use silhouette_render::Gpu;

/// The matrices of both joints: the lower half stands, the upper half turns about the middle.
pub fn joints(bend_rad: f64) -> [Mat4; 2] {
    [Mat4::IDENTITY, Mat4::from_rotation_z(bend_rad as f32)]
}

/// Where a vertex is, as the stage computes it.
#[cfg(test)]
pub fn skinned(position: Vec3, joints: &[Mat4; 2]) -> Vec3 {
    let [lower, upper] = joints.map(|joint| joint.transform_point3(position));
    lower.lerp(upper, weight(position))
}

/// A pose: the mesh at rest, its weights, and the positions that the stage writes.
pub struct Skin {
    pipeline: wgpu::ComputePipeline,
    group: wgpu::BindGroup,
    joints: wgpu::Buffer,
    positions: wgpu::Buffer,
    vertices: u32,
}

impl Skin {
    pub fn new(gpu: &Gpu, mesh: &TriangleMesh) -> Self {
        let device = gpu.device();
        let buffer = |bytes: &[u8], usage| {
            let buffer = device.create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size: bytes.len() as u64,
                usage: usage | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            });
            gpu.queue().write_buffer(&buffer, 0, bytes);
            buffer
        };
        let weights: Vec<f32> = mesh.positions().iter().map(|&position| weight(position)).collect();
        let storage = wgpu::BufferUsages::STORAGE;
        let rest = buffer(bytemuck::cast_slice(mesh.positions()), storage);
        let weights = buffer(bytemuck::cast_slice(&weights), storage);
        let positions = buffer(bytemuck::cast_slice(mesh.positions()), storage | wgpu::BufferUsages::VERTEX);
        let joints = buffer(&[0; 128], wgpu::BufferUsages::UNIFORM);
        let module = device.create_shader_module(wgpu::include_wgsl!("skin.wgsl"));
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some("skin"),
            layout: None,
            module: &module,
            entry_point: Some("skin"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        });
        let entry =
            |binding, buffer| wgpu::BindGroupEntry { binding, resource: wgpu::Buffer::as_entire_binding(buffer) };
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("skin"),
            layout: &pipeline.get_bind_group_layout(0),
            entries: &[entry(0, &joints), entry(1, &rest), entry(2, &weights), entry(3, &positions)],
        });
        Self { pipeline, group, joints, positions, vertices: mesh.vertex_count() as u32 }
    }

    /// The buffer that the stage writes.
    pub fn positions(&self) -> &wgpu::Buffer {
        &self.positions
    }

    /// Uploads this frame's joints.
    pub fn prepare(&self, gpu: &Gpu, joints: &[Mat4; 2]) {
        gpu.queue().write_buffer(&self.joints, 0, bytemuck::cast_slice(&joints.map(|joint| joint.to_cols_array())));
    }

    /// Records the stage.
    pub fn encode(&self, encoder: &mut wgpu::CommandEncoder) {
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        pass.dispatch_workgroups(self.vertices.div_ceil(64), 1, 1);
    }
}
