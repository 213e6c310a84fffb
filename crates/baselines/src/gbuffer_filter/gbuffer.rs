//! Step 1: depth and normals of the mesh, one sample per pixel. Stage: `shaders/baselines/gbuffer.wgsl`.

use super::discontinuities::ThresholdsUniform;
use crate::distance_field::{OFFSCREEN_DEPTH, Offscreen};
use bytemuck::{Pod, Zeroable};
use silhouette_gpu::kit::{RenderStage, UniformBlock, bind_group, bind_layout, texture_entry, uniform_entry};
use silhouette_gpu::{CameraBinding, FrameView, LocalFrame, POSITION_LAYOUT, TargetFormats};
use wgpu::TextureFormat;

const NORMALS: TextureFormat = TextureFormat::Rgba16Float;

/// Twin of the struct in `gbuffer.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub(super) struct SurfaceFrame {
    shape: [[f32; 4]; 3],
}

impl SurfaceFrame {
    pub fn new(frame: &LocalFrame, view: &FrameView) -> Self {
        Self { shape: frame.shape(view).as_mat3().to_cols_array_2d().map(|[x, y, z]| [x, y, z, 0.0]) }
    }
}

/// The pipeline, for faces of any winding.
pub(super) fn pipeline(device: &wgpu::Device, formats: TargetFormats) -> wgpu::RenderPipeline {
    RenderStage {
        label: "G-buffer",
        wgsl: silhouette_shaders::baselines::GBUFFER,
        vertex: "surface_vertex",
        fragment: "surface_normal",
        bindings: &[Some(&CameraBinding::layout(device))],
        vertex_buffers: &[Some(POSITION_LAYOUT)],
        depth: Some(wgpu::DepthStencilState { format: OFFSCREEN_DEPTH, ..formats.depth_state(formats.nearer()) }),
        color: NORMALS,
        ..RenderStage::default()
    }
    .build(device)
}

/// Layout of the G-buffer and the thresholds, for the filter.
pub(super) fn layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    let normals = wgpu::TextureSampleType::Float { filterable: false };
    let textures = [texture_entry(0, normals, false), texture_entry(1, wgpu::TextureSampleType::Depth, false)];
    bind_layout(device, "G-buffer", &[textures[0], textures[1], uniform_entry(2)])
}

/// Normals and depths, 12 bytes per pixel.
#[derive(Debug)]
pub(super) struct Gbuffer {
    /// What is drawn into.
    pub picture: Offscreen,
    /// What the filter reads, for group 1.
    pub read: wgpu::BindGroup,
}

impl Gbuffer {
    pub fn new(device: &wgpu::Device, size_px: [u32; 2], thresholds: &UniformBlock<ThresholdsUniform>) -> Self {
        let picture = Offscreen::new(device, "G-buffer", NORMALS, 1, size_px);
        let [normals, depth] = [&picture.color, &picture.depth].map(wgpu::BindingResource::TextureView);
        let read = bind_group(device, "G-buffer", &layout(device), &[normals, depth, thresholds.binding()]);
        Self { picture, read }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        let members = [("shape", std::mem::offset_of!(SurfaceFrame, shape))];
        let stage = silhouette_shaders::baselines::GBUFFER;
        assert!(silhouette_shaders::layout::matches(stage, "SurfaceFrame", size_of::<SurfaceFrame>(), &members));
    }
}
