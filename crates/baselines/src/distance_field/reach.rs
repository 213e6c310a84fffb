//! [`Extent`]: how large the field around a view is, and how far seeds are known in it.

use silhouette_core::glam::DVec3;
use silhouette_core::mesh::Bounds;
use silhouette_gpu::{FrameView, FrameViewError, Viewport, WidthOverDepth};

/// Sides of the field grow by this many pixels at a time, so that a width that changes from frame to frame seldom needs others.
const MARGIN_STEP_PX: u32 = 16;

/// Most that the field reaches beyond the viewport. Objects farther outside than this have no line within it, however wide lines
/// are: a field around all that a line of 1000 px could come from would take four times the memory of the picture.
const MOST_MARGIN_PX: u32 = 256;

/// A field around a viewport.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Extent {
    viewport: Viewport,
    /// Pixels beyond the viewport on every side.
    pub margin_px: u32,
    /// Steps of the flood, but for the last, that bring seeds as far as ink reaches.
    pub steps: u32,
}

impl Extent {
    /// The field for ink that reaches `reach_px` from its seeds, at most.
    pub fn new(viewport: Viewport, reach_px: f64) -> Self {
        let margin = (reach_px.max(0.0) + 2.0).min(f64::from(MOST_MARGIN_PX)).ceil() as u32;
        let margin_px = margin.next_multiple_of(MARGIN_STEP_PX).min(MOST_MARGIN_PX);
        let longest = viewport.size_px.into_iter().fold(0, u32::max).saturating_add(2 * margin_px);
        // Steps of 1, 2, 4 … n / 2 pixels bring a seed n - 1 pixels far. Seeds and samples lie beside the middles of their pixels, by
        // half a diagonal at most each.
        let far = (reach_px.max(0.0) + std::f64::consts::SQRT_2).min(f64::from(longest)).floor() as u32;
        Self { viewport, margin_px, steps: (far + 1).next_power_of_two().trailing_zeros() }
    }

    /// Width and height.
    pub fn size_px(&self) -> [u32; 2] {
        self.viewport.size_px.map(|side| side.saturating_add(2 * self.margin_px))
    }

    /// What added to a pixel of the target is a pixel of the field.
    pub fn field_offset(&self) -> [i32; 2] {
        self.viewport
            .origin_px
            .map(|side| i32::try_from(side).unwrap_or(i32::MAX))
            .map(|side| self.margin_px as i32 - side)
    }

    /// The view that draws into the field what `view` draws into the viewport, and what lies around.
    pub fn view(&self, view: &FrameView) -> Result<FrameView, FrameViewError> {
        view.tile([-(self.margin_px as i32); 2], self.size_px(), 1)
    }
}

/// The least depth of a box's corners in front of the near plane, in units of view space; of the near plane where the box
/// reaches it.
pub(crate) fn nearest_depth(view: &FrameView, bounds: &Bounds) -> f64 {
    let corner = |index: u32| {
        let side = |axis: usize| if index & (1 << axis) == 0 { bounds.min[axis] } else { bounds.max[axis] };
        view.depth(DVec3::new(side(0), side(1), side(2)))
    };
    (0..8).map(corner).fold(f64::INFINITY, f64::min).max(view.depth_law().range().near)
}

/// The most pixels that a width comes to on an object with these bounds.
pub(crate) fn widest_px(view: &FrameView, bounds: &Bounds, width: &WidthOverDepth) -> f64 {
    if width.px_at_depth_1 > 0.0 { width.px_at(nearest_depth(view, bounds)) } else { width.constant_px }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_reach_as_far_as_ink_and_little_farther() {
        let viewport = Viewport { origin_px: [7, 3], size_px: [600, 400] };
        for (reach_px, steps) in [(0.0, 1), (1.0, 2), (2.0, 2), (6.0, 3), (7.0, 4), (100.0, 7), (1e9, 11)] {
            let extent = Extent::new(viewport, reach_px);
            assert_eq!(extent.steps, steps, "{reach_px}");
            let [width, height] = extent.size_px();
            assert!(width - 600 == 2 * extent.margin_px && height - 400 == 2 * extent.margin_px);
            assert!(f64::from(extent.margin_px) >= (reach_px + 2.0).min(256.0), "{reach_px}");
            assert_eq!(extent.field_offset(), [extent.margin_px as i32 - 7, extent.margin_px as i32 - 3]);
        }
    }
}
