//! Lists the faces that later stages work on. Stages: `shaders/image_precision/face_list.wgsl`.
//!
//! Half of the faces of a closed mesh are back faces. Invocations run in lockstep, so that a stage over all of them takes
//! twice as long as one over a list of those that matter.

use silhouette_gpu::kit::{bind_layout, buffers_group, compute_pipeline, storage_buffer, storage_entry, workgroups};
use silhouette_gpu::{CameraBinding, MeshBinding, MeshTooLarge};
use silhouette_shaders::image_precision::FACE_LIST;

/// The stage that makes a list, shared by all renderers.
#[derive(Debug, Clone)]
pub(crate) struct FaceListStage {
    layout: wgpu::BindGroupLayout,
    list: wgpu::ComputePipeline,
}

impl FaceListStage {
    /// `entry` is the stage's entry point.
    pub fn new(device: &wgpu::Device, entry: &'static str) -> Self {
        let layout = bind_layout(device, "listing of faces", &[storage_entry(0, false), storage_entry(1, true)]);
        let (camera, mesh) = (CameraBinding::layout(device), MeshBinding::layout(device));
        let list = compute_pipeline(device, FACE_LIST, entry, &[Some(&camera), Some(&mesh), Some(&layout)]);
        Self { layout, list }
    }
}

/// A list that is made anew for each view, without the CPU.
#[derive(Debug)]
pub(crate) struct FaceList {
    /// Faces that there are.
    count: u32,
    /// How many are listed, then which.
    entries: wgpu::Buffer,
    filling: wgpu::BindGroup,
    stage: FaceListStage,
}

impl FaceList {
    /// `input` is bound for the stage to read.
    pub fn new(
        device: &wgpu::Device,
        stage: &FaceListStage,
        count: u32,
        input: &wgpu::Buffer,
    ) -> Result<Self, MeshTooLarge> {
        let bytes = 4 + 4 * u64::from(count);
        let entries = storage_buffer(device, "list of faces", bytes, wgpu::BufferUsages::empty())?;
        let filling = buffers_group(device, "listing of faces", &stage.layout, &[&entries, input]);
        Ok(Self { count, filling, stage: stage.clone(), entries })
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
        pass.set_pipeline(&self.stage.list);
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
