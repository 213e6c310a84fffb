//! Filled images of the methods that make triangles on the CPU: white, lit from the viewer's upper left.

use crate::view_mesh::reach;
use crate::view_mesh_renderer::{ViewMeshPipelines, ViewMeshRenderer};
use crate::{AdaptiveRefinement, BoundaryCurve, MakesTriangles, PhongTessellation, PnTriangles};
use silhouette_gpu::{Color, FillsImage, MeshBuffers, RendererError, Shade, TargetFormats};
use std::sync::Arc;

/// Implements [`FillsImage`] for methods that make triangles.
macro_rules! fills_image {
    ($($method:ty),+) => {$(
        impl FillsImage for $method {
            type Pipelines = ViewMeshPipelines;
            type Renderer = ViewMeshRenderer<<Self as MakesTriangles>::Remesher>;

            fn pipelines(
                &self,
                device: &wgpu::Device,
                formats: TargetFormats,
            ) -> Result<ViewMeshPipelines, RendererError> {
                Ok(ViewMeshPipelines::new(device, formats, Shade::Lit(Color::WHITE)))
            }

            fn renderer(
                &self,
                device: &wgpu::Device,
                _queue: &wgpu::Queue,
                pipelines: &Arc<ViewMeshPipelines>,
                mesh: &Arc<MeshBuffers>,
            ) -> Result<Self::Renderer, RendererError> {
                let reach = reach(self.shading_mesh().mesh());
                Ok(ViewMeshRenderer::new(device, pipelines, mesh, self.remesher(), reach))
            }
        }
    )+};
}

fills_image!(PnTriangles, PhongTessellation, BoundaryCurve, AdaptiveRefinement);
