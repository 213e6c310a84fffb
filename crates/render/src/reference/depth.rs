//! [`ReferenceDepth`]: the depth of every sample of a reference image.

use crate::image::DepthImage;
use crate::lines::ScreenSegment;
use crate::lines::line_segments::Projector;
use crate::lines::line_visibility::{DepthScale, SceneDepth};
use crate::pass_view::PassView;
use glam::DVec3;

/// Depth-buffer values at n x n samples a pixel, with what they mean. Coordinates are samples: n times the camera's
/// pixels, origin at the top left.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceDepth {
    pub(super) image: DepthImage,
    pub(super) view: PassView,
    pub(super) scale: DepthScale,
}

impl ReferenceDepth {
    /// The values: reversed 32-bit depth, 0 where nothing was drawn.
    pub fn values(&self) -> &DepthImage {
        &self.image
    }

    /// What was drawn: camera, depth range, samples along each side of a pixel as the tile's scale.
    pub fn view(&self) -> &PassView {
        &self.view
    }

    /// The depth along the viewing axis, in world units, at the sample that holds this point; `None` where nothing
    /// was drawn and outside.
    pub fn view_depth_at(&self, x: f64, y: f64) -> Option<f64> {
        let inside =
            (0.0..f64::from(self.image.width)).contains(&x) && (0.0..f64::from(self.image.height)).contains(&y);
        let value = inside.then(|| f64::from(self.image.value(x as u32, y as u32))).filter(|&value| value > 0.0)?;
        Some(self.view.camera.depth_of_buffer_value(value, self.view.range, self.view.direction))
    }

    /// A segment of world space in samples, clipped by the near plane and the viewport; `None` where nothing is left.
    pub fn project(&self, a: DVec3, b: DVec3) -> Option<ScreenSegment> {
        let view = &self.view;
        Projector::new(view.world_to_clip(), view.target_px(), view.direction, 0.0).project(a, b)
    }

    /// Whether the point of a projected segment at `t`, from 0 to 1, is visible: what [`LinePass`](crate::LinePass)
    /// decides on the GPU.
    pub fn visible_at(&self, segment: &ScreenSegment, t: f64) -> bool {
        SceneDepth { image: &self.image, scale: self.scale }.visible_at(segment, t)
    }
}
