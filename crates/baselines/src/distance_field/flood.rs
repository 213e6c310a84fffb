//! Step 2: jump flooding. Stage: `shaders/baselines/flood.wgsl`.
//!
//! Guodong Rong and Tiow-Seng Tan, "Jump flooding in GPU with applications to Voronoi diagram and distance transform", Symposium
//! on Interactive 3D Graphics and Games 2006: each pixel looks at eight others a step away for a nearer seed, and the step is halved
//! from pass to pass. A last pass with a step of one more pixel (their JFA+1, after the others) mends most of what the method
//! misses: a seed whose way to a pixel leads over pixels that know a nearer one.

use super::field::FieldLayouts;
use super::reach::Extent;
use silhouette_gpu::CameraBinding;
use silhouette_gpu::kit::{UniformBlock, bind_group, bind_layout, compute_pipeline, uniform_entry};
use silhouette_shaders::baselines::FLOOD;

/// Steps of up to 2^15 pixels, twice as far as the largest texture of any device.
const MOST_STEPS: usize = 16;

/// The stage with a uniform for each step.
#[derive(Debug, Clone)]
pub(crate) struct FloodStage {
    flood: wgpu::ComputePipeline,
    /// Of 1, 2, 4 … pixels.
    steps: Vec<wgpu::BindGroup>,
}

impl FloodStage {
    /// Compiles the stage: some milliseconds.
    pub fn pipeline(device: &wgpu::Device, layouts: &FieldLayouts) -> wgpu::ComputePipeline {
        let (camera, step) = (CameraBinding::layout(device), step_layout(device));
        compute_pipeline(device, FLOOD, "flood", &[Some(&camera), Some(&layouts.flooding), Some(&step)])
    }

    /// Uploads the steps.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, flood: &wgpu::ComputePipeline) -> Self {
        let layout = step_layout(device);
        let steps = (0..MOST_STEPS).map(|exponent| {
            let uniform = UniformBlock::<[i32; 4]>::new(device, "step of a flood");
            uniform.write(queue, &[1 << exponent, 0, 0, 0]);
            bind_group(device, "step of a flood", &layout, &[uniform.binding()])
        });
        Self { flood: flood.clone(), steps: steps.collect() }
    }

    /// How many passes a field of this extent takes.
    pub fn passes(extent: &Extent) -> u32 {
        extent.steps.min(MOST_STEPS as u32) + 1
    }

    /// Runs the passes: `floods` are bound in turn, `dispatch` covers the field.
    pub fn encode(
        &self,
        pass: &mut wgpu::ComputePass<'_>,
        extent: &Extent,
        floods: &[wgpu::BindGroup; 2],
        dispatch: impl Fn(&mut wgpu::ComputePass<'_>),
    ) {
        let halving = self.steps.iter().take(Self::passes(extent) as usize - 1).rev();
        pass.set_pipeline(&self.flood);
        for (flood, step) in floods.iter().cycle().zip(halving.chain(self.steps.first())) {
            pass.set_bind_group(1, flood, &[]);
            pass.set_bind_group(2, step, &[]);
            dispatch(pass);
        }
    }
}

fn step_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    bind_layout(device, "step of a flood", &[uniform_entry(0)])
}
