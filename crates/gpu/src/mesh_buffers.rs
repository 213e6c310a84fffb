//! [`MeshBuffers`]: a mesh on a device.

use crate::local_frame::LocalFrame;
use glam::Vec3;
use silhouette_core::id::VertexId;
use silhouette_core::mesh::{Bounds, TriangleMesh};
use silhouette_core::method::PositionsError;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Vertex layout of [`MeshBuffers`]: `@location(0) position: vec3<f32>`, in the [`LocalFrame`].
pub const POSITION_LAYOUT: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: POSITION_BYTES,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &[wgpu::VertexAttribute { format: wgpu::VertexFormat::Float32x3, offset: 0, shader_location: 0 }],
};

/// Bytes of a position.
const POSITION_BYTES: u64 = 12;

/// What stages do with positions: pull them by index, or take them from the vertex buffer.
const POSITION_USAGE: wgpu::BufferUsages = wgpu::BufferUsages::VERTEX.union(wgpu::BufferUsages::STORAGE);

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

/// Why a position buffer of the caller's cannot be used.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PositionBufferError {
    /// Too many triangles.
    #[error(transparent)]
    MeshTooLarge(#[from] MeshTooLarge),
    /// The buffer was made for other uses.
    #[error("the position buffer needs the usages VERTEX and STORAGE")]
    Usage,
    /// A triangle names a vertex beyond the buffer's end.
    #[error("a triangle names vertex {vertex}, but the position buffer holds {held}, 12 bytes each")]
    TooShort {
        /// The highest vertex that is named.
        vertex: u32,
        /// Positions that the buffer holds.
        held: u64,
    },
}

/// Positions and triangles of a mesh on a device, in the mesh's own order. Made once and shared by all renderers of the mesh.
///
/// Positions may change from frame to frame while the triangles stay: by [`set_positions`](Self::set_positions), or in a buffer
/// of the caller's ([`from_position_buffer`](Self::from_position_buffer)) that a compute stage fills.
#[derive(Debug)]
pub struct MeshBuffers {
    /// Positions and triangles; `None` for a mesh without triangles, as wgpu knows no empty bindings.
    buffers: Option<(wgpu::Buffer, wgpu::Buffer)>,
    vertices: usize,
    indices: u32,
    bytes: u64,
    frame: LocalFrame,
    pose: Mutex<Pose>,
}

/// Where the vertices are.
#[derive(Debug, Clone, Copy)]
struct Pose {
    bounds: Option<Bounds>,
    is_rest: bool,
}

impl MeshBuffers {
    /// Uploads a mesh, recentred in 64 bits. O(V + F) time; 12 bytes per vertex and per face on the device, 12 bytes per
    /// vertex on the CPU meanwhile.
    ///
    /// # Errors
    /// [`MeshTooLarge`], before anything is allocated.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, mesh: &TriangleMesh) -> Result<Self, MeshTooLarge> {
        let limit = device.limits().max_buffer_size;
        let position_bytes = buffer_bytes("positions", mesh.vertex_count(), limit)?;
        let index_bytes = buffer_bytes("triangles", mesh.face_count(), limit)?;
        let bounds = mesh.bounds();
        let frame = LocalFrame::new(bounds.as_ref());
        let buffers = (mesh.face_count() > 0).then(|| {
            let local: Vec<[f32; 3]> =
                mesh.positions().iter().map(|p| frame.to_local(p.as_dvec3()).to_array()).collect();
            let positions = upload(device, queue, "positions", POSITION_USAGE, bytemuck::cast_slice(&local));
            (positions, upload_triangles(device, queue, mesh.triangles()))
        });
        let bytes = if buffers.is_some() { position_bytes + index_bytes } else { 0 };
        // A mesh has fewer than 2^32 half-edges, by validation.
        let indices = mesh.face_count() as u32 * 3;
        let pose = Mutex::new(Pose { bounds, is_rest: true });
        Ok(Self { buffers, vertices: mesh.vertex_count(), indices, bytes, frame, pose })
    }

    /// Reads positions from the caller's own buffer, three 32-bit floats per vertex in the mesh's own space, without a copy:
    /// what a skinning stage writes is drawn in the same submission. `bounds` must hold all vertices of the next frame; say so
    /// when they change ([`set_bounds`](Self::set_bounds)). Positions are not recentred, so that they should lie about the
    /// origin; the model matrix of the [`FrameView`](crate::FrameView) moves them in 64 bits.
    ///
    /// # Errors
    /// [`PositionBufferError`].
    pub fn from_position_buffer(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        positions: wgpu::Buffer,
        triangles: &[[u32; 3]],
        bounds: Bounds,
    ) -> Result<Self, PositionBufferError> {
        let index_bytes = buffer_bytes("triangles", triangles.len(), device.limits().max_buffer_size)?;
        if !positions.usage().contains(POSITION_USAGE) {
            return Err(PositionBufferError::Usage);
        }
        let held = positions.size() / POSITION_BYTES;
        if let Some(vertex) = triangles.iter().flatten().copied().max().filter(|&vertex| u64::from(vertex) >= held) {
            return Err(PositionBufferError::TooShort { vertex, held });
        }
        let buffers = (!triangles.is_empty()).then(|| (positions, upload_triangles(device, queue, triangles)));
        let pose = Mutex::new(Pose { bounds: Some(bounds), is_rest: false });
        let frame = LocalFrame::new(None);
        let indices = triangles.len() as u32 * 3;
        Ok(Self { buffers, vertices: held as usize, indices, bytes: index_bytes, frame, pose })
    }

    /// Replaces the positions, one per vertex in the mesh's own space, from the next submission on. O(V), allocates nothing.
    /// Where they leave the bounds that the mesh had at first by many times its size, precision falls off as it does far from
    /// the origin.
    ///
    /// # Errors
    /// [`PositionsError`]; the positions of before then stay in force.
    pub fn set_positions(&self, queue: &wgpu::Queue, positions: &[Vec3]) -> Result<(), PositionsError> {
        if positions.len() != self.vertices {
            return Err(PositionsError::Count { given: positions.len(), vertices: self.vertices });
        }
        if let Some(vertex) = positions.iter().position(|position| !position.is_finite()) {
            return Err(PositionsError::NotFinite { vertex: VertexId::from_usize(vertex) });
        }
        let Some((buffer, _)) = &self.buffers else { return Ok(()) };
        let size = wgpu::BufferSize::new(POSITION_BYTES * positions.len() as u64);
        if let Some(mut view) = size.and_then(|size| queue.write_buffer_with(buffer, 0, size)) {
            let local = |position: &Vec3| self.frame.to_local(position.as_dvec3()).to_array();
            let (places, _) = view.slice(..).into_chunks::<{ POSITION_BYTES as usize }>();
            places.write_iter(positions.iter().map(|position| bytemuck::cast(local(position))));
        }
        *self.pose() = Pose { bounds: Bounds::of(positions.iter().copied()), is_rest: false };
        Ok(())
    }

    /// Replaces the bounds, for positions that the CPU does not see.
    pub fn set_bounds(&self, bounds: Bounds) {
        self.pose().bounds = Some(bounds);
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

    /// Number of vertices that the position buffer holds.
    pub fn vertex_count(&self) -> usize {
        self.vertices
    }

    /// Number of triangles.
    pub fn face_count(&self) -> u32 {
        self.indices / 3
    }

    /// Bytes on the device, the caller's own buffer left out.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Bounds in the mesh's own space; `None` without triangles.
    pub fn bounds(&self) -> Option<Bounds> {
        self.pose().bounds
    }

    /// Whether the positions are still those of the mesh that was uploaded.
    pub fn is_at_rest(&self) -> bool {
        self.pose().is_rest
    }

    /// The frame that the positions are in.
    pub fn frame(&self) -> &LocalFrame {
        &self.frame
    }

    /// A pose is replaced as a whole, so that a panic elsewhere leaves none half-written.
    fn pose(&self) -> MutexGuard<'_, Pose> {
        self.pose.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Bytes of a buffer with three numbers for each of `count` elements.
fn buffer_bytes(what: &'static str, count: usize, limit: u64) -> Result<u64, MeshTooLarge> {
    let bytes = count as u64 * POSITION_BYTES;
    if bytes > limit { Err(MeshTooLarge { what, bytes, limit }) } else { Ok(bytes) }
}

fn upload_triangles(device: &wgpu::Device, queue: &wgpu::Queue, triangles: &[[u32; 3]]) -> wgpu::Buffer {
    let usage = wgpu::BufferUsages::INDEX | wgpu::BufferUsages::STORAGE;
    upload(device, queue, "triangles", usage, bytemuck::cast_slice(triangles))
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
        usage: usage | wgpu::BufferUsages::COPY_DST,
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
        assert_eq!(buffer_bytes("positions", 20, 240), Ok(240));
        assert_eq!(buffer_bytes("triangles", 20, 239), Err(MeshTooLarge { what: "triangles", bytes: 240, limit: 239 }));
    }
}
