//! [`FineMesh`]: the mesh itself, drawn as it is.

use crate::shading::Shading;
use silhouette_core::method::{Method, MethodGuide, MethodInfo, MethodOptions, PrepareError, Source};
use silhouette_core::prepared::PreparedMesh;
use silhouette_core::progress::Progress;
use std::sync::Arc;

silhouette_core::method_options! {
    /// Options of [`FineMesh`].
    pub struct FineMeshOptions {
        /// How faces look: lit from the viewer's upper left, or in one grey.
        pub shading: Shading = choice("shading"),
        /// Brightness of the surface, sRGB as displayed: 0 is black, 1 white.
        pub grey: f64 = number("grey", 0.0..=1.0, default 1.0),
    }
}

/// The mesh itself, rasterised with its own triangles: what a method that fills the image of a coarse mesh is measured against.
/// Prepares nothing; O(F) per view on the device.
#[derive(Debug, Clone)]
pub struct FineMesh {
    #[cfg_attr(not(feature = "gpu"), allow(dead_code, reason = "what options are for is on the device"))]
    options: FineMeshOptions,
}

impl Method for FineMesh {
    type Options = FineMeshOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "fine-mesh",
        summary: "Draws the mesh itself, lit or flat; its silhouette is as smooth as its triangles are small.",
        source: Source {
            authors: "Edwin Catmull",
            title: "A subdivision algorithm for computer display of curved surfaces (the depth buffer)",
            venue: "PhD thesis, University of Utah",
            year: 1974,
        },
        exact: false,
        needs: &[],
        options: FineMeshOptions::SPECS,
        guide: MethodGuide {
            origin: "the mesh itself, rasterised",
            yields: "a filled image",
            accuracy: "no: as smooth as its triangles are small",
            cost: "O(F) on the adapter",
            memory: "12 bytes per vertex and per face on the adapter",
            choose_when: "you need the baseline that filled images are compared with",
            limits: "a coarse mesh shows its corners",
        },
        published: &[],
    };

    fn prepare(
        _mesh: &Arc<PreparedMesh>,
        options: &FineMeshOptions,
        _progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        Ok(Self { options: *options })
    }

    fn bytes(&self) -> usize {
        0
    }
}

#[cfg(feature = "gpu")]
mod gpu {
    use super::FineMesh;
    use silhouette_gpu::{FillPipelines, FillRenderer, FillsImage, MeshBuffers, RendererError, TargetFormats};
    use std::sync::Arc;

    impl FillsImage for FineMesh {
        type Pipelines = FillPipelines;
        type Renderer = FillRenderer;

        fn pipelines(&self, device: &wgpu::Device, formats: TargetFormats) -> Result<FillPipelines, RendererError> {
            Ok(FillPipelines::new(device, formats, self.options.shading.style(self.options.grey)))
        }

        fn renderer(
            &self,
            device: &wgpu::Device,
            _queue: &wgpu::Queue,
            pipelines: &Arc<FillPipelines>,
            mesh: &Arc<MeshBuffers>,
        ) -> Result<FillRenderer, RendererError> {
            Ok(FillRenderer::new(device, pipelines, mesh))
        }
    }
}
