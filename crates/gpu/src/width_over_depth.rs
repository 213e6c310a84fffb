//! [`WidthOverDepth`]: what the width of a line comes to in a view.

use crate::frame_view::FrameView;
use silhouette_core::line_style::{LineWidth, WidthUnit};
use silhouette_core::mesh::Bounds;

const MM_PER_INCH: f64 = 25.4;

/// A width as a function of depth: `constant_px + px_at_depth_1 / depth`, depth in units of view space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WidthOverDepth {
    /// Pixels at every depth.
    pub constant_px: f64,
    /// Pixels at depth 1 that fall with depth; 0 in an orthographic view.
    pub px_at_depth_1: f64,
}

impl WidthOverDepth {
    /// What `width` comes to in a view of a mesh with these bounds.
    pub fn new(width: &LineWidth, view: &FrameView, bounds: &Bounds) -> Self {
        let height_px = f64::from(view.viewport().size_px[1]);
        let value = width.value * clutter_factor(width, view, bounds);
        let constant = |constant_px| Self { constant_px, px_at_depth_1: 0.0 };
        match width.unit {
            WidthUnit::Pixels => constant(value),
            WidthUnit::Millimetres { dpi } => constant(value * dpi / MM_PER_INCH),
            WidthUnit::HeightPercent => constant(value * 0.01 * height_px),
            WidthUnit::World => {
                let px = value * view.pixels_per_unit(1.0);
                if view.is_perspective() { Self { constant_px: 0.0, px_at_depth_1: px } } else { constant(px) }
            }
        }
    }

    /// The width at a depth, in pixels.
    pub fn px_at(&self, depth: f64) -> f64 {
        self.constant_px + self.px_at_depth_1 / depth
    }

    /// The width in pixels at the middle of a mesh, and what to add to depth-buffer values
    /// ([`LineShape::lift`](crate::LineShape::lift)) to bring lines there as far in front of the faces that they lie on as they
    /// are wide.
    pub fn lift(&self, view: &FrameView, bounds: &Bounds) -> (f64, f32) {
        let law = view.depth_law();
        let range = law.range();
        let least = if range.far.is_finite() { range.near + 0.1 * (range.far - range.near) } else { 1.1 * range.near };
        let depth = view.depth(bounds.center).max(least);
        let width_px = self.px_at(depth);
        let toward = width_px / view.pixels_per_unit(depth);
        let lift = law.value_at(depth - toward.min(0.5 * depth.abs())) - law.value_at(depth);
        (width_px, lift as f32)
    }
}

/// The share of its width that a line keeps at the distance of the mesh.
fn clutter_factor(width: &LineWidth, view: &FrameView, bounds: &Bounds) -> f64 {
    let Some(radii) = width.thins_beyond_radii else { return 1.0 };
    let distance = view.object_to_view().transform_point3(bounds.center).length();
    (radii * bounds.radius * view.largest_scale() / distance).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DVec3, Vec3};
    use silhouette_core::view::{Camera, ClipRange, DepthDirection, Projection};

    fn view(projection: Projection) -> FrameView {
        let camera = Camera::new(Vec3::Z * 4.0, Vec3::ZERO, Vec3::Y, projection, [300, 200]).unwrap();
        FrameView::from_camera(&camera, ClipRange { near: 1.0, far: 9.0 }, DepthDirection::Reversed).unwrap()
    }

    fn bounds() -> Bounds {
        Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE, center: DVec3::ZERO, radius: 1.0 }
    }

    fn px(value: f64, unit: WidthUnit, projection: Projection, depth: f64) -> f64 {
        let width = LineWidth { value, unit, thins_beyond_radii: None };
        WidthOverDepth::new(&width, &view(projection), &bounds()).px_at(depth)
    }

    #[test]
    fn every_unit_comes_to_its_pixels() {
        let perspective = Projection::Perspective { fov_y_rad: 2.0 * 1.0_f64.atan() };
        let orthographic = Projection::Orthographic { height: 4.0 };
        for projection in [perspective, orthographic] {
            assert!((px(2.5, WidthUnit::Pixels, projection, 3.0) - 2.5).abs() < 1e-12);
            assert!((px(2.54, WidthUnit::Millimetres { dpi: 300.0 }, projection, 3.0) - 30.0).abs() < 1e-9);
            assert!((px(1.5, WidthUnit::HeightPercent, projection, 3.0) - 3.0).abs() < 1e-12);
        }
        // With a field of view of 90 degrees, half of the height is a unit at depth 1.
        assert!((px(0.1, WidthUnit::World, perspective, 4.0) - 2.5).abs() < 1e-12);
        assert!((px(0.1, WidthUnit::World, orthographic, 4.0) - 5.0).abs() < 1e-12);
    }

    #[test]
    fn lines_thin_beyond_the_clutter_distance_and_not_before() {
        let projection = Projection::Perspective { fov_y_rad: 0.8 };
        for (radii, factor) in [(2.0, 0.5), (4.0, 1.0), (9.0, 1.0)] {
            let width = LineWidth { value: 2.0, unit: WidthUnit::Pixels, thins_beyond_radii: Some(radii) };
            assert!(
                (WidthOverDepth::new(&width, &view(projection), &bounds()).constant_px - 2.0 * factor).abs() < 1e-12
            );
        }
    }
}
