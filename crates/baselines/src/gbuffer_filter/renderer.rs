//! [`GbufferFilterRenderer`]: the passes before the caller's, and the ink within it.

use super::discontinuities::{self, ThresholdsUniform};
use super::gbuffer::{self, Gbuffer, SurfaceFrame};
use super::method::GbufferFilter;
use super::{filter_ink, method::GbufferFilterOptions};
use crate::distance_field::{Extent, Field, FieldLayouts, FieldUniform, FloodStage, Rim, check_size, widest_px};
use silhouette_core::glam::DMat4;
use silhouette_gpu::kit::UniformBlock;
use silhouette_gpu::{
    CameraBinding, CameraUniform, Cull, DrawsLines, FillPipelines, FillRenderer, FrameRenderer, FrameView, MeshBuffers,
    PenPlacement, RendererError, TargetFormats, Viewport, WidthOverDepth,
};
use std::sync::Arc;

/// What all renderers with the same options, on the same device and formats, share.
#[derive(Debug)]
pub struct GbufferFilterPipelines {
    formats: TargetFormats,
    interior: Option<Arc<FillPipelines>>,
    layouts: FieldLayouts,
    gbuffer: wgpu::RenderPipeline,
    plant: wgpu::ComputePipeline,
    flood: wgpu::ComputePipeline,
    ink: wgpu::RenderPipeline,
}

impl DrawsLines for GbufferFilter {
    type Pipelines = GbufferFilterPipelines;
    type Renderer = GbufferFilterRenderer;

    fn pen_placement(&self) -> PenPlacement {
        PenPlacement::Centred
    }

    fn pipelines(
        &self,
        device: &wgpu::Device,
        formats: TargetFormats,
    ) -> Result<GbufferFilterPipelines, RendererError> {
        let layouts = FieldLayouts::new(device);
        Ok(GbufferFilterPipelines {
            formats,
            interior: self.options.line_style().interior(device, formats, Cull::None),
            gbuffer: gbuffer::pipeline(device, formats),
            plant: discontinuities::pipeline(device, &layouts, self.options.operator),
            flood: FloodStage::pipeline(device, &layouts),
            ink: filter_ink::pipeline(device, formats, &layouts, &self.options),
            layouts,
        })
    }

    fn renderer(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        pipelines: &Arc<GbufferFilterPipelines>,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<GbufferFilterRenderer, RendererError> {
        let layout = CameraBinding::layout(device);
        Ok(GbufferFilterRenderer {
            options: self.options,
            interior: pipelines.interior.as_ref().map(|interior| FillRenderer::new(device, interior, mesh)),
            flood: FloodStage::new(device, queue, &pipelines.flood),
            pipelines: Arc::clone(pipelines),
            mesh: Arc::clone(mesh),
            surface: CameraBinding::new(device, &layout, size_of::<SurfaceFrame>()),
            binding: CameraBinding::new(device, &layout, size_of::<FieldUniform>()),
            thresholds: UniformBlock::new(device, "thresholds"),
            textures: None,
            viewport: None,
        })
    }
}

/// Draws a mesh and the lines that a filter finds in its depth and normals.
#[derive(Debug)]
pub struct GbufferFilterRenderer {
    options: GbufferFilterOptions,
    pipelines: Arc<GbufferFilterPipelines>,
    mesh: Arc<MeshBuffers>,
    interior: Option<FillRenderer>,
    flood: FloodStage,
    /// The view into the field, for the G-buffer.
    surface: CameraBinding,
    /// The field, for all other stages.
    binding: CameraBinding,
    thresholds: UniformBlock<ThresholdsUniform>,
    textures: Option<Textures>,
    viewport: Option<Viewport>,
}

/// What is as large as the field.
#[derive(Debug)]
struct Textures {
    gbuffer: Gbuffer,
    field: Field,
}

impl GbufferFilterRenderer {
    /// Textures for a field of this extent: those that there are, where they are of its size.
    fn resize(&mut self, device: &wgpu::Device, extent: Extent) -> Result<(), RendererError> {
        match &mut self.textures {
            Some(textures) if textures.field.size_px() == extent.size_px() => textures.field.set_extent(extent),
            textures => {
                check_size(device, &extent)?;
                let field = Field::new(device, &self.pipelines.layouts, extent);
                let gbuffer = Gbuffer::new(device, extent.size_px(), &self.thresholds);
                *textures = Some(Textures { gbuffer, field });
            }
        }
        Ok(())
    }
}

impl FrameRenderer for GbufferFilterRenderer {
    /// Textures are made anew where the viewport or the width of lines needs others.
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, view: &FrameView) -> Result<(), RendererError> {
        let formats = self.pipelines.formats;
        formats.check(view)?;
        self.viewport = None;
        let Some(bounds) = self.mesh.bounds() else { return Ok(()) };
        let style = self.options.line_style();
        let width = WidthOverDepth::new(&style.width, view, &bounds);
        let (middle, radius) = (view.depth(bounds.center), view.radius(&bounds));
        let extent = Extent::new(view.viewport(), 0.5 * widest_px(view, &bounds, &width));
        self.resize(device, extent)?;
        let frame = *self.mesh.frame();
        let field_view = extent.view(view)?;
        self.surface.write(
            queue,
            &CameraUniform::new(frame.to_clip(&field_view)),
            &SurfaceFrame::new(&frame, &field_view),
        );
        let thresholds = ThresholdsUniform::new(&self.options, view, middle, radius, formats.clear_depth());
        self.thresholds.write(queue, &thresholds);
        let uniform = FieldUniform::new(view, radius, &extent, &width, 0.5, &formats);
        let uniform = uniform.with_ink(style.ink.for_target(&formats), Rim::Samples);
        self.binding.write(queue, &CameraUniform::new(DMat4::IDENTITY), &uniform);
        if let Some(interior) = &mut self.interior {
            interior.prepare(device, queue, view)?;
        }
        self.viewport = Some(view.viewport());
        Ok(())
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder) {
        let (Some(Textures { gbuffer, field }), Some(_)) = (&self.textures, self.viewport) else { return };
        let GbufferFilterPipelines { formats, gbuffer: draw_gbuffer, plant, .. } = &*self.pipelines;
        let mut pass = gbuffer.picture.begin_pass(encoder, formats.clear_depth());
        pass.set_pipeline(draw_gbuffer);
        pass.set_bind_group(0, self.surface.bind_group(), &[]);
        self.mesh.draw(&mut pass);
        drop(pass);
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_bind_group(0, self.binding.bind_group(), &[]);
        pass.set_bind_group(1, &gbuffer.read, &[]);
        pass.set_bind_group(2, field.planted(), &[]);
        pass.set_pipeline(plant);
        field.dispatch(&mut pass);
        field.flood(&mut pass, &self.flood);
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let (Some(Textures { field, .. }), Some(viewport)) = (&self.textures, self.viewport) else { return };
        if let Some(interior) = &self.interior {
            interior.draw(pass);
        }
        viewport.set(pass);
        pass.set_pipeline(&self.pipelines.ink);
        pass.set_bind_group(0, self.binding.bind_group(), &[]);
        pass.set_bind_group(1, field.known(), &[]);
        pass.draw(0..3, 0..1);
    }
}
