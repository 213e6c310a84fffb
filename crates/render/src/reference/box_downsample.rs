//! The average of n x n samples, on the GPU. Stage: `shaders/render/box_downsample.wgsl`.

use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::target::{DEFAULT_FORMATS, Target};
use bytemuck::{Pod, Zeroable};
use silhouette_gpu::kit::{RenderStage, UniformBlock, bind_group, bind_layout, texture_entry, uniform_entry};

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
    uniform: UniformBlock<BoxUniform>,
}

impl BoxDownsample {
    pub fn new(gpu: &Gpu) -> Result<Self, GpuError> {
        let device = gpu.device();
        gpu.scoped(|| {
            let samples = texture_entry(0, wgpu::TextureSampleType::Float { filterable: false }, false);
            let layout = bind_layout(device, "box downsample", &[samples, uniform_entry(1)]);
            let pipeline = RenderStage {
                label: "box downsample",
                wgsl: silhouette_shaders::render::BOX_DOWNSAMPLE,
                vertex: "full_screen",
                fragment: "box_downsample",
                bindings: &[Some(&layout)],
                color: DEFAULT_FORMATS.color,
                ..RenderStage::default()
            }
            .build(device);
            Self { layout, pipeline, uniform: UniformBlock::new(device, "box downsample") }
        })
    }

    /// Fills the colour of `pixels` with the averages of `samples`, whose sides are `n` times as long.
    pub fn run(&self, gpu: &Gpu, samples: &Target, n: u32, pixels: &Target) -> Result<(), GpuError> {
        let bind_group = gpu.scoped(|| {
            self.uniform.write(gpu.queue(), &BoxUniform { samples_per_side: n });
            let source = wgpu::BindingResource::TextureView(samples.color_view());
            bind_group(gpu.device(), "box downsample", &self.layout, &[source, self.uniform.binding()])
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
