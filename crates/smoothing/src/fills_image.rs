//! Filled images of the methods of this crate: white, lit from the viewer's upper left.

use crate::adaptive_refinement::{AdaptiveRefinement, AdaptiveRemesher};
use crate::boundary_curve::{BoundaryCurve, BoundaryRemesher};
use crate::phong_tessellation::{PhongPatch, PhongTessellation};
use crate::pn_triangles::{PnPatch, PnTriangles};
use crate::smoothing::Smoothing;
use crate::tessellation::Tessellation;
use crate::view_mesh_renderer::{ViewMeshPipelines, ViewMeshRenderer, reach};
use silhouette_gpu::{Color, FillsImage, MeshBuffers, RendererError, Shade, TargetFormats};
use std::sync::Arc;

/// Implements [`FillsImage`] for a method by the function that makes its remesher.
macro_rules! fills_image {
    ($($method:ty: $remesher:ty = $make:expr;)+) => {$(
        impl FillsImage for $method {
            type Pipelines = ViewMeshPipelines;
            type Renderer = ViewMeshRenderer<$remesher>;

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
                Ok(ViewMeshRenderer::new(device, pipelines, mesh, $make(self), reach))
            }
        }
    )+};
}

fills_image! {
    Smoothing: Self = Clone::clone;
    PnTriangles: Tessellation<PnPatch> = Self::remesher;
    PhongTessellation: Tessellation<PhongPatch> = Self::remesher;
    BoundaryCurve: BoundaryRemesher = Self::remesher;
    AdaptiveRefinement: AdaptiveRemesher = Self::remesher;
}
