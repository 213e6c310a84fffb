//! [`FillRenderer`]: the triangles of a mesh. Stage: `shaders/gpu/fill.wgsl`.

use crate::camera::{CameraBinding, CameraUniform};
use crate::color::Color;
use crate::formats::TargetFormats;
use crate::frame_renderer::FrameRenderer;
use crate::frame_view::{FrameView, Viewport};
use crate::kit::{RenderStage, WoundPipeline};
use crate::mesh_buffers::{MeshBuffers, POSITION_LAYOUT};
use crate::renderer_error::RendererError;
use bytemuck::{Pod, Zeroable};
use glam::{DMat3, DVec3};
use std::sync::Arc;

/// How faces are coloured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shade {
    /// One colour.
    Flat(Color),
    /// One colour, lit from the viewer's upper left by Lambert's law with each face's own normal, alike from both sides.
    Lit(Color),
    /// No colour is written, depth alone.
    DepthOnly,
}

/// Which faces are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Cull {
    /// All of them: what hidden lines need on any mesh.
    #[default]
    None,
    /// Front faces only, those whose vertices run counter-clockwise seen from outside: half the work on a closed mesh, and the
    /// same picture.
    Back,
}

/// How a mesh is filled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FillStyle {
    /// Colour.
    pub shade: Shade,
    /// Faces drawn.
    pub cull: Cull,
}

impl FillStyle {
    /// White on both sides, as paper for lines.
    pub const PAPER: Self = Self { shade: Shade::Flat(Color::WHITE), cull: Cull::None };
    /// Depth of both sides, and no colour.
    pub const DEPTH: Self = Self { shade: Shade::DepthOnly, cull: Cull::None };
}

/// Share of the light that falls on faces turned away from it.
const AMBIENT: f32 = 0.25;

/// Towards the light from the viewer: to the left, upwards and backwards, over the viewer's left shoulder.
const LIGHT: [f64; 3] = [-0.4, 0.6, 1.0];

/// Twin of the struct in `shaders/gpu/fill.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
struct FillUniform {
    color: [f32; 4],
    light: [f32; 4],
    shape: [[f32; 4]; 3],
    is_linear: u32,
    _pad: [u32; 3],
}

/// The pipeline of a style, for all meshes.
#[derive(Debug)]
pub struct FillPipelines {
    pipeline: WoundPipeline,
    formats: TargetFormats,
    style: FillStyle,
}

impl FillPipelines {
    /// Builds the pipeline. Some milliseconds.
    pub fn new(device: &wgpu::Device, formats: TargetFormats, style: FillStyle) -> Self {
        let is_lit = matches!(style.shade, Shade::Lit(_));
        let is_opaque = match style.shade {
            Shade::Flat(color) | Shade::Lit(color) => color.alpha >= 1.0,
            Shade::DepthOnly => true,
        };
        let pipeline = WoundPipeline::new(device, move |device, front_face| {
            RenderStage {
                label: "fill",
                wgsl: silhouette_shaders::gpu::FILL,
                vertex: if is_lit { "fill_vertex" } else { "flat_vertex" },
                fragment: if is_lit { "fill_lit" } else { "fill_flat" },
                bindings: &[Some(&CameraBinding::layout(device))],
                vertex_buffers: &[Some(POSITION_LAYOUT)],
                front_face,
                cull_mode: (style.cull == Cull::Back).then_some(wgpu::Face::Back),
                depth: Some(formats.depth_state(formats.nearer())),
                color: formats.color,
                blend: (!is_opaque).then_some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
                writes: if style.shade == Shade::DepthOnly {
                    wgpu::ColorWrites::empty()
                } else {
                    wgpu::ColorWrites::ALL
                },
                samples: formats.samples,
                ..RenderStage::default()
            }
            .build(device)
        });
        Self { pipeline, formats, style }
    }
}

/// Draws the triangles of a mesh, nearest in front.
#[derive(Debug)]
pub struct FillRenderer {
    pipelines: Arc<FillPipelines>,
    mesh: Arc<MeshBuffers>,
    binding: CameraBinding,
    /// Pipeline and viewport of the view last prepared.
    prepared: Option<(wgpu::RenderPipeline, Viewport)>,
}

impl FillRenderer {
    /// A renderer of one instance of a mesh.
    pub fn new(device: &wgpu::Device, pipelines: &Arc<FillPipelines>, mesh: &Arc<MeshBuffers>) -> Self {
        Self {
            pipelines: Arc::clone(pipelines),
            mesh: Arc::clone(mesh),
            binding: CameraBinding::new(device, &CameraBinding::layout(device), size_of::<FillUniform>()),
            prepared: None,
        }
    }
}

impl FrameRenderer for FillRenderer {
    fn prepare(&mut self, _device: &wgpu::Device, queue: &wgpu::Queue, view: &FrameView) -> Result<(), RendererError> {
        let FillPipelines { pipeline, formats, style } = &*self.pipelines;
        formats.check(view)?;
        let frame = self.mesh.frame();
        // The light stands still for the viewer. From view space to the axes of the world, in which the shape lies.
        let [left, up, back] = LIGHT;
        let light = DVec3::new(left, up, view.depth_law().view_z_of_depth(-back));
        let world_to_view = DMat3::from_mat4(view.object_to_view() * view.model().inverse());
        let light = (world_to_view.inverse() * light).normalize_or_zero().as_vec3();
        let color = match style.shade {
            Shade::Flat(color) | Shade::Lit(color) => color,
            Shade::DepthOnly => Color::TRANSPARENT,
        };
        let [red, green, blue] = color.srgb.map(|part| part as f32);
        let uniform = FillUniform {
            color: [red, green, blue, color.alpha as f32],
            light: light.extend(AMBIENT).to_array(),
            shape: columns(frame.shape(view)),
            is_linear: u32::from(formats.is_linear()),
            _pad: [0; 3],
        };
        self.binding.write(queue, &CameraUniform::new(frame.to_clip(view)), &uniform);
        self.prepared = Some((pipeline.get(view.is_mirrored()).clone(), view.viewport()));
        Ok(())
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let Some((pipeline, viewport)) = &self.prepared else { return };
        viewport.set(pass);
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, self.binding.bind_group(), &[]);
        self.mesh.draw(pass);
    }
}

/// The columns of a matrix as a uniform holds them, each padded to four numbers.
pub(crate) fn columns(matrix: DMat3) -> [[f32; 4]; 3] {
    matrix.as_mat3().to_cols_array_2d().map(|[x, y, z]| [x, y, z, 0.0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_shaders::layout;
    use std::mem::offset_of;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        let members = [
            ("color", offset_of!(FillUniform, color)),
            ("light", offset_of!(FillUniform, light)),
            ("shape", offset_of!(FillUniform, shape)),
            ("is_linear", offset_of!(FillUniform, is_linear)),
        ];
        assert!(layout::matches(silhouette_shaders::gpu::FILL, "FillUniform", size_of::<FillUniform>(), &members));
    }
}
