//! [`ChunkIndices`]: the triangles of the lines that an instance draws. Twin of `shaders/edge_mesh/listed.wgsl`.
//!
//! An index buffer for all lines of a mesh would be larger than the records. Lines are drawn in instances of [`CHUNK`] lines
//! instead, all with the same indices. An index holds the line within the chunk, and in its low bits the point of the line's
//! polygon, so that a vertex stage finds both without a division, and runs once per point and not once per corner of a triangle.

/// Lines that an instance draws.
pub(crate) const CHUNK: u32 = 1024;

/// Bits of an index that hold the point of a polygon with this many sides around either end, 1 to 16.
pub(crate) fn point_bits(end_sides: u32) -> u32 {
    (2 * (end_sides + 1)).next_power_of_two().trailing_zeros()
}

/// Instances that draw `lines` lines.
pub(crate) fn chunks(lines: u32) -> u32 {
    lines.div_ceil(CHUNK)
}

/// Indices of a chunk of lines whose ends have `end_sides` sides: each polygon as triangles around its first point.
fn indices(end_sides: u32) -> Vec<u16> {
    let bits = point_bits(end_sides);
    let triangles =
        |line: u32| (1..=2 * end_sides).flat_map(move |point| [0, point, point + 1].map(|at| line << bits | at));
    // The largest is below 1024 times 64.
    (0..CHUNK).flat_map(triangles).map(|index| index as u16).collect()
}

/// The indices on a device.
#[derive(Debug)]
pub(crate) struct ChunkIndices {
    end_sides: u32,
    buffer: wgpu::Buffer,
}

impl ChunkIndices {
    /// Indices for polygons with so many sides around either end.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, end_sides: u32) -> Self {
        let indices = indices(end_sides);
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("lines of a chunk"),
            size: size_of_val(&indices[..]) as u64,
            usage: wgpu::BufferUsages::INDEX | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        queue.write_buffer(&buffer, 0, bytemuck::cast_slice(&indices));
        Self { end_sides, buffer }
    }

    /// Replaces the indices where polygons have another number of sides than in the frame before.
    pub fn fit(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, end_sides: u32) {
        if self.end_sides != end_sides {
            *self = Self::new(device, queue, end_sides);
        }
    }

    /// Number of indices.
    pub fn count(&self) -> u32 {
        CHUNK * 6 * self.end_sides
    }

    /// Binds them.
    pub fn set(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_index_buffer(self.buffer.slice(..), wgpu::IndexFormat::Uint16);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_cover_each_polygon_of_each_line_once() {
        for end_sides in 1..=16 {
            let indices = indices(end_sides);
            assert_eq!(indices.len(), (CHUNK * 6 * end_sides) as usize);
            let bits = point_bits(end_sides);
            for (line, triangles) in indices.chunks_exact(6 * end_sides as usize).enumerate() {
                assert!(triangles.iter().all(|index| usize::from(*index) >> bits == line));
                let points: Vec<u32> = triangles.iter().map(|index| u32::from(*index) & ((1 << bits) - 1)).collect();
                for (step, triangle) in points.chunks_exact(3).enumerate() {
                    assert_eq!(triangle, [0, step as u32 + 1, step as u32 + 2]);
                }
                assert_eq!(points.iter().max(), Some(&(2 * end_sides + 1)));
            }
        }
    }

    #[test]
    fn the_chunk_is_that_of_the_stages() {
        assert!(silhouette_shaders::edge_mesh::LINES.contains(&format!("const CHUNK: u32 = {CHUNK}u;")));
        assert_eq!([0, 1, CHUNK, CHUNK + 1].map(chunks), [0, 1, 1, 2]);
    }
}
