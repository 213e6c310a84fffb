//! Step 2: front faces, white, shaded or only in depth. Stage: `shaders/image_precision/front_faces.wgsl`.

use crate::settings::Interior;
use silhouette_gpu::kit::{RenderStage, WoundPipeline};
use silhouette_gpu::{CameraBinding, POSITION_LAYOUT, TargetFormats};

/// Front faces, or all of them for meshes whose winding says nothing (`culled`), over everything farther. `None` where they are
/// not drawn.
pub(crate) fn pipeline(
    device: &wgpu::Device,
    formats: TargetFormats,
    interior: Interior,
    culled: Option<wgpu::Face>,
) -> Option<WoundPipeline> {
    let (vertex, fragment) = match interior {
        Interior::None => return None,
        Interior::Paper | Interior::DepthOnly => ("paper_vertex", "paper_fragment"),
        Interior::Lit => ("front_vertex", "lit_fragment"),
        Interior::Grey => ("front_vertex", "grey_fragment"),
        Interior::Gooch => ("front_vertex", "gooch_fragment"),
    };
    let writes = if interior == Interior::DepthOnly { wgpu::ColorWrites::empty() } else { wgpu::ColorWrites::ALL };
    Some(WoundPipeline::new(device, move |device, front_face| {
        RenderStage {
            label: "image precision: front faces",
            wgsl: silhouette_shaders::image_precision::FRONT_FACES,
            vertex,
            fragment,
            bindings: &[Some(&CameraBinding::layout(device))],
            vertex_buffers: &[Some(POSITION_LAYOUT)],
            front_face,
            cull_mode: culled,
            depth: Some(formats.depth_state(formats.nearer())),
            color: formats.color,
            writes,
            samples: formats.samples,
            ..RenderStage::default()
        }
        .build(device)
    }))
}
