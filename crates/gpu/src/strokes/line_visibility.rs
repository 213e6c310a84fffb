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

/// The tolerance is at most this share of the depth range. Seen from a thousand radii away, a share of the depth is more than what
/// hides a line is thick; up to seven radii away, with planes tight around a mesh, it is the smaller of the two.
const MOST_OF_RANGE: f64 = 4.0 * TOLERANCE;

/// How values of one depth buffer are compared with the depth of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DepthScale {
    /// `(p, q, r, s)`: the value v stands for the depth `(p v + q) / (r v + s)` beyond the near plane, in an arbitrary unit. Beyond
    /// the near plane, so that of a mesh that is far away and thin the thickness is left, not the difference of two distances.
    pub(super) depth_of_value: [f64; 4],
    /// Multiplies a value to push it one step of a floating-point buffer away from the viewer; 1 for other buffers.
    pub(super) away_scale: f32,
    /// Added to a value to push it one quantisation step away from the viewer; 0 for floating-point buffers.
    pub(super) away_step: f32,
    /// Value of pixels that nothing was drawn to.
    pub(super) clear_depth: f32,
    pub(super) relative_tolerance: f64,
    pub(super) absolute_tolerance: f64,
    /// Both together are at most this.
    pub(super) most_tolerance: f64,
}

impl DepthScale {
    /// For the depth buffer of a pass that showed `view`, in `format`.
    pub fn new(view: &FrameView, format: wgpu::TextureFormat) -> Self {
        let law = view.depth_law();
        let range = law.range();
        let thickness = range.far - range.near;
        // Depths in units of the depth range, or of the near plane, so that any model unit fits 32-bit floats.
        let unit = if thickness.is_finite() { thickness } else { range.near };
        let (relative_tolerance, absolute_tolerance, most_tolerance) = if law.is_perspective() {
            (TOLERANCE, TOLERANCE * range.near / unit, MOST_OF_RANGE * thickness / unit)
        } else {
            (0.0, TOLERANCE, TOLERANCE)
        };
        let (direction, clear_depth) = match view.depth_direction() {
            DepthDirection::Standard => (1.0, 1.0),
            DepthDirection::Reversed => (-1.0, 0.0),
        };
        let [p, q, r, s] = law.depth_beyond_near_terms();
        let terms = [p / unit, q / unit, r, s];
        let largest = terms[2].abs().max(terms[3].abs());
        // Half a step is the rounding of the value; hardware may round the interpolation as much again.
        let (away_scale, away_step) = match format {
            wgpu::TextureFormat::Depth32Float => (1.0 + direction * f32::EPSILON, 0.0),
            wgpu::TextureFormat::Depth16Unorm => (1.0, direction / 65_535.0),
            _ => (1.0, direction * 4.0 / 16_777_215.0),
        };
        let depth_of_value = terms.map(|term| term / largest);
        Self {
            depth_of_value,
            away_scale,
            away_step,
            clear_depth,
            relative_tolerance,
            absolute_tolerance,
            // What is infinite is no bound, and no number for every driver.
            most_tolerance: most_tolerance.min(f64::from(f32::MAX)),
        }
    }

    fn depth(&self, value: f64) -> f64 {
        let [p, q, r, s] = self.depth_of_value;
        (p * value + q) / (r * value + s)
    }

    /// Whether what is drawn with the value `line` shows before a scene of the value `scene`.
    fn shows(&self, line: f64, scene: f32) -> bool {
        let away = f64::from(scene * self.away_scale + self.away_step);
        let behind = self.depth(away.clamp(0.0, 1.0));
        let tolerance = (behind * self.relative_tolerance + self.absolute_tolerance).min(self.most_tolerance);
        self.depth(line) <= behind + tolerance
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
        self.scale.shows(segment.a.lerp(segment.b, nearest).z, scene)
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

    /// From 1e7 away, and with planes so far from each other that all values are tiny, a tenth of what is seen hides a line.
    #[test]
    fn what_is_thin_hides_lines_whatever_its_distance_and_the_planes() {
        let tight = |distance: f64| ClipRange { near: distance - 1.0, far: distance + 1.0 };
        let wide = ClipRange { near: 1e-6, far: 10.0 };
        let infinite = ClipRange { near: 0.1, far: f64::INFINITY };
        for (distance, range) in [(3.0, tight(3.0)), (1e4, tight(1e4)), (1e7, tight(1e7)), (4.0, wide), (4.0, infinite)]
        {
            let projection = Projection::Perspective { fov_y_rad: 3.0 / distance };
            let camera = Camera::new(Vec3::Z * distance as f32, Vec3::ZERO, Vec3::Y, projection, [8, 8]).unwrap();
            let view = FrameView::from_camera(&camera, range, DepthDirection::Reversed).unwrap();
            let scale = DepthScale::new(&view, wgpu::TextureFormat::Depth32Float);
            let value = |beyond: f64| view.depth_law().value_at(distance + beyond);
            assert!(scale.shows(value(-0.1), value(0.0) as f32) && scale.shows(value(0.0), value(0.0) as f32));
            assert!(!scale.shows(value(0.1), value(0.0) as f32), "{distance} {range:?}");
        }
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
