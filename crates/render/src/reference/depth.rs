//! [`ReferenceDepth`]: the depth of every sample of a reference image.

use crate::image::DepthImage;
use crate::target::DEFAULT_FORMATS;
use glam::DVec3;
use silhouette_gpu::{DepthScale, FrameView, Projector, SceneDepth, ScreenSegment};

/// Depth-buffer values at n x n samples per pixel, with what they mean. Coordinates are samples: n times the camera's
/// pixels, origin at the top left.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceDepth {
    image: DepthImage,
    view: FrameView,
    samples_per_side: u32,
    scale: DepthScale,
}

impl ReferenceDepth {
    /// Values that were drawn for `view`, whose viewport is the image, at this many samples along each side of a pixel.
    pub(super) fn new(image: DepthImage, view: FrameView, samples_per_side: u32) -> Self {
        Self { image, view, samples_per_side, scale: DepthScale::new(&view, DEFAULT_FORMATS.depth) }
    }

    /// Samples along each side of a pixel of the camera.
    pub fn samples_per_side(&self) -> u32 {
        self.samples_per_side
    }

    /// The values: reversed 32-bit depth, 0 where nothing was drawn.
    pub fn values(&self) -> &DepthImage {
        &self.image
    }

    /// The depth along the viewing axis, in world units, at the sample that holds this point; `None` where nothing
    /// was drawn and outside.
    pub fn view_depth_at(&self, x: f64, y: f64) -> Option<f64> {
        let inside =
            (0.0..f64::from(self.image.width)).contains(&x) && (0.0..f64::from(self.image.height)).contains(&y);
        let value = inside.then(|| f64::from(self.image.value(x as u32, y as u32))).filter(|&value| value > 0.0)?;
        Some(self.view.depth_law().depth_of_value(value))
    }

    /// A segment of world space in samples, clipped by the near plane and the viewport; `None` where nothing is left.
    pub fn project(&self, a: DVec3, b: DVec3) -> Option<ScreenSegment> {
        Projector::new(&self.view, 0.0).project(a, b)
    }

    /// Whether the point of a projected segment at `t`, from 0 to 1, is visible: what strokes decide on the GPU.
    pub fn visible_at(&self, segment: &ScreenSegment, t: f64) -> bool {
        let (size_px, values) = ([self.image.width, self.image.height], &self.image.values[..]);
        SceneDepth { size_px, values, scale: self.scale }.visible_at(segment, t)
    }
}
