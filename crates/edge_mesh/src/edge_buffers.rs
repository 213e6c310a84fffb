//! [`EdgeBuffers`]: the records on a device, once for all renderers of a method.

use crate::edge_record::EdgeRecord;
use silhouette_gpu::MeshTooLarge;
use silhouette_gpu::kit::storage_buffer;
use std::sync::{Arc, Mutex, PoisonError, Weak};

/// The records of a mesh on a device.
#[derive(Debug)]
pub(crate) struct EdgeBuffers {
    pub records: wgpu::Buffer,
}

/// The buffers of each device for which a renderer uses them.
#[derive(Debug, Default)]
pub(crate) struct OnDevices(Mutex<Vec<(wgpu::Device, Weak<EdgeBuffers>)>>);

impl OnDevices {
    /// The buffers on a device: those that another renderer uses already, or else new ones. Uploading takes O(E).
    pub fn get(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        records: &[EdgeRecord],
    ) -> Result<Arc<EdgeBuffers>, MeshTooLarge> {
        // Entries are added and removed as a whole, so that a panic elsewhere leaves none half-written.
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.retain(|(_, buffers)| buffers.strong_count() > 0);
        if let Some(shared) = known.iter().find(|(known, _)| known == device).and_then(|(_, buffers)| buffers.upgrade())
        {
            return Ok(shared);
        }
        let bytes: &[u8] = bytemuck::cast_slice(records);
        let buffer = storage_buffer(device, "edges", bytes.len() as u64, wgpu::BufferUsages::empty())?;
        queue.write_buffer(&buffer, 0, bytes);
        let buffers = Arc::new(EdgeBuffers { records: buffer });
        known.push((device.clone(), Arc::downgrade(&buffers)));
        Ok(buffers)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::FaceId;
    use silhouette_testing::gpu_or_skip;

    #[test]
    fn renderers_that_live_together_share_the_records() {
        let Some(gpu) = gpu_or_skip("renderers_that_live_together_share_the_records") else { return };
        let records = [EdgeRecord::boundary([0, 1], FaceId::new(0)); 100];
        let on_devices = OnDevices::default();
        let get = || on_devices.get(gpu.device(), gpu.queue(), &records).unwrap();
        let [first, second] = [get(), get()];
        assert!(Arc::ptr_eq(&first, &second) && first.records.size() == 1600);
        drop(first);
        assert!(Arc::ptr_eq(&second, &get()));
        let before = second.records.clone();
        drop(second);
        assert!(get().records != before, "uploaded anew once no renderer is left");
    }
}
