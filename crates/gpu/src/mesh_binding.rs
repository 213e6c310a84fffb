//! [`MeshBinding`]: the bind group that the stages with `shared/mesh.wgsl` in front expect at index 1.

use crate::mesh_buffers::{MeshBuffers, MeshTooLarge};

/// Positions at binding 0 and triangles, or other corners, at binding 1, as storage that stages pull from.
#[derive(Debug)]
pub struct MeshBinding {
    bind_group: wgpu::BindGroup,
}

impl MeshBinding {
    /// The layout: both bindings for vertex and compute stages.
    pub fn layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
        let entry = |binding| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::VERTEX | wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Storage { read_only: true },
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("mesh"),
            entries: &[entry(0), entry(1)],
        })
    }

    /// Binds a mesh, with `corners` in place of its triangles where there are any. `None` for a mesh without triangles.
    ///
    /// # Errors
    /// [`MeshTooLarge`] where a buffer is larger than what the device binds at once.
    pub fn new(
        device: &wgpu::Device,
        layout: &wgpu::BindGroupLayout,
        mesh: &MeshBuffers,
        corners: Option<&wgpu::Buffer>,
    ) -> Result<Option<Self>, MeshTooLarge> {
        let Some((positions, triangles)) = mesh.buffers() else { return Ok(None) };
        let corners = corners.unwrap_or(triangles);
        let limit = device.limits().max_storage_buffer_binding_size;
        for (what, buffer) in [("positions", positions), ("triangles", corners)] {
            if buffer.size() > limit {
                return Err(MeshTooLarge { what, bytes: buffer.size(), limit });
            }
        }
        let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("mesh"),
            layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: positions.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: corners.as_entire_binding() },
            ],
        });
        Ok(Some(Self { bind_group }))
    }

    /// The bind group, for index 1.
    pub fn bind_group(&self) -> &wgpu::BindGroup {
        &self.bind_group
    }
}
