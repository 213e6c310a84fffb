//! [`Hierarchies`]: those of the object and of the hull, in buffers that they share.

use crate::visibility_function::VisibilityFunction;
use silhouette_gpu::MeshTooLarge;
use silhouette_gpu::kit::storage_buffer;
use silhouette_rays::ray::FlatNode;

/// The object's nodes and faces, and after them the hull's.
#[derive(Debug)]
pub(super) struct Hierarchies {
    /// 32 bytes per node.
    pub nodes: wgpu::Buffer,
    /// 36 bytes per face.
    pub corners: wgpu::Buffer,
    /// The hull's first node.
    pub hull_root: u32,
}

impl Hierarchies {
    /// Uploads both. O(F).
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        visibility: &VisibilityFunction,
    ) -> Result<Self, MeshTooLarge> {
        let (object, hull) = (visibility.object(), visibility.hull());
        let mut nodes = object.flat_nodes();
        let hull_root = nodes.len() as u32;
        let moved = |node: FlatNode| {
            let by = if node.faces == 0 { hull_root } else { object.flat_corners().len() as u32 };
            FlatNode { first: node.first + by, ..node }
        };
        nodes.extend(hull.flat_nodes().into_iter().map(moved));
        let corners = [object.flat_corners(), hull.flat_corners()];
        let [object_bytes, hull_bytes] = corners.map(|corners| size_of_val(corners) as u64);
        let none = wgpu::BufferUsages::empty();
        let node_buffer = storage_buffer(device, "nodes of hierarchies", size_of_val(&nodes[..]) as u64, none)?;
        let corner_buffer = storage_buffer(device, "corners of faces", object_bytes + hull_bytes, none)?;
        queue.write_buffer(&node_buffer, 0, bytemuck::cast_slice(&nodes));
        queue.write_buffer(&corner_buffer, 0, bytemuck::cast_slice(corners[0]));
        queue.write_buffer(&corner_buffer, object_bytes, bytemuck::cast_slice(corners[1]));
        Ok(Self { nodes: node_buffer, corners: corner_buffer, hull_root })
    }
}
