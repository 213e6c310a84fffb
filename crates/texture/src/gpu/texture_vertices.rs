//! [`TextureVertices`]: the hull's triangles with what is interpolated across them. Vertex stage: `shaders/texture/hull.wgsl`.

use crate::silhouette_texture::SilhouetteTexture;
use bytemuck::{Pod, Zeroable};
use silhouette_gpu::{LocalFrame, MeshTooLarge};
use std::collections::HashMap;
use std::ops::Range;

/// A corner of a hull face. Twin of the arguments of `hull_vertex`.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub(super) struct TextureVertex {
    /// In the local frame of the hull.
    pub point: [f32; 3],
    pub center: [f32; 3],
    pub tangent: [f32; 3],
    /// On the page.
    pub place: [f32; 2],
}

impl TextureVertex {
    pub const LAYOUT: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
        array_stride: size_of::<Self>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x3, 3 => Float32x2],
    };
}

/// Vertices and triangles of a hull, sorted by page. A hull vertex is repeated for each place that it has in the atlas.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct TextureVertices {
    pub vertices: Vec<TextureVertex>,
    pub triangles: Vec<[u32; 3]>,
    /// Pages with triangles, ascending, and their indices in the list of all corners.
    pub pages: Vec<(u32, Range<u32>)>,
}

impl TextureVertices {
    /// Faces on pages that do not exist are left out. O(F log F).
    pub fn new(texture: &SilhouetteTexture, frame: &LocalFrame) -> Self {
        let parts = texture.parts();
        let mesh = parts.hull.mesh();
        let mut faces: Vec<usize> = (0..mesh.face_count()).collect();
        faces.retain(|&face| parts.places[face].page < parts.size.pages);
        faces.sort_by_key(|&face| parts.places[face].page);
        let mut made = Self { vertices: Vec::new(), triangles: Vec::with_capacity(faces.len()), pages: Vec::new() };
        let mut known = HashMap::new();
        for face in faces {
            let place = &parts.places[face];
            let corners = mesh.triangles()[face];
            made.triangles.push(std::array::from_fn(|i| {
                let (vertex, at) = (corners[i] as usize, place.corners[i].to_array());
                *known.entry((vertex, place.page, at.map(f32::to_bits))).or_insert_with(|| {
                    made.vertices.push(TextureVertex {
                        point: frame.to_local(mesh.positions()[vertex].as_dvec3()).to_array(),
                        center: parts.centers[vertex].to_array(),
                        tangent: parts.tangents[vertex].to_array(),
                        place: at,
                    });
                    // At most three per face, of which a mesh has fewer than 2^32 / 3.
                    (made.vertices.len() - 1) as u32
                })
            }));
            let end = 3 * made.triangles.len() as u32;
            match made.pages.last_mut() {
                Some((page, range)) if *page == place.page => range.end = end,
                _ => made.pages.push((place.page, end - 3..end)),
            }
        }
        made
    }

    /// Uploads both; `None` for a hull without triangles.
    ///
    /// # Errors
    /// [`MeshTooLarge`], before anything is allocated.
    pub fn upload(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
    ) -> Result<Option<(wgpu::Buffer, wgpu::Buffer)>, MeshTooLarge> {
        let buffer = |what, bytes: &[u8], usage| {
            let (size, limit) = (bytes.len() as u64, device.limits().max_buffer_size);
            if size > limit {
                return Err(MeshTooLarge { what, bytes: size, limit });
            }
            let usage = usage | wgpu::BufferUsages::COPY_DST;
            let descriptor = wgpu::BufferDescriptor { label: Some(what), size, usage, mapped_at_creation: false };
            let buffer = device.create_buffer(&descriptor);
            queue.write_buffer(&buffer, 0, bytes);
            Ok(buffer)
        };
        if self.triangles.is_empty() {
            return Ok(None);
        }
        let vertices = bytemuck::cast_slice(&self.vertices);
        let triangles = bytemuck::cast_slice(&self.triangles);
        Ok(Some((
            buffer("vertices of the hull", vertices, wgpu::BufferUsages::VERTEX)?,
            buffer("triangles of the hull", triangles, wgpu::BufferUsages::INDEX)?,
        )))
    }
}
