//! Step 2: seeds on borders, one per pixel. Stage: `shaders/baselines/border_seeds.wgsl`.
//!
//! A pixel has a seed where the object in front there covers a part of its samples, or all of them while one of the four pixels
//! beside it has none of the object's and the object stands before what it has. Of two objects at the same depth the one with the
//! lower number counts as in front. The seed is the point of the border nearest to the pixel's middle, as if the border were
//! straight across nine pixels: it runs across the direction towards their samples that the object covers, and leaves the share of
//! them inside that it covers. The nearest of several seeds decides where ink ends, so that their errors do not cancel but add up to
//! lines that are too wide; from the four samples of the pixel alone it would be by a fifth of a pixel.

use super::object_mask;
use crate::distance_field::FieldLayouts;
use silhouette_gpu::CameraBinding;
use silhouette_gpu::kit::compute_pipeline;

/// The stage that reads the mask as group 1 and plants seeds into group 2.
pub(super) fn pipeline(device: &wgpu::Device, layouts: &FieldLayouts) -> wgpu::ComputePipeline {
    let (camera, mask) = (CameraBinding::layout(device), object_mask::layout(device));
    let bindings = [Some(&camera), Some(&mask), Some(&layouts.planting)];
    compute_pipeline(device, silhouette_shaders::baselines::BORDER_SEEDS, "plant", &bindings)
}
