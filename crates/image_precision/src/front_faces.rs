//! Step 2: front faces, white or shaded. Stage: `shaders/image_precision/front_faces.wgsl`.

use crate::settings::Interior;
use silhouette_gpu::kit::RenderStage;
use silhouette_gpu::{CameraBinding, POSITION_LAYOUT, TargetFormats};

/// Front faces, or all of them for meshes whose winding says nothing, over everything farther.
pub(crate) fn pipeline(
    device: &wgpu::Device,
    formats: TargetFormats,
    interior: Interior,
    culled: Option<wgpu::Face>,
) -> wgpu::RenderPipeline {
    let (vertex, fragment) = match interior {
        Interior::Paper => ("paper_vertex", "paper_fragment"),
        Interior::Lit => ("front_vertex", "lit_fragment"),
        Interior::Grey => ("front_vertex", "grey_fragment"),
        Interior::Gooch => ("front_vertex", "gooch_fragment"),
    };
    RenderStage {
        label: "image precision: front faces",
        wgsl: silhouette_shaders::image_precision::FRONT_FACES,
        vertex,
        fragment,
        bindings: &[Some(&CameraBinding::layout(device))],
        vertex_buffers: &[Some(POSITION_LAYOUT)],
        cull_mode: culled,
        depth: Some(formats.depth_state(formats.nearer())),
        color: formats.color,
        samples: formats.samples,
        ..RenderStage::default()
    }
    .build(device)
}
