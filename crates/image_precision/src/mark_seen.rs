//! Marks the faces of the first layer and lists the others. Stages: `shaders/image_precision/mark_seen.wgsl`, and
//! `mark_seen.multisampled.wgsl` where the target has several samples per pixel.

use crate::back_edges::draw_arguments;
use silhouette_gpu::kit::{
    bind_group, bind_layout, compute_pipeline, storage_buffer, storage_entry, texture_entry, workgroups,
};
use silhouette_gpu::{CameraBinding, MeshTooLarge};
use silhouette_shaders::image_precision::{MARK_SEEN, MARK_SEEN_MULTISAMPLED};

/// Side of the square that a workgroup of the marking stage covers, in pixels.
const MARKED_SQUARE: u32 = 8;

/// The stages, shared by all renderers.
#[derive(Debug, Clone)]
pub(crate) struct SeenStages {
    layout: wgpu::BindGroupLayout,
    mark: wgpu::ComputePipeline,
    list: wgpu::ComputePipeline,
}

impl SeenStages {
    pub fn new(device: &wgpu::Device, samples: u32) -> Self {
        let is_multisampled = samples > 1;
        let sample_type = wgpu::TextureSampleType::Float { filterable: false };
        let layout = bind_layout(
            device,
            "first layer",
            &[
                storage_entry(0, false),
                texture_entry(1, sample_type, is_multisampled),
                storage_entry(2, false),
                storage_entry(3, false),
            ],
        );
        let stage = if is_multisampled { MARK_SEEN_MULTISAMPLED } else { MARK_SEEN };
        let camera = CameraBinding::layout(device);
        let bindings = [Some(&camera), None, Some(&layout)];
        Self {
            mark: compute_pipeline(device, stage, "mark_seen", &bindings),
            list: compute_pipeline(device, stage, "list_later_faces", &bindings),
            layout,
        }
    }
}

/// Marks of faces, and the list of those without a mark, made anew for each view.
#[derive(Debug)]
pub(crate) struct SeenFaces {
    faces: u32,
    marks: wgpu::Buffer,
    listed: wgpu::Buffer,
    arguments: wgpu::Buffer,
    stages: SeenStages,
    bound: Option<Bound>,
}

/// The texture of ids that is read.
#[derive(Debug)]
struct Bound {
    size: [u32; 2],
    group: wgpu::BindGroup,
}

impl SeenFaces {
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        stages: &SeenStages,
        faces: u32,
    ) -> Result<Self, MeshTooLarge> {
        let bytes = 4 * u64::from(faces);
        let none = wgpu::BufferUsages::empty();
        Ok(Self {
            faces,
            marks: storage_buffer(device, "marks of the first layer", bytes, none)?,
            listed: storage_buffer(device, "faces behind the first layer", bytes, none)?,
            arguments: draw_arguments(device, queue)?,
            stages: stages.clone(),
            bound: None,
        })
    }

    /// Reads this texture of face ids from now on.
    pub fn bind(&mut self, device: &wgpu::Device, ids: &wgpu::TextureView, size: [u32; 2]) {
        let resources = [
            self.marks.as_entire_binding(),
            wgpu::BindingResource::TextureView(ids),
            self.listed.as_entire_binding(),
            self.arguments.as_entire_binding(),
        ];
        self.bound = Some(Bound { size, group: bind_group(device, "first layer", &self.stages.layout, &resources) });
    }

    /// One word per face: 1 where the face is in the first layer.
    pub fn marks(&self) -> &wgpu::Buffer {
        &self.marks
    }

    /// Ids of the faces without a mark.
    pub fn listed(&self) -> &wgpu::Buffer {
        &self.listed
    }

    /// Arguments of an indirect draw of three vertices per listed face.
    pub fn arguments(&self) -> &wgpu::Buffer {
        &self.arguments
    }

    /// Marks what the bound texture shows and, where `lists`, lists the other faces.
    pub fn encode(&self, encoder: &mut wgpu::CommandEncoder, camera: &CameraBinding, lists: bool) {
        let Some(bound) = &self.bound else { return };
        encoder.clear_buffer(&self.marks, 0, None);
        encoder.clear_buffer(&self.arguments, 0, Some(4));
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_bind_group(0, camera.bind_group(), &[]);
        pass.set_bind_group(2, &bound.group, &[]);
        pass.set_pipeline(&self.stages.mark);
        let [x, y] = bound.size.map(|side| side.div_ceil(MARKED_SQUARE));
        pass.dispatch_workgroups(x, y, 1);
        if lists {
            pass.set_pipeline(&self.stages.list);
            let [x, y] = workgroups(self.faces);
            pass.dispatch_workgroups(x, y, 1);
        }
    }
}
