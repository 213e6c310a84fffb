//! Step 2: front faces, white. Stage: `shaders/image_precision/front_faces.wgsl`.

use crate::renderer::Stage;
use silhouette_gpu::TargetFormats;

/// Front faces alone, over everything farther.
pub(crate) fn pipeline(
    device: &wgpu::Device,
    layout: &wgpu::PipelineLayout,
    formats: TargetFormats,
) -> wgpu::RenderPipeline {
    Stage {
        label: "image precision: front faces",
        wgsl: silhouette_shaders::image_precision::FRONT_FACES,
        vertex: "front_vertex",
        fragment: "front_fragment",
        culled: wgpu::Face::Back,
        compare: formats.nearer(),
    }
    .build(device, layout, formats)
}
