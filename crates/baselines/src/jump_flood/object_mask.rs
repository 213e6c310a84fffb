//! Step 1: which object is nearest at each sample, and how near. Stage: `shaders/baselines/object_mask.wgsl`.

use crate::distance_field::{OFFSCREEN_DEPTH, Offscreen};
use bytemuck::{Pod, Zeroable};
use silhouette_gpu::kit::{RenderStage, bind_group, bind_layout, texture_entry};
use silhouette_gpu::{CameraBinding, POSITION_LAYOUT, TargetFormats};
use wgpu::TextureFormat;

/// Objects that a group may have: numbers of 16 bits, of which 0 is the ground. Larger numbers cannot be multisampled.
pub(super) const MOST_OBJECTS: usize = 0xffff;

const OBJECTS: TextureFormat = TextureFormat::R16Uint;

/// Every device of WebGPU has four.
const SAMPLES: u32 = 4;

/// Twin of the struct in `object_mask.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub(super) struct ObjectUniform {
    pub object: u32,
    pub _pad: [u32; 3],
}

/// The pipeline for objects of any winding.
pub(super) fn pipeline(device: &wgpu::Device, formats: TargetFormats) -> wgpu::RenderPipeline {
    RenderStage {
        label: "mask of objects",
        wgsl: silhouette_shaders::baselines::OBJECT_MASK,
        vertex: "object_vertex",
        fragment: "object_number",
        bindings: &[Some(&CameraBinding::layout(device))],
        vertex_buffers: &[Some(POSITION_LAYOUT)],
        depth: Some(wgpu::DepthStencilState { format: OFFSCREEN_DEPTH, ..formats.depth_state(formats.nearer()) }),
        color: OBJECTS,
        samples: SAMPLES,
        ..RenderStage::default()
    }
    .build(device)
}

/// Layout of the mask for the stage that reads it.
pub(super) fn layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    let entries = [wgpu::TextureSampleType::Uint, wgpu::TextureSampleType::Depth];
    bind_layout(device, "mask of objects", &[0, 1].map(|at| texture_entry(at, entries[at as usize], true)))
}

/// Numbers and depths, 24 bytes per pixel.
#[derive(Debug)]
pub(super) struct ObjectMask {
    /// What is drawn into.
    pub picture: Offscreen,
    /// What the next stage reads, for group 1.
    pub read: wgpu::BindGroup,
}

impl ObjectMask {
    pub fn new(device: &wgpu::Device, size_px: [u32; 2]) -> Self {
        let picture = Offscreen::new(device, "mask of objects", OBJECTS, SAMPLES, size_px);
        let resources = [&picture.color, &picture.depth].map(wgpu::BindingResource::TextureView);
        let read = bind_group(device, "mask of objects", &layout(device), &resources);
        Self { picture, read }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        let members = [("object", std::mem::offset_of!(ObjectUniform, object))];
        let stage = silhouette_shaders::baselines::OBJECT_MASK;
        assert!(silhouette_shaders::layout::matches(stage, "ObjectUniform", size_of::<ObjectUniform>(), &members));
    }
}
