//! [`LinePass`]: buffers and pipelines of the strokes.

use super::line_joins::JoinInstance;
use super::line_segments::{Projector, SegmentInstance, Strokes};
use super::line_visibility::DepthScale;
use super::{Hidden, Join, LineStyle, Polylines};
use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::pass_view::PassView;
use crate::target::Target;
use bytemuck::{Pod, Zeroable};
use silhouette_gpu::kit::{RenderStage, UniformBlock, bind_group, bind_layout, texture_entry, uniform_entry};

/// Twin of the struct in `shaders/render/line_visibility.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
struct LineUniform {
    target_px: [f32; 2],
    span_px: [f32; 2],
    color: [f32; 4],
    depth_of_value: [f32; 4],
    away_step: f32,
    clear_depth: f32,
    relative_tolerance: f32,
    absolute_tolerance: f32,
    join: u32,
    miter_limit: f32,
    hide: u32,
    _pad: u32,
}

/// Draws polylines over a finished picture, hidden where its depth says so. One draw for each submit.
///
/// Upload: 28 bytes a segment and 36 a turn, every frame. Buffers grow to the largest frame and are kept.
#[derive(Debug)]
pub struct LinePass {
    layout: wgpu::BindGroupLayout,
    segment_pipeline: wgpu::RenderPipeline,
    join_pipeline: wgpu::RenderPipeline,
    uniform: UniformBlock<LineUniform>,
    bound: Option<(wgpu::TextureView, wgpu::BindGroup)>,
    segments: InstanceBuffer,
    joins: InstanceBuffer,
    strokes: Strokes,
}

impl LinePass {
    /// Builds the pipelines for passes over one colour attachment of this format and sample count, without depth.
    ///
    /// # Errors
    /// What the device reports.
    pub fn new(gpu: &Gpu, color: wgpu::TextureFormat, samples: u32) -> Result<Self, GpuError> {
        let device = gpu.device();
        gpu.scoped(|| {
            let depth = texture_entry(1, wgpu::TextureSampleType::Depth, false);
            let layout = bind_layout(device, "lines", &[uniform_entry(0), depth]);
            let bindings = &[Some(&layout)];
            let stage = |label, wgsl, vertex, fragment, buffer| {
                let topology = wgpu::PrimitiveTopology::TriangleStrip;
                let vertex_buffers = &[Some(buffer)];
                let simplest = RenderStage::default();
                RenderStage {
                    label,
                    wgsl,
                    vertex,
                    fragment,
                    bindings,
                    vertex_buffers,
                    topology,
                    color,
                    samples,
                    ..simplest
                }
                .build(device)
            };
            let segments = silhouette_shaders::render::LINE_SEGMENTS;
            let joins = silhouette_shaders::render::LINE_JOINS;
            let segment_pipeline =
                stage("line segments", segments, "segment_vertex", "segment_fragment", SegmentInstance::LAYOUT);
            let join_pipeline = stage("line joins", joins, "join_vertex", "join_fragment", JoinInstance::LAYOUT);
            Self {
                segment_pipeline,
                join_pipeline,
                uniform: UniformBlock::new(device, "lines"),
                layout,
                bound: None,
                segments: InstanceBuffer::default(),
                joins: InstanceBuffer::default(),
                strokes: Strokes::default(),
            }
        })
    }

    /// Projects and uploads `lines` for the next submit. `scene_depth` holds the depth of everything that hides them,
    /// drawn with the same `view` and without culling; its size is the view's target size.
    ///
    /// # Errors
    /// [`GpuError::MultisampledDepth`]; [`GpuError::OverBudget`] where no buffer can hold the strokes; what the device
    /// reports.
    pub fn prepare(
        &mut self,
        gpu: &Gpu,
        view: &PassView,
        lines: &Polylines,
        style: &LineStyle,
        scene_depth: &Target,
    ) -> Result<(), GpuError> {
        let depth = scene_depth.single_sample_depth()?;
        let scale = f64::from(view.tile.scale);
        let span_px = style.pen.span_px().map(|distance| distance * scale);
        let (join, miter_limit) = match style.join {
            Join::Round => (0, 1.0),
            Join::Miter { limit } => (1, limit.max(1.0)),
            Join::Bevel => (2, 1.0),
        };
        let reach_px = span_px[1].max(-span_px[0]) * f64::from(miter_limit);
        let projector = Projector::new(view.world_to_clip(), view.target_px(), view.direction, reach_px);
        self.strokes.build(lines, projector, style.cap);

        self.segments.upload(gpu, bytemuck::cast_slice(&self.strokes.segments), self.strokes.segments.len())?;
        self.joins.upload(gpu, bytemuck::cast_slice(&self.strokes.joins), self.strokes.joins.len())?;
        let depth_scale = DepthScale::new(view, scene_depth.formats().depth);
        let uniform = LineUniform {
            target_px: view.target_px().map(|side| side as f32),
            span_px: span_px.map(|distance| distance as f32),
            color: style.color,
            depth_of_value: depth_scale.depth_of_value.map(|term| term as f32),
            away_step: depth_scale.away_step,
            clear_depth: depth_scale.clear_depth,
            relative_tolerance: depth_scale.relative_tolerance as f32,
            absolute_tolerance: depth_scale.absolute_tolerance as f32,
            join,
            miter_limit,
            hide: u32::from(style.hidden == Hidden::Removed),
            _pad: 0,
        };
        self.uniform.write(gpu.queue(), &uniform);
        if self.bound.as_ref().is_none_or(|(view, _)| view != depth) {
            let bind_group = gpu.scoped(|| self.bind(gpu.device(), depth))?;
            self.bound = Some((depth.clone(), bind_group));
        }
        gpu.check()
    }

    fn bind(&self, device: &wgpu::Device, depth: &wgpu::TextureView) -> wgpu::BindGroup {
        let depth = wgpu::BindingResource::TextureView(depth);
        bind_group(device, "lines", &self.layout, &[self.uniform.binding(), depth])
    }

    /// Records the strokes last prepared.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let Some((_, bind_group)) = &self.bound else { return };
        for (pipeline, instances) in [(&self.segment_pipeline, &self.segments), (&self.join_pipeline, &self.joins)] {
            if let Some((buffer, count)) = instances.filled() {
                pass.set_pipeline(pipeline);
                pass.set_bind_group(0, bind_group, &[]);
                pass.set_vertex_buffer(0, buffer.slice(..));
                pass.draw(0..4, 0..count);
            }
        }
    }
}

/// A vertex buffer that grows to the largest frame.
#[derive(Debug, Default)]
struct InstanceBuffer {
    buffer: Option<wgpu::Buffer>,
    count: u32,
}

impl InstanceBuffer {
    fn upload(&mut self, gpu: &Gpu, bytes: &[u8], count: usize) -> Result<(), GpuError> {
        self.count = 0;
        if bytes.is_empty() {
            return Ok(());
        }
        let needed = bytes.len() as u64;
        let budget = gpu.device().limits().max_buffer_size;
        let (true, Ok(count)) = (needed <= budget, u32::try_from(count)) else {
            return Err(GpuError::OverBudget { bytes: needed, budget });
        };
        if self.buffer.as_ref().is_none_or(|buffer| buffer.size() < needed) {
            let size = needed.next_power_of_two().min(budget / 4 * 4);
            self.buffer = Some(gpu.scoped(|| {
                gpu.device().create_buffer(&wgpu::BufferDescriptor {
                    label: Some("strokes"),
                    size,
                    usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
                    mapped_at_creation: false,
                })
            })?);
        }
        if let Some(buffer) = &self.buffer {
            gpu.queue().write_buffer(buffer, 0, bytes);
            self.count = count;
        }
        Ok(())
    }

    fn filled(&self) -> Option<(&wgpu::Buffer, u32)> {
        self.buffer.as_ref().filter(|_| self.count > 0).map(|buffer| (buffer, self.count))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_shaders::layout;
    use std::mem::offset_of;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        let members = [
            ("target_px", offset_of!(LineUniform, target_px)),
            ("span_px", offset_of!(LineUniform, span_px)),
            ("color", offset_of!(LineUniform, color)),
            ("depth_of_value", offset_of!(LineUniform, depth_of_value)),
            ("away_step", offset_of!(LineUniform, away_step)),
            ("clear_depth", offset_of!(LineUniform, clear_depth)),
            ("relative_tolerance", offset_of!(LineUniform, relative_tolerance)),
            ("absolute_tolerance", offset_of!(LineUniform, absolute_tolerance)),
            ("join", offset_of!(LineUniform, join)),
            ("miter_limit", offset_of!(LineUniform, miter_limit)),
            ("hide", offset_of!(LineUniform, hide)),
            ("_pad", offset_of!(LineUniform, _pad)),
        ];
        for stage in [silhouette_shaders::render::LINE_SEGMENTS, silhouette_shaders::render::LINE_JOINS] {
            assert!(layout::matches(stage, "LineUniform", size_of::<LineUniform>(), &members));
        }
    }
}
