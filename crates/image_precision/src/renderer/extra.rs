//! [`ExtraLines`]: boundary edges and creases, drawn in addition.

use crate::back_edges::drawing_layout;
use crate::settings::Variant;
use crate::style::{self, StyleUniform};
use silhouette_core::mesh::Bounds;
use silhouette_gpu::kit::{buffers_group, storage_buffer};
use silhouette_gpu::{CameraBinding, CameraUniform, FrameView, MeshBinding, MeshTooLarge, Rounding, WidthOverDepth};

/// Lines given by pairs of vertices, centred on their edges and brought as far in front of the faces that they lie on as
/// they are wide.
#[derive(Debug)]
pub(super) struct ExtraLines {
    edges: u32,
    /// Vertices of the view last prepared.
    vertices: u32,
    /// Half of a line's width over what lines of the variant reach beside their edges.
    half: f32,
    binding: CameraBinding,
    list: wgpu::BindGroup,
    pipeline: wgpu::RenderPipeline,
}

impl ExtraLines {
    /// `None` where there is no edge.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        pipeline: &wgpu::RenderPipeline,
        edges: &[[u32; 2]],
        variant: Variant,
    ) -> Result<Option<Self>, MeshTooLarge> {
        if edges.is_empty() {
            return Ok(None);
        }
        let bytes = size_of_val(edges) as u64;
        let pairs = storage_buffer(device, "extra edges", bytes, wgpu::BufferUsages::empty())?;
        queue.write_buffer(&pairs, 0, bytemuck::cast_slice(edges));
        let layout = CameraBinding::layout(device);
        Ok(Some(Self {
            // A mesh has fewer than 2^32 half-edges, by validation.
            edges: edges.len() as u32,
            vertices: 0,
            half: (0.5 / style::reach(variant)) as f32,
            binding: CameraBinding::new(device, &layout, size_of::<StyleUniform>()),
            list: buffers_group(device, "extra edges", &drawing_layout(device), &[&pairs]),
            pipeline: pipeline.clone(),
        }))
    }

    /// Uploads the style of a view, centred and lifted.
    pub fn prepare(
        &mut self,
        queue: &wgpu::Queue,
        view: &FrameView,
        bounds: &Bounds,
        depth_per_w: f64,
        camera: &CameraUniform,
        style: &StyleUniform,
    ) {
        let [half, half_falling] = style.line.shape.reach.map(|reach| self.half * reach);
        let width = WidthOverDepth {
            constant_px: 2.0 * f64::from(half),
            px_at_depth_1: 2.0 * f64::from(half_falling) * depth_per_w,
        };
        let (width_px, lift) = width.lift(view, bounds);
        let mut style = *style;
        style.line.round(Rounding::new(0.5 * width_px, true));
        style.line.shape.reach = [half, half_falling];
        style.line.shape.lift = lift;
        self.vertices = self.edges.saturating_mul(style.line.vertices_per_line());
        self.binding.write(queue, camera, &style);
    }

    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, mesh: &MeshBinding) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, self.binding.bind_group(), &[]);
        pass.set_bind_group(1, mesh.bind_group(), &[]);
        pass.set_bind_group(2, &self.list, &[]);
        pass.draw(0..self.vertices, 0..1);
    }
}
