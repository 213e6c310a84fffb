//! The average of n x n samples, on the GPU. Twin of `shaders/render/box_downsample.wgsl` as to the uniform.

use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::pipeline::{Stage, texture_entry, uniform_buffer, uniform_entry};
use crate::target::{DEFAULT_FORMATS, Target};
use bytemuck::{Pod, Zeroable};

/// Twin of the struct in `shaders/render/box_downsample.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
struct BoxUniform {
    samples_per_side: u32,
}

#[derive(Debug)]
pub(super) struct BoxDownsample {
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::RenderPipeline,
    uniform: wgpu::Buffer,
}

impl BoxDownsample {
    pub fn new(gpu: &Gpu) -> Result<Self, GpuError> {
        let device = gpu.device();
        gpu.scoped(|| {
            let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some("box downsample"),
                entries: &[texture_entry(0, wgpu::TextureSampleType::Float { filterable: false }), uniform_entry(1)],
            });
            let pipeline = Stage {
                label: "box downsample",
                wgsl: silhouette_shaders::render::BOX_DOWNSAMPLE,
                fragment: "box_downsample",
                color: DEFAULT_FORMATS.color,
                ..Stage::default()
            }
            .build(device, &layout);
            Self { layout, pipeline, uniform: uniform_buffer(device, "box downsample", size_of::<BoxUniform>()) }
        })
    }

    /// Fills the colour of `pixels` with the averages of `samples`, whose sides are `n` times as long.
    pub fn run(&self, gpu: &Gpu, samples: &Target, n: u32, pixels: &Target) -> Result<(), GpuError> {
        let uniform = BoxUniform { samples_per_side: n };
        let bind_group = gpu.scoped(|| {
            gpu.queue().write_buffer(&self.uniform, 0, bytemuck::bytes_of(&uniform));
            gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("box downsample"),
                layout: &self.layout,
                entries: &[
                    wgpu::BindGroupEntry {
                        binding: 0,
                        resource: wgpu::BindingResource::TextureView(samples.color_view()),
                    },
                    wgpu::BindGroupEntry { binding: 1, resource: self.uniform.as_entire_binding() },
                ],
            })
        })?;
        gpu.draw_over(pixels, |pass| {
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &bind_group, &[]);
            pass.draw(0..3, 0..1);
        })?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_shaders::layout;
    use std::mem::offset_of;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        let members = [("samples_per_side", offset_of!(BoxUniform, samples_per_side))];
        let stage = silhouette_shaders::render::BOX_DOWNSAMPLE;
        assert!(layout::matches(stage, "BoxUniform", size_of::<BoxUniform>(), &members));
    }
}
