//! Pictures of a baked subject, and what they score against the fine mesh.

use crate::directions::spread;
use crate::drawings::{self, FOV_Y_RAD};
use crate::error::Cause;
use silhouette_compare::drawing::{Drawing, FrameStyle, Ground};
use silhouette_compare::metrics::{FilledPicture, measure_fill};
use silhouette_compare::truth::fill::FillTruth;
use silhouette_core::glam::DVec3;
use silhouette_core::view::Camera;
use silhouette_core::{Progress, TriangleMesh};
use silhouette_render::Gpu;

/// A picture of a method is as wide as it is high.
pub const SIDE_PX: u32 = 512;

/// The camera in a direction from the middle of a mesh, whose bounding sphere fits the picture.
///
/// # Errors
/// [`Cause`]: no faces.
pub fn camera(mesh: &TriangleMesh, direction: DVec3) -> Result<Camera, Cause> {
    drawings::camera(mesh, direction, FOV_Y_RAD, [SIDE_PX; 2])
}

/// The camera `times` as far from its target.
///
/// # Errors
/// [`Cause::View`].
pub fn farther(camera: &Camera, times: f64) -> Result<Camera, Cause> {
    let eye = camera.target().as_dvec3() + times * (camera.eye() - camera.target()).as_dvec3();
    Ok(Camera::new(eye.as_vec3(), camera.target(), camera.up(), camera.projection(), camera.size())?)
}

/// Frames of this size, with a number of samples per pixel.
pub fn frame_style(samples: u32, ground: Ground) -> FrameStyle {
    FrameStyle { size: [SIDE_PX; 2], pen_width_px: 1.0, samples, ground }
}

/// What an outline scores, averaged over views.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Outline {
    /// Area covered by one of drawing and fine mesh but not by the other, of that of the fine mesh.
    pub xor: f64,
    /// Mean distance between both outlines in pixels.
    pub chamfer_px: f64,
    /// Pixels without colour inside of the fine mesh, of its area.
    pub holes: f64,
}

/// Truths of a mesh from sides that are spread evenly.
pub struct Views {
    views: Vec<(Camera, FilledPicture, f64)>,
}

impl Views {
    /// Draws the fine mesh from `count` sides at 16 samples per pixel.
    ///
    /// # Errors
    /// [`Cause`]: cancelled, or a device that failed.
    pub fn new(gpu: &Gpu, fine: &TriangleMesh, count: u32, progress: &dyn Progress) -> Result<Self, Cause> {
        Self::from_afar(gpu, fine, count, 1.0, progress)
    }

    /// The same `distance` times as far as where the bounding sphere fits the picture.
    ///
    /// # Errors
    /// [`Cause`]: cancelled, or a device that failed.
    pub fn from_afar(
        gpu: &Gpu,
        fine: &TriangleMesh,
        count: u32,
        distance: f64,
        progress: &dyn Progress,
    ) -> Result<Self, Cause> {
        let mut truth = FillTruth::new(gpu, fine)?;
        let view = |direction| -> Result<_, Cause> {
            progress.check()?;
            let camera = farther(&camera(fine, direction)?, distance)?;
            let picture = truth.find(gpu, &camera)?;
            let area = picture.coverage().coverages().iter().map(|&coverage| f64::from(coverage)).sum();
            Ok((camera, picture, area))
        };
        Ok(Self { views: spread(count).map(view).collect::<Result<_, _>>()? })
    }

    /// Pixels that the fine mesh covers, averaged over views.
    pub fn covered_px(&self) -> f64 {
        self.views.iter().map(|(_, _, area)| area).sum::<f64>() / self.views.len() as f64
    }

    /// Scores what a method draws.
    ///
    /// # Errors
    /// [`Cause`]: cancelled, or a device that failed.
    pub fn score(&self, gpu: &Gpu, drawing: &mut Drawing, progress: &dyn Progress) -> Result<Outline, Cause> {
        let mut sum = Outline::default();
        for (camera, truth, area) in &self.views {
            progress.check()?;
            drawing.draw(gpu, camera)?;
            let metrics = measure_fill(&FilledPicture::new(drawing.picture(gpu)?), truth);
            sum.xor += metrics.xor_share;
            sum.chamfer_px += metrics.boundary_chamfer_px;
            sum.holes += metrics.hole_pixels / area;
        }
        let count = self.views.len() as f64;
        Ok(Outline { xor: sum.xor / count, chamfer_px: sum.chamfer_px / count, holes: sum.holes / count })
    }
}
