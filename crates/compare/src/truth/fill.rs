//! [`FillTruth`]: the truth of filled pictures, the fine mesh drawn at 16 samples per pixel.

use crate::metrics::filled_picture::FilledPicture;
use silhouette_core::TriangleMesh;
use silhouette_core::view::Camera;
use silhouette_gpu::{Color, Cull, FillStyle, MeshBuffers, MeshTooLarge, Polylines, Shade, StrokeStyle};
use silhouette_render::{DEFAULT_SUPERSAMPLING, Gpu, GpuError, ReferencePicture, ReferenceRenderer};
use std::sync::Arc;

/// How the mesh is lit in truth: white, from the viewer's upper left, alike from both sides.
pub const LIT: FillStyle = FillStyle { shade: Shade::Lit(Color::WHITE), cull: Cull::None };

/// Why there is no truth of a filled picture.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FillTruthError {
    /// The device's buffers cannot hold the mesh.
    #[error(transparent)]
    MeshTooLarge(#[from] MeshTooLarge),
    /// The device failed.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

/// Draws the truth of any view of a mesh.
pub struct FillTruth {
    buffers: Arc<MeshBuffers>,
    renderer: ReferenceRenderer,
    lines: Polylines,
}

impl FillTruth {
    /// Uploads the mesh that is the truth.
    ///
    /// # Errors
    /// [`FillTruthError`].
    pub fn new(gpu: &Gpu, mesh: &TriangleMesh) -> Result<Self, FillTruthError> {
        Ok(Self {
            buffers: Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh)?),
            renderer: ReferenceRenderer::new(gpu)?,
            lines: Polylines::new(),
        })
    }

    /// The mesh as it appears, [`LIT`], at 4 x 4 samples per pixel: coverage to 1/16, averaged over bytes as stored. Draws the
    /// mesh once per tile of 512 x 512 pixels.
    ///
    /// # Errors
    /// [`FillTruthError::Gpu`].
    pub fn find(&mut self, gpu: &Gpu, camera: &Camera) -> Result<FilledPicture, FillTruthError> {
        let picture = ReferencePicture {
            mesh: &self.buffers,
            fill: LIT,
            lines: &self.lines,
            style: StrokeStyle::default(),
            camera: *camera,
            ground: Color::TRANSPARENT,
        };
        Ok(FilledPicture::new(self.renderer.image(gpu, &picture, DEFAULT_SUPERSAMPLING)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::{DVec3, Vec3};
    use silhouette_core::shapes;
    use silhouette_core::view::Framing;
    use silhouette_testing::gpu_or_skip;
    use std::f64::consts::PI;

    /// A ball seen in parallel projection is a disc.
    #[test]
    fn alpha_is_the_covered_share_of_a_pixel() {
        let Some(gpu) = gpu_or_skip("alpha_is_the_covered_share_of_a_pixel") else { return };
        let mesh = shapes::by_name("icosphere:5").unwrap();
        let bounds = mesh.bounds().unwrap();
        let direction = DVec3::new(0.3, 0.4, 1.0);
        let camera = Camera::framing(&bounds, direction, Vec3::Y, Framing::Orthographic, [128; 2]).unwrap();
        let picture = FillTruth::new(gpu, &mesh).unwrap().find(gpu, &camera).unwrap();
        let area: f64 = picture.coverage().coverages().iter().map(|&coverage| f64::from(coverage)).sum();
        let radius_px = bounds.radius * camera.pixels_per_unit(1.0);
        assert!((area / (PI * radius_px * radius_px) - 1.0).abs() < 5e-3, "{area} px², radius {radius_px} px");
        let partly = picture.coverage().coverages().iter().filter(|coverage| (0.01..0.99).contains(*coverage)).count();
        assert!(partly > 100, "{partly} pixels at the boundary are covered in part");
        assert_eq!(picture.over_paper()[..3], [255; 3], "the ground is transparent");
    }
}
