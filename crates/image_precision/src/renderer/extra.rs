//! [`ExtraLines`]: boundary edges and creases, drawn in addition.

use crate::back_edges::drawing_layout;
use crate::screen;
use crate::settings::Settings;
use crate::style::{self, StyleUniform};
use silhouette_core::glam::DVec3;
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Camera, ClipRange, DepthDirection};
use silhouette_gpu::kit::{buffers_group, storage_buffer};
use silhouette_gpu::{CameraBinding, CameraUniform, MeshBinding, MeshTooLarge, Rounding, TargetFormats};

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
        edges: &[[u32; 2]],
        settings: &Settings,
        formats: TargetFormats,
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
            half: (0.5 / style::reach(settings.variant)) as f32,
            binding: CameraBinding::new(device, &layout, size_of::<StyleUniform>()),
            list: buffers_group(device, "extra edges", &drawing_layout(device), &[&pairs]),
            pipeline: screen::pipeline(device, formats, settings, "line_of_pair"),
        }))
    }

    /// Uploads the style of a view, centred and lifted.
    #[allow(clippy::too_many_arguments, reason = "all that a view is")]
    pub fn prepare(
        &mut self,
        queue: &wgpu::Queue,
        camera: &Camera,
        bounds: &Bounds,
        camera_uniform: &CameraUniform,
        style: &StyleUniform,
        range: ClipRange,
        direction: DepthDirection,
    ) {
        let [half, half_falling] = style.line.shape.reach.map(|reach| self.half * reach);
        let depth = -camera.view_matrix().transform_point3(bounds.center).z;
        let depth = depth.max(range.near + 0.1 * (range.far - range.near));
        let width_px = 2.0 * f64::from(half + half_falling / depth as f32);
        let toward = width_px / camera.pixels_per_unit(depth);
        let value = |depth: f64| camera.clip_matrix(range, direction).project_point3(DVec3::Z * -depth).z;
        let lift = value(depth - toward.min(0.5 * depth.abs())) - value(depth);
        let mut style = *style;
        style.line.round(Rounding::new(0.5 * width_px, true));
        style.line.shape.reach = [half, half_falling];
        style.line.shape.lift = lift as f32;
        self.vertices = self.edges.saturating_mul(style.line.vertices_per_line());
        self.binding.write(queue, camera_uniform, &style);
    }

    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, mesh: &MeshBinding) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, self.binding.bind_group(), &[]);
        pass.set_bind_group(1, mesh.bind_group(), &[]);
        pass.set_bind_group(2, &self.list, &[]);
        pass.draw(0..self.vertices, 0..1);
    }
}
