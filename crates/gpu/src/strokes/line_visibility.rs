//! Which points of a line the mesh hides. Twin of `shaders/render/line_visibility.wgsl`.
//!
//! A line on the surface that hides it cannot be compared with the depth at its own pixel: half of its pixels hold the
//! surface that it bounds. So three pixels are asked, at the line and one pixel to either side, and the line is visible
//! where any of them lets it through. A visible silhouette edge has something farther on its outer side; a hidden one
//! has the surface that hides it in front of all three. What this gets wrong is less than a pixel at either end of a
//! visible piece.

use super::line_segments::ScreenSegment;
use crate::frame_view::FrameView;
use glam::DVec2;
use silhouette_core::view::DepthDirection;

/// A line counts as hidden only where the scene is nearer by more than this share of its depth (of the depth range in
/// an orthographic view). It must exceed the rounding of a line that lies in the surface, 1e-6 of the depth, and stay
/// below the thickness of what may hide a line: at three radii from a mesh it is 3e-4 radii.
const TOLERANCE: f64 = 1e-4;

/// How values of one depth buffer are compared with the depth of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DepthScale {
    /// `(p, q, r, s)`: the value v stands for the depth `(p v + q) / (r v + s)`, in an arbitrary unit.
    pub(super) depth_of_value: [f64; 4],
    /// Added to a value to push it one quantisation step away from the viewer.
    pub(super) away_step: f32,
    /// Value of pixels that nothing was drawn to.
    pub(super) clear_depth: f32,
    pub(super) relative_tolerance: f64,
    pub(super) absolute_tolerance: f64,
}

impl DepthScale {
    /// For the depth buffer of a pass that showed `view`, in `format`.
    pub fn new(view: &FrameView, format: wgpu::TextureFormat) -> Self {
        let law = view.depth_law();
        let range = law.range();
        // Depths in units of the far plane, or of the depth range, so that any model unit fits 32-bit floats.
        let (unit, relative_tolerance, absolute_tolerance) = if law.is_perspective() {
            (if range.far.is_finite() { range.far } else { range.near }, TOLERANCE, 0.0)
        } else {
            (range.far - range.near, 0.0, TOLERANCE)
        };
        let [p, q, r, s] = law.depth_of_value_terms();
        let terms = [p / unit, q / unit, r, s];
        let largest = terms[2].abs().max(terms[3].abs());
        // Half a step is the rounding of the value; hardware may round the interpolation as much again.
        let step = match format {
            wgpu::TextureFormat::Depth16Unorm => 1.0 / 65_535.0,
            wgpu::TextureFormat::Depth32Float => f32::EPSILON,
            _ => 4.0 / 16_777_215.0,
        };
        let (away_step, clear_depth) = match view.depth_direction() {
            DepthDirection::Standard => (step, 1.0),
            DepthDirection::Reversed => (-step, 0.0),
        };
        let depth_of_value = terms.map(|term| term / largest);
        Self { depth_of_value, away_step, clear_depth, relative_tolerance, absolute_tolerance }
    }

    fn depth(&self, value: f64) -> f64 {
        let [p, q, r, s] = self.depth_of_value;
        (p * value + q) / (r * value + s)
    }
}

/// The depth buffer of a scene, asked for the visibility of lines.
#[derive(Debug, Clone, Copy)]
pub struct SceneDepth<'a> {
    /// Width and height in pixels.
    pub size_px: [u32; 2],
    /// The values, row by row.
    pub values: &'a [f32],
    /// How to compare them.
    pub scale: DepthScale,
}

impl SceneDepth<'_> {
    /// Whether the point of `segment` at `t` (0 at its first end, 1 at the second) is visible. The segment is in pixels
    /// of this depth buffer.
    pub fn visible_at(&self, segment: &ScreenSegment, t: f64) -> bool {
        let along = (segment.b - segment.a).truncate();
        let normal = DVec2::new(along.y, -along.x) / along.length().max(1e-6);
        let point = segment.at(t);
        [DVec2::ZERO, normal, -normal].into_iter().any(|offset| self.lets_through(point + offset, segment))
    }

    /// Whether the scene at the pixel that holds `p` lets the segment through.
    fn lets_through(&self, p: DVec2, segment: &ScreenSegment) -> bool {
        let last = DVec2::from_array(self.size_px.map(f64::from)) - 1.0;
        let pixel = p.floor().clamp(DVec2::ZERO, last);
        let scene = self.values[pixel.y as usize * self.size_px[0] as usize + pixel.x as usize];
        if scene.to_bits() == self.scale.clear_depth.to_bits() {
            return true;
        }
        let along = (segment.b - segment.a).truncate();
        let center = pixel + 0.5 - segment.a.truncate();
        let nearest = (center.dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
        let line = self.scale.depth(segment.a.lerp(segment.b, nearest).z);
        let behind = self.scale.depth(f64::from(scene + self.scale.away_step).clamp(0.0, 1.0));
        line <= behind + behind * self.scale.relative_tolerance + self.scale.absolute_tolerance
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DVec3, Vec3};
    use silhouette_core::view::{Camera, ClipRange, Projection};

    const RANGE: ClipRange = ClipRange { near: 1.0, far: 9.0 };

    fn view(projection: Projection, direction: DepthDirection) -> FrameView {
        let camera = Camera::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, Vec3::Y, projection, [8, 8]).unwrap();
        FrameView::from_camera(&camera, RANGE, direction).unwrap()
    }

    #[test]
    fn lines_are_hidden_by_what_is_nearer_and_by_nothing_else() {
        for projection in [Projection::Perspective { fov_y_rad: 1.0 }, Projection::Orthographic { height: 4.0 }] {
            for direction in [DepthDirection::Standard, DepthDirection::Reversed] {
                let view = view(projection, direction);
                let value = |depth: f64| view.depth_law().value_at(depth);
                let format = wgpu::TextureFormat::Depth32Float;
                let scale = DepthScale::new(&view, format);
                let plane = vec![value(5.0) as f32; 64];
                let scene = SceneDepth { size_px: [8, 8], values: &plane, scale };
                let line = |depth: f64| ScreenSegment {
                    a: DVec3::new(1.0, 3.0, value(depth)),
                    b: DVec3::new(7.0, 5.0, value(depth)),
                };
                for t in [0.0, 0.3, 1.0] {
                    assert!(scene.visible_at(&line(4.9), t), "in front");
                    assert!(scene.visible_at(&line(5.0), t), "in the plane");
                    assert!(!scene.visible_at(&line(5.01), t), "behind");
                }
                // Background on one side lets the line through: it bounds what hides it.
                let mut half = plane.clone();
                half[32..].fill(scale.clear_depth);
                let scene = SceneDepth { size_px: [8, 8], values: &half, scale };
                let horizontal =
                    |y: f64| ScreenSegment { a: DVec3::new(1.0, y, value(5.5)), b: DVec3::new(7.0, y, value(5.5)) };
                assert!(scene.visible_at(&horizontal(3.9), 0.5));
                assert!(!scene.visible_at(&horizontal(2.9), 0.5));
            }
        }
    }
}
