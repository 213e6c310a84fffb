//! [`FillRenderer`]: the triangles of a mesh. Stage: `shaders/gpu/fill.wgsl`.

use crate::camera::{CameraBinding, CameraUniform};
use crate::color::Color;
use crate::formats::TargetFormats;
use crate::frame_renderer::FrameRenderer;
use crate::frame_view::{FrameView, Viewport};
use crate::kit::{RenderStage, WoundPipeline};
use crate::mesh_buffers::{MeshBuffers, POSITION_LAYOUT};
use crate::renderer_error::RendererError;
use crate::surface::SurfaceUniform;
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
            binding: CameraBinding::new(device, &CameraBinding::layout(device), size_of::<SurfaceUniform>()),
            prepared: None,
        }
    }
}

impl FrameRenderer for FillRenderer {
    fn prepare(&mut self, _device: &wgpu::Device, queue: &wgpu::Queue, view: &FrameView) -> Result<(), RendererError> {
        let FillPipelines { pipeline, formats, style } = &*self.pipelines;
        formats.check(view)?;
        let frame = self.mesh.frame();
        let color = match style.shade {
            Shade::Flat(color) | Shade::Lit(color) => color,
            Shade::DepthOnly => Color::TRANSPARENT,
        };
        let uniform = SurfaceUniform::new(frame, view, color, formats.is_linear());
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
