//! [`CameraUniform`] and the bind group that the stages with `shared/camera.wgsl` in front expect as their first entry.

use bytemuck::{Pod, Zeroable};
use glam::DMat4;

/// What a vertex stage must know of the camera. Twin of the struct in `shaders/shared/camera.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct CameraUniform {
    /// [`LocalFrame`](crate::LocalFrame) to clip space, column by column.
    pub to_clip: [[f32; 4]; 4],
}

impl CameraUniform {
    /// Rounds a matrix made by [`LocalFrame::to_clip`](crate::LocalFrame::to_clip).
    pub fn new(to_clip: DMat4) -> Self {
        Self { to_clip: to_clip.as_mat4().to_cols_array_2d() }
    }
}

/// A bind group with the [`CameraUniform`] at binding 0 and one more uniform of the stage's own at binding 1.
///
/// Both lie in buffers of their own, allocated once.
#[derive(Debug)]
pub struct CameraBinding {
    camera: wgpu::Buffer,
    own: wgpu::Buffer,
    bind_group: wgpu::BindGroup,
}

impl CameraBinding {
    /// The layout: both bindings for vertex, fragment and compute stages.
    pub fn layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
        let entry = |binding| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::VERTEX_FRAGMENT | wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("camera and own uniform"),
            entries: &[entry(0), entry(1)],
        })
    }

    /// Allocates the buffers, the second with `own_size` bytes (above 0).
    pub fn new(device: &wgpu::Device, layout: &wgpu::BindGroupLayout, own_size: usize) -> Self {
        let buffer = |label, size| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size,
                usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        };
        let camera = buffer("camera uniform", size_of::<CameraUniform>() as u64);
        let own = buffer("own uniform", own_size as u64);
        let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("camera and own uniform"),
            layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: camera.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: own.as_entire_binding() },
            ],
        });
        Self { camera, own, bind_group }
    }

    /// Uploads both uniforms; they take effect with the next submit.
    pub fn write(&self, queue: &wgpu::Queue, camera: &CameraUniform, own: &impl Pod) {
        queue.write_buffer(&self.camera, 0, bytemuck::bytes_of(camera));
        queue.write_buffer(&self.own, 0, bytemuck::bytes_of(own));
    }

    /// The bind group, for index 0.
    pub fn bind_group(&self) -> &wgpu::BindGroup {
        &self.bind_group
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_shaders::layout;
    use std::mem::offset_of;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        let members = [("to_clip", offset_of!(CameraUniform, to_clip))];
        let stage = silhouette_shaders::gpu::FILL;
        assert!(layout::matches(stage, "CameraUniform", size_of::<CameraUniform>(), &members));
    }
}
