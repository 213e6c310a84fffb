//! Filled images of the methods of this crate: white, lit from the viewer's upper left.

use crate::smoothing::Smoothing;
use crate::view_mesh_renderer::{ViewMeshPipelines, ViewMeshRenderer, reach};
use silhouette_gpu::{Color, FillsImage, MeshBuffers, RendererError, Shade, TargetFormats};
use std::sync::Arc;

impl FillsImage for Smoothing {
    type Pipelines = ViewMeshPipelines;
    type Renderer = ViewMeshRenderer<Self>;

    fn pipelines(&self, device: &wgpu::Device, formats: TargetFormats) -> Result<ViewMeshPipelines, RendererError> {
        Ok(ViewMeshPipelines::new(device, formats, Shade::Lit(Color::WHITE)))
    }

    fn renderer(
        &self,
        device: &wgpu::Device,
        _queue: &wgpu::Queue,
        pipelines: &Arc<ViewMeshPipelines>,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<ViewMeshRenderer<Self>, RendererError> {
        let reach = reach(self.shading_mesh().mesh());
        Ok(ViewMeshRenderer::new(device, pipelines, mesh, self.clone(), reach))
    }
}
