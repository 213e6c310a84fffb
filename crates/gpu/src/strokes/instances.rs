//! [`InstanceBuffer`]: a vertex buffer that grows to the largest frame.

use crate::mesh_buffers::MeshTooLarge;
use bytemuck::Pod;

/// Instances of one frame; the memory is kept.
#[derive(Debug, Default)]
pub(super) struct InstanceBuffer {
    buffer: Option<wgpu::Buffer>,
    count: u32,
}

impl InstanceBuffer {
    /// Replaces the instances. A buffer that is too small is replaced by one of the next power of two.
    ///
    /// # Errors
    /// [`MeshTooLarge`] where no buffer of the device can hold them; there are none then.
    pub fn upload<T: Pod>(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        what: &'static str,
        instances: &[T],
    ) -> Result<(), MeshTooLarge> {
        self.count = 0;
        let bytes = size_of_val(instances) as u64;
        let limit = device.limits().max_buffer_size;
        let (true, Ok(count)) = (bytes <= limit, u32::try_from(instances.len())) else {
            return Err(MeshTooLarge { what, bytes, limit });
        };
        if count == 0 {
            return Ok(());
        }
        let buffer = match self.buffer.take().filter(|buffer| buffer.size() >= bytes) {
            Some(kept) => kept,
            None => device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(what),
                size: bytes.next_power_of_two().min(limit / 4 * 4),
                usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            }),
        };
        queue.write_buffer(&buffer, 0, bytemuck::cast_slice(instances));
        self.buffer = Some(buffer);
        self.count = count;
        Ok(())
    }

    /// The buffer and the number of instances; `None` where there are none.
    pub fn filled(&self) -> Option<(&wgpu::Buffer, u32)> {
        self.buffer.as_ref().filter(|_| self.count > 0).map(|buffer| (buffer, self.count))
    }
}
