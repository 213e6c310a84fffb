//! [`MeshBuffers`]: a mesh on a device.

use crate::local_frame::LocalFrame;
use silhouette_core::mesh::{Bounds, TriangleMesh};

/// Vertex layout of [`MeshBuffers`]: `@location(0) position: vec3<f32>`, in the [`LocalFrame`].
pub const POSITION_LAYOUT: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: 12,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &[wgpu::VertexAttribute { format: wgpu::VertexFormat::Float32x3, offset: 0, shader_location: 0 }],
};

/// A mesh is larger than a buffer of the device can be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("{what} of this mesh take {bytes} bytes; a buffer of this device holds at most {limit}")]
pub struct MeshTooLarge {
    /// What is too large: `"positions"`, `"triangles"`, or what a renderer derives from them.
    pub what: &'static str,
    /// Bytes they take.
    pub bytes: u64,
    /// Bytes that a buffer may hold.
    pub limit: u64,
}

/// Positions and triangles of a mesh on a device, in the mesh's own order.
#[derive(Debug)]
pub struct MeshBuffers {
    /// Vertex and index buffer; `None` for a mesh without triangles, as wgpu knows no empty bindings.
    buffers: Option<(wgpu::Buffer, wgpu::Buffer)>,
    indices: u32,
    bytes: u64,
    bounds: Option<Bounds>,
    frame: LocalFrame,
}

impl MeshBuffers {
    /// Uploads a mesh, recentred in 64 bits. O(V + F) time; 12 bytes a vertex and a face on the device, 12 bytes a
    /// vertex on the CPU meanwhile.
    ///
    /// # Errors
    /// [`MeshTooLarge`], before anything is allocated.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, mesh: &TriangleMesh) -> Result<Self, MeshTooLarge> {
        let [position_bytes, index_bytes] =
            buffer_bytes(mesh.vertex_count(), mesh.face_count(), device.limits().max_buffer_size)?;
        let bounds = mesh.bounds();
        let frame = LocalFrame::new(bounds.as_ref());
        let buffers = (mesh.face_count() > 0).then(|| {
            let local: Vec<[f32; 3]> =
                mesh.positions().iter().map(|p| frame.to_local(p.as_dvec3()).to_array()).collect();
            let positions =
                upload(device, queue, "positions", wgpu::BufferUsages::VERTEX, bytemuck::cast_slice(&local));
            let indices = bytemuck::cast_slice(mesh.triangles());
            (positions, upload(device, queue, "triangles", wgpu::BufferUsages::INDEX, indices))
        });
        let bytes = if buffers.is_some() { position_bytes + index_bytes } else { 0 };
        // A mesh has fewer than 2^32 half-edges, by validation.
        let indices = mesh.face_count() as u32 * 3;
        Ok(Self { buffers, indices, bytes, bounds, frame })
    }

    /// Binds the buffers (vertex slot 0) and draws every triangle once, with the pipeline that is set.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        if let Some((positions, indices)) = &self.buffers {
            pass.set_vertex_buffer(0, positions.slice(..));
            pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..self.indices, 0, 0..1);
        }
    }

    /// Positions and triangles, for stages that pull them by index; `None` for a mesh without triangles.
    pub fn buffers(&self) -> Option<(&wgpu::Buffer, &wgpu::Buffer)> {
        self.buffers.as_ref().map(|(positions, triangles)| (positions, triangles))
    }

    /// Number of triangles.
    pub fn face_count(&self) -> u32 {
        self.indices / 3
    }

    /// Bytes on the device.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Bounds of the mesh in world space; `None` without triangles.
    pub fn bounds(&self) -> Option<&Bounds> {
        self.bounds.as_ref()
    }

    /// The frame that the positions are in.
    pub fn frame(&self) -> &LocalFrame {
        &self.frame
    }
}

/// Bytes of the vertex and the index buffer.
fn buffer_bytes(vertices: usize, faces: usize, limit: u64) -> Result<[u64; 2], MeshTooLarge> {
    let sizes = [vertices, faces].map(|count| count as u64 * 12);
    for (what, bytes) in ["positions", "triangles"].into_iter().zip(sizes) {
        if bytes > limit {
            return Err(MeshTooLarge { what, bytes, limit });
        }
    }
    Ok(sizes)
}

fn upload(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    label: &str,
    usage: wgpu::BufferUsages,
    bytes: &[u8],
) -> wgpu::Buffer {
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: bytes.len() as u64,
        usage: usage | wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    queue.write_buffer(&buffer, 0, bytes);
    buffer
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mesh_beyond_the_largest_buffer_is_refused() {
        assert_eq!(buffer_bytes(10, 20, 240), Ok([120, 240]));
        assert_eq!(buffer_bytes(10, 20, 239), Err(MeshTooLarge { what: "triangles", bytes: 240, limit: 239 }));
        assert_eq!(buffer_bytes(10, 20, 119), Err(MeshTooLarge { what: "positions", bytes: 120, limit: 119 }));
    }
}
