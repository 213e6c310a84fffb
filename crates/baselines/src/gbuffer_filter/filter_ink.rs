//! Step 4: ink along discontinuities, in the caller's pass. Stage: `shaders/baselines/filter_ink.wgsl`.
//!
//! A pixel is inked within half of the width of its nearest seed, at the depth of what is nearest around the seed and around the
//! pixel itself: ink on either side of a line lies on the surface, and what stands before both hides it.

use super::method::GbufferFilterOptions;
use crate::distance_field::FieldLayouts;
use silhouette_gpu::kit::RenderStage;
use silhouette_gpu::{CameraBinding, TargetFormats};

/// One triangle over the whole viewport.
pub(super) fn pipeline(
    device: &wgpu::Device,
    formats: TargetFormats,
    layouts: &FieldLayouts,
    options: &GbufferFilterOptions,
) -> wgpu::RenderPipeline {
    RenderStage {
        label: "G-buffer filter: ink",
        wgsl: silhouette_shaders::baselines::FILTER_INK,
        vertex: "full_screen",
        fragment: "filter_ink",
        bindings: &[Some(&CameraBinding::layout(device)), Some(&layouts.reading)],
        depth: Some(formats.depth_state(formats.nearer_or_equal())),
        color: formats.color,
        blend: options.line_style().blend(),
        samples: formats.samples,
        ..RenderStage::default()
    }
    .build(device)
}
