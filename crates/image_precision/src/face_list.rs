//! Lists the faces that later stages work on. Stages: `shaders/image_precision/face_list.wgsl`.
//!
//! Half of the faces of a closed mesh are back faces. Invocations run in lockstep, so that a stage over all of them takes
//! twice as long as one over a list of those that matter.

use silhouette_gpu::kit::{bind_layout, buffers_group, compute_pipeline, storage_buffer, storage_entry, workgroups};
use silhouette_gpu::{CameraBinding, MeshBinding, MeshTooLarge};
use silhouette_shaders::image_precision::FACE_LIST;

/// A list that is made anew for each view, without the CPU.
#[derive(Debug)]
pub(crate) struct FaceList {
    /// Faces that there are.
    count: u32,
    /// How many are listed, then which.
    entries: wgpu::Buffer,
    filling: wgpu::BindGroup,
    list: wgpu::ComputePipeline,
}

impl FaceList {
    /// `stage` lists; `input` is bound for it to read.
    pub fn new(
        device: &wgpu::Device,
        count: u32,
        stage: &'static str,
        input: &wgpu::Buffer,
    ) -> Result<Self, MeshTooLarge> {
        let bytes = 4 + 4 * u64::from(count);
        let entries = storage_buffer(device, "list of faces", bytes, wgpu::BufferUsages::empty())?;
        let layout = bind_layout(device, "listing of faces", &[storage_entry(0, false), storage_entry(1, true)]);
        let (camera, mesh) = (CameraBinding::layout(device), MeshBinding::layout(device));
        Ok(Self {
            count,
            filling: buffers_group(device, "listing of faces", &layout, &[&entries, input]),
            list: compute_pipeline(device, FACE_LIST, stage, &[Some(&camera), Some(&mesh), Some(&layout)]),
            entries,
        })
    }

    /// Number of faces, listed or not.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// The number of entries, and the entries.
    pub fn entries(&self) -> &wgpu::Buffer {
        &self.entries
    }

    /// Empties the list.
    pub fn clear(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.clear_buffer(&self.entries, 0, Some(4));
    }

    /// Makes the list for the view and the mesh that are bound as groups 0 and 1.
    pub fn encode(&self, pass: &mut wgpu::ComputePass<'_>) {
        pass.set_bind_group(2, &self.filling, &[]);
        pass.set_pipeline(&self.list);
        let [x, y] = workgroups(self.count);
        pass.dispatch_workgroups(x, y, 1);
    }

    /// Runs the stage that is set with its groups over the list, in `rows` rows. A direct dispatch for half of all faces:
    /// stages go round again where more are listed, and an indirect one would cost more than the invocations that it saves.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass<'_>, rows: u32) {
        let [x, _] = workgroups(self.count.div_ceil(2));
        pass.dispatch_workgroups(x, rows, 1);
    }
}
