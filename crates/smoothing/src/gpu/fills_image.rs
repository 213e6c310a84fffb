//! Filled images of [`Smoothing`]: white, lit from the viewer's upper left.

use crate::gpu::pipelines::SmoothingPipelines;
use crate::gpu::renderer::SmoothingRenderer;
use crate::options::Path;
use crate::smoothing::{DrawnSmoothing, Smoothing};
use crate::view_mesh::reach;
use crate::view_mesh_renderer::{ViewMeshPipelines, ViewMeshRenderer};
use silhouette_core::view::{Camera, ClipRange};
use silhouette_gpu::{Color, FillsImage, FrameRenderer, FrameView, MeshBuffers, RendererError, Shade, TargetFormats};
use std::sync::Arc;

/// The pipelines of either [`Path`].
#[derive(Debug)]
pub enum ImagePipelines {
    /// Triangles made on the GPU.
    Gpu(Arc<SmoothingPipelines>),
    /// Triangles made on the CPU.
    Cpu(Arc<ViewMeshPipelines>),
}

/// The renderer of either [`Path`].
pub enum ImageRenderer {
    /// Triangles made on the GPU.
    Gpu(Box<SmoothingRenderer>),
    /// Triangles made on the CPU.
    Cpu(Box<ViewMeshRenderer<DrawnSmoothing>>),
}

impl ImageRenderer {
    fn inner(&self) -> &dyn FrameRenderer {
        match self {
            Self::Gpu(renderer) => &**renderer,
            Self::Cpu(renderer) => &**renderer,
        }
    }

    fn inner_mut(&mut self) -> &mut dyn FrameRenderer {
        match self {
            Self::Gpu(renderer) => &mut **renderer,
            Self::Cpu(renderer) => &mut **renderer,
        }
    }
}

impl FrameRenderer for ImageRenderer {
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, view: &FrameView) -> Result<(), RendererError> {
        self.inner_mut().prepare(device, queue, view)
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder) {
        self.inner().encode(encoder);
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.inner().draw(pass);
    }

    fn warning(&self) -> Option<String> {
        self.inner().warning()
    }

    fn clip_range(&self, camera: &Camera, mesh: ClipRange) -> ClipRange {
        self.inner().clip_range(camera, mesh)
    }
}

impl FillsImage for Smoothing {
    type Pipelines = ImagePipelines;
    type Renderer = ImageRenderer;

    fn pipelines(&self, device: &wgpu::Device, formats: TargetFormats) -> Result<ImagePipelines, RendererError> {
        let shade = Shade::Lit(Color::WHITE);
        Ok(match self.options().path {
            Path::Gpu => ImagePipelines::Gpu(Arc::new(SmoothingPipelines::new(device, formats, shade))),
            Path::Cpu => ImagePipelines::Cpu(Arc::new(ViewMeshPipelines::new(device, formats, shade))),
        })
    }

    fn renderer(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        pipelines: &Arc<ImagePipelines>,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<ImageRenderer, RendererError> {
        Ok(match &**pipelines {
            ImagePipelines::Gpu(pipelines) => {
                ImageRenderer::Gpu(Box::new(SmoothingRenderer::new(device, queue, self, pipelines, mesh)?))
            }
            ImagePipelines::Cpu(pipelines) => {
                let reach = reach(self.shading_mesh().mesh()).max(self.features().reach());
                ImageRenderer::Cpu(Box::new(ViewMeshRenderer::new(device, pipelines, mesh, self.drawn(), reach)))
            }
        })
    }
}
