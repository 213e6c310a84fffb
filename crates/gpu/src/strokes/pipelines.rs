//! [`StrokePipelines`]: the pipelines of a stroke style, for all meshes.

use super::line_joins::JoinInstance;
use super::line_segments::SegmentInstance;
use super::style::{Hidden, Interior, StrokeStyle};
use crate::fill::{Cull, FillPipelines, FillStyle, Shade};
use crate::formats::TargetFormats;
use crate::kit::{RenderStage, bind_layout, texture_entry, uniform_entry};
use silhouette_shaders::gpu::{LINE_JOINS, LINE_SEGMENTS};
use std::sync::Arc;

/// What all renderers of strokes in one style, on one device and formats, share.
#[derive(Debug)]
pub struct StrokePipelines {
    pub(super) formats: TargetFormats,
    pub(super) style: StrokeStyle,
    pub(super) layout: wgpu::BindGroupLayout,
    pub(super) segments: wgpu::RenderPipeline,
    pub(super) joins: wgpu::RenderPipeline,
    /// Draws the mesh's depth for the lines; none where hidden parts are drawn too.
    pub(super) depth: Option<Arc<FillPipelines>>,
    pub(super) interior: Option<Arc<FillPipelines>>,
}

/// The depth that hides lines: a single sample of 32-bit float, in the direction of the target's.
pub(super) fn depth_formats(formats: TargetFormats) -> TargetFormats {
    // The pass writes no colour; R8Unorm takes the least room.
    let (color, depth) = (wgpu::TextureFormat::R8Unorm, wgpu::TextureFormat::Depth32Float);
    TargetFormats { color, depth, samples: 1, ..formats }
}

impl StrokePipelines {
    /// Builds the pipelines for a target of these formats. Some milliseconds.
    pub fn new(device: &wgpu::Device, formats: TargetFormats, style: StrokeStyle) -> Self {
        let depth_texture = texture_entry(1, wgpu::TextureSampleType::Depth, false);
        let layout = bind_layout(device, "strokes", &[uniform_entry(0), depth_texture]);
        let stage = |label, wgsl, vertex, fragment, buffer| {
            RenderStage {
                label,
                wgsl,
                vertex,
                fragment,
                bindings: &[Some(&layout)],
                vertex_buffers: &[Some(buffer)],
                topology: wgpu::PrimitiveTopology::TriangleStrip,
                depth: Some(formats.untested_depth_state()),
                color: formats.color,
                blend: (style.ink.alpha < 1.0).then_some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
                samples: formats.samples,
                ..RenderStage::default()
            }
            .build(device)
        };
        let fill = |formats, style| Arc::new(FillPipelines::new(device, formats, style));
        let interior = match style.interior {
            Interior::Paper(color) => Some(FillStyle { shade: Shade::Flat(color), cull: Cull::None }),
            Interior::DepthOnly => Some(FillStyle::DEPTH),
            Interior::None => None,
        };
        Self {
            segments: stage(
                "line segments",
                LINE_SEGMENTS,
                "segment_vertex",
                "segment_fragment",
                SegmentInstance::LAYOUT,
            ),
            joins: stage("line joins", LINE_JOINS, "join_vertex", "join_fragment", JoinInstance::LAYOUT),
            depth: (style.hidden == Hidden::Removed).then(|| fill(depth_formats(formats), FillStyle::DEPTH)),
            interior: interior.map(|style| fill(formats, style)),
            layout,
            formats,
            style,
        }
    }
}
