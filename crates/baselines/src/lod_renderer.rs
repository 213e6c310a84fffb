//! [`LodRenderer`]: chooses a level for each view, and draws it.

use crate::distance_field::nearest_depth;
use crate::lod_chain::LodLevel;
use crate::lod_mesh::{LodMesh, level_at};
use silhouette_core::mesh::Bounds;
use silhouette_gpu::{
    FillPipelines, FillRenderer, FillsImage, FrameRenderer, FrameView, MeshBuffers, RendererError, TargetFormats,
};
use std::sync::Arc;

/// Draws one level of a [`LodMesh`], chosen for each view. Holds all levels on the device.
#[derive(Debug)]
pub struct LodRenderer {
    levels: Arc<[LodLevel]>,
    renderers: Vec<FillRenderer>,
    bounds: Option<Bounds>,
    max_error_px: f64,
    chosen: usize,
}

impl LodRenderer {
    /// The index of the level that the view last prepared draws, 0 the finest.
    pub fn level(&self) -> usize {
        self.chosen
    }
}

impl FillsImage for LodMesh {
    type Pipelines = FillPipelines;
    type Renderer = LodRenderer;

    fn pipelines(&self, device: &wgpu::Device, formats: TargetFormats) -> Result<FillPipelines, RendererError> {
        Ok(FillPipelines::new(device, formats, self.options.shading.style(self.options.grey)))
    }

    /// Uploads all levels; the mesh itself, where it is one, comes from `mesh`.
    fn renderer(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        pipelines: &Arc<FillPipelines>,
        mesh: &Arc<MeshBuffers>,
    ) -> Result<LodRenderer, RendererError> {
        let renderer = |level: &LodLevel| -> Result<FillRenderer, RendererError> {
            let is_full = level.error == 0.0 && level.mesh.face_count() == mesh.face_count() as usize;
            let buffers =
                if is_full { Arc::clone(mesh) } else { Arc::new(MeshBuffers::new(device, queue, &level.mesh)?) };
            Ok(FillRenderer::new(device, pipelines, &buffers))
        };
        Ok(LodRenderer {
            renderers: self.levels.iter().map(renderer).collect::<Result<_, _>>()?,
            levels: Arc::clone(&self.levels),
            bounds: mesh.bounds(),
            max_error_px: self.options.max_error,
            chosen: 0,
        })
    }
}

impl FrameRenderer for LodRenderer {
    fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, view: &FrameView) -> Result<(), RendererError> {
        let px_per_unit = self.bounds.map_or(0.0, |bounds| largest_px_per_unit(view, &bounds));
        self.chosen = level_at(&self.levels, px_per_unit, self.max_error_px);
        self.renderers[self.chosen].prepare(device, queue, view)
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.renderers[self.chosen].draw(pass);
    }
}

/// The most pixels that a unit of the mesh's own space covers across the view, anywhere in a box in front of the near plane:
/// at the depth of its nearest corner.
fn largest_px_per_unit(view: &FrameView, bounds: &Bounds) -> f64 {
    view.pixels_per_unit(nearest_depth(view, bounds)) * view.largest_scale()
}

#[cfg(test)]
mod tests;
