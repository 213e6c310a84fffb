//! [`StrokeRenderer`]: buffers, bindings and passes of the strokes.

use super::instances::InstanceBuffer;
use super::line_segments::{Projector, Strokes};
use super::line_visibility::DepthScale;
use super::pipelines::{StrokePipelines, depth_formats};
use super::polylines::Polylines;
use super::scene_depth::SceneDepthTexture;
use super::style::{Hidden, Join};
use crate::fill::FillRenderer;
use crate::frame_renderer::FrameRenderer;
use crate::frame_view::{FrameView, Viewport};
use crate::kit::{UniformBlock, bind_group};
use crate::mesh_buffers::MeshBuffers;
use crate::renderer_error::RendererError;
use bytemuck::{Pod, Zeroable};
use std::sync::Arc;

/// Twin of the struct in `shaders/gpu/line_visibility.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
struct LineUniform {
    origin_px: [f32; 2],
    viewport_px: [f32; 2],
    depth_origin_px: [f32; 2],
    span_px: [f32; 2],
    color: [f32; 4],
    depth_of_value: [f32; 4],
    away_scale: f32,
    away_step: f32,
    clear_depth: f32,
    relative_tolerance: f32,
    absolute_tolerance: f32,
    most_tolerance: f32,
    join: u32,
    miter_limit: f32,
    hide: u32,
    _pad: [u32; 3],
}

/// Draws polylines as strokes, hidden where the mesh is in front.
///
/// Before the caller's pass the depth of the mesh is drawn into a texture of the renderer's own, as large as the viewport, or the
/// caller names a texture that holds the depth of everything that hides lines ([`set_scene_depth`](Self::set_scene_depth)). In the
/// pass the interior is drawn, then the strokes, which neither test nor write depth.
///
/// Upload: 28 bytes per segment and 36 per turn, every frame. Buffers grow to the largest frame and are kept.
#[derive(Debug)]
pub struct StrokeRenderer {
    pipelines: Arc<StrokePipelines>,
    mesh: Arc<MeshBuffers>,
    lines: Polylines,
    strokes: Strokes,
    segments: InstanceBuffer,
    joins: InstanceBuffer,
    uniform: UniformBlock<LineUniform>,
    interior: Option<FillRenderer>,
    depth: Option<FillRenderer>,
    own_depth: Option<SceneDepthTexture>,
    callers_depth: Option<wgpu::TextureView>,
    /// The depth that is bound, and the binding.
    bound: Option<(wgpu::TextureView, wgpu::BindGroup)>,
    viewport: Option<Viewport>,
}

impl StrokeRenderer {
    /// A renderer of one instance of a mesh, without lines yet.
    pub fn new(device: &wgpu::Device, pipelines: &Arc<StrokePipelines>, mesh: &Arc<MeshBuffers>) -> Self {
        Self {
            pipelines: Arc::clone(pipelines),
            mesh: Arc::clone(mesh),
            lines: Polylines::new(),
            strokes: Strokes::default(),
            segments: InstanceBuffer::default(),
            joins: InstanceBuffer::default(),
            uniform: UniformBlock::new(device, "strokes"),
            interior: pipelines.interior.as_ref().map(|fill| FillRenderer::new(device, fill, mesh)),
            depth: pipelines.depth.as_ref().map(|fill| FillRenderer::new(device, fill, mesh)),
            own_depth: None,
            callers_depth: None,
            bound: None,
            viewport: None,
        }
    }

    /// The lines, in the mesh's own space; whatever is changed takes effect with the next view prepared.
    pub fn lines_mut(&mut self) -> &mut Polylines {
        &mut self.lines
    }

    /// The mesh that hides the lines.
    pub fn mesh(&self) -> &Arc<MeshBuffers> {
        &self.mesh
    }

    /// Hides lines behind what `depth` holds: a depth texture with one sample per pixel, as large as the target, drawn with the
    /// same view before this renderer's pass, the mesh included. `None`: behind the mesh alone. From the next view prepared on.
    pub fn set_scene_depth(&mut self, depth: Option<wgpu::TextureView>) {
        self.callers_depth = depth;
    }

    /// Draws the mesh's depth where the caller has none.
    fn draws_depth(&self) -> Option<(&FillRenderer, &SceneDepthTexture)> {
        let own = self.own_depth.as_ref().filter(|_| self.callers_depth.is_none())?;
        Some((self.depth.as_ref()?, own))
    }

    /// Binds the depth that hides lines. Strokes that nothing hides are bound to a texture of one pixel, which no stage reads.
    fn bind(&mut self, device: &wgpu::Device, size_px: [u32; 2]) -> Result<(), RendererError> {
        let depth = match &self.callers_depth {
            Some(depth) => depth.clone(),
            None => {
                let size_px = if self.depth.is_some() { size_px } else { [1; 2] };
                let formats = depth_formats(self.pipelines.formats);
                SceneDepthTexture::resized(&mut self.own_depth, device, size_px, formats)?
            }
        };
        if self.bound.as_ref().is_none_or(|(bound, _)| *bound != depth) {
            let resources = [self.uniform.binding(), wgpu::BindingResource::TextureView(&depth)];
            let group = bind_group(device, "strokes", &self.pipelines.layout, &resources);
            self.bound = Some((depth, group));
        }
        Ok(())
    }
}

impl FrameRenderer for StrokeRenderer {
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, view: &FrameView) -> Result<(), RendererError> {
        let StrokePipelines { formats, style, .. } = *self.pipelines;
        formats.check(view)?;
        let viewport = view.viewport();
        let span_px = style.pen.span_px();
        let (join, miter_limit) = match style.join {
            Join::Round => (0, 1.0),
            Join::Miter { limit } => (1, limit.max(1.0)),
            Join::Bevel => (2, 1.0),
        };
        let reach_px = span_px[1].max(-span_px[0]) * f64::from(miter_limit);
        self.strokes.build(&self.lines, Projector::new(view, reach_px), style.cap);
        let Strokes { segments, joins, .. } = &self.strokes;
        self.segments.upload(device, queue, "segments of strokes", segments)?;
        self.joins.upload(device, queue, "turns of strokes", joins)?;
        if let Some(interior) = &mut self.interior {
            interior.prepare(device, queue, view)?;
        }
        let own_view = view.with_viewport(Viewport::whole(viewport.size_px)).map_err(RendererError::View)?;
        if let Some(depth) = self.depth.as_mut().filter(|_| self.callers_depth.is_none()) {
            depth.prepare(device, queue, &own_view)?;
        }
        self.bind(device, viewport.size_px)?;
        let scale = DepthScale::new(view, depth_formats(formats).depth);
        let origin_px = viewport.origin_px.map(|side| side as f32);
        let uniform = LineUniform {
            origin_px,
            viewport_px: viewport.size_px.map(|side| side as f32),
            depth_origin_px: if self.callers_depth.is_some() { origin_px } else { [0.0; 2] },
            span_px: span_px.map(|distance| distance as f32),
            color: style.ink.for_target(&formats),
            depth_of_value: scale.depth_of_value.map(|term| term as f32),
            away_scale: scale.away_scale,
            away_step: scale.away_step,
            clear_depth: scale.clear_depth,
            relative_tolerance: scale.relative_tolerance as f32,
            absolute_tolerance: scale.absolute_tolerance as f32,
            most_tolerance: scale.most_tolerance as f32,
            join,
            miter_limit,
            hide: u32::from(style.hidden == Hidden::Removed),
            _pad: [0; 3],
        };
        self.uniform.write(queue, &uniform);
        self.viewport = Some(viewport);
        Ok(())
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder) {
        if let Some((renderer, texture)) = self.draws_depth() {
            let mut pass = texture.begin_pass(encoder, self.pipelines.formats.clear_depth());
            renderer.draw(&mut pass);
        }
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let (Some(viewport), Some((_, group))) = (self.viewport, &self.bound) else { return };
        if let Some(interior) = &self.interior {
            interior.draw(pass);
        }
        viewport.set(pass);
        let both = [(&self.pipelines.segments, &self.segments), (&self.pipelines.joins, &self.joins)];
        for (pipeline, instances) in both {
            if let Some((buffer, count)) = instances.filled() {
                pass.set_pipeline(pipeline);
                pass.set_bind_group(0, group, &[]);
                pass.set_vertex_buffer(0, buffer.slice(..));
                pass.draw(0..4, 0..count);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_shaders::layout;
    use std::mem::offset_of;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        macro_rules! members {
            ($($name:ident),*) => { [$((stringify!($name), offset_of!(LineUniform, $name))),*] };
        }
        let members = members!(
            origin_px,
            viewport_px,
            depth_origin_px,
            span_px,
            color,
            depth_of_value,
            away_scale,
            away_step,
            clear_depth,
            relative_tolerance,
            absolute_tolerance,
            most_tolerance,
            join,
            miter_limit,
            hide
        );
        for stage in [silhouette_shaders::gpu::LINE_SEGMENTS, silhouette_shaders::gpu::LINE_JOINS] {
            assert!(layout::matches(stage, "LineUniform", size_of::<LineUniform>(), &members));
        }
    }
}
