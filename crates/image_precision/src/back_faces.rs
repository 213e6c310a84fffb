//! Step 3 where it draws back faces themselves. Stage: `shaders/image_precision/back_faces.wgsl`.

use crate::ink::{blend, solid_fragment};
use crate::offset;
use crate::settings::{Settings, Variant};
use silhouette_gpu::kit::{RenderStage, WoundPipeline};
use silhouette_gpu::{CameraBinding, POSITION_LAYOUT, TargetFormats};
use silhouette_shaders::image_precision::BACK_FACES;

/// Back faces, pulled by the view's matrix or by polygon offset, or as the adapter's own lines.
pub(crate) fn pipeline(device: &wgpu::Device, formats: TargetFormats, settings: &Settings) -> WoundPipeline {
    let settings = *settings;
    let variant = settings.variant;
    let compare = if variant == Variant::Equal { wgpu::CompareFunction::Equal } else { formats.nearer_or_equal() };
    let mut depth = formats.depth_state(compare);
    if let Variant::Offset { slope, constant, clamp } = variant {
        depth.bias = offset::bias(formats, slope, constant, clamp);
    }
    let is_lines = matches!(variant, Variant::Wireframe { .. });
    WoundPipeline::new(device, move |device, front_face| {
        RenderStage {
            label: "image precision: back faces",
            wgsl: BACK_FACES,
            vertex: "back_vertex",
            fragment: solid_fragment(&settings),
            bindings: &[Some(&CameraBinding::layout(device))],
            vertex_buffers: &[Some(POSITION_LAYOUT)],
            front_face,
            cull_mode: Some(wgpu::Face::Front),
            polygon_mode: if is_lines { wgpu::PolygonMode::Line } else { wgpu::PolygonMode::Fill },
            depth: Some(depth.clone()),
            color: formats.color,
            blend: blend(&settings),
            samples: formats.samples,
            ..RenderStage::default()
        }
        .build(device)
    })
}
