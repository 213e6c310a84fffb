//! Step 2: front faces, white, shaded or only in depth. Stage: `shaders/image_precision/front_faces.wgsl`.

use crate::settings::Interior;
use crate::stage::{POSITIONS, Stage};
use silhouette_gpu::TargetFormats;

/// Front faces, or all of them for meshes whose winding says nothing, over everything farther; `None` where they are not
/// drawn.
pub(crate) fn pipeline(
    device: &wgpu::Device,
    layouts: &[Option<&wgpu::BindGroupLayout>],
    formats: TargetFormats,
    interior: Interior,
    culled: Option<wgpu::Face>,
) -> Option<wgpu::RenderPipeline> {
    let (vertex, fragment) = match interior {
        Interior::None => return None,
        Interior::Paper | Interior::DepthOnly => ("paper_vertex", "paper_fragment"),
        Interior::Lit => ("front_vertex", "lit_fragment"),
        Interior::Grey => ("front_vertex", "grey_fragment"),
        Interior::Gooch => ("front_vertex", "gooch_fragment"),
    };
    let write_mask = match interior {
        Interior::DepthOnly => wgpu::ColorWrites::empty(),
        _ => wgpu::ColorWrites::ALL,
    };
    let stage = Stage {
        label: "image precision: front faces",
        wgsl: silhouette_shaders::image_precision::FRONT_FACES,
        vertex,
        fragment,
        buffers: POSITIONS,
        culled,
        polygon_mode: wgpu::PolygonMode::Fill,
        depth: formats.depth_state(formats.nearer()),
    };
    let target = wgpu::ColorTargetState { write_mask, ..formats.color.into() };
    Some(stage.build_for(device, layouts, target, formats.samples))
}
