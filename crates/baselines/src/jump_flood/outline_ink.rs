//! Step 4: ink around objects, in the caller's pass. Stage: `shaders/baselines/outline_ink.wgsl`.
//!
//! Ink lies where the distance to the nearest seed is at most the width at the seed's depth. In pixels that the seed's own object
//! covers in part, it lies just behind the object, whose own depth keeps it off the samples that the object covers. On an object
//! behind, it lies just before it.

use super::method::{Antialiasing, JumpFloodOptions};
use crate::distance_field::FieldLayouts;
use silhouette_gpu::kit::RenderStage;
use silhouette_gpu::{CameraBinding, TargetFormats};

/// One triangle over the whole viewport.
pub(super) fn pipeline(
    device: &wgpu::Device,
    formats: TargetFormats,
    layouts: &FieldLayouts,
    options: &JumpFloodOptions,
) -> wgpu::RenderPipeline {
    let blend = match options.antialiasing {
        Antialiasing::Samples => options.line_style().blend(),
        Antialiasing::Coverage => Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
    };
    RenderStage {
        label: "jump flood: ink",
        wgsl: silhouette_shaders::baselines::OUTLINE_INK,
        vertex: "full_screen",
        fragment: "outline_ink",
        bindings: &[Some(&CameraBinding::layout(device)), Some(&layouts.reading)],
        depth: Some(formats.depth_state(formats.nearer_or_equal())),
        color: formats.color,
        blend,
        samples: formats.samples,
        ..RenderStage::default()
    }
    .build(device)
}
