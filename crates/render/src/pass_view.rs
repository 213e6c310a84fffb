//! [`PassView`]: a camera, or a part of what it sees at a higher resolution.

use glam::{DMat4, DVec3};
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Camera, ClipRange, DepthDirection};
use silhouette_gpu::LocalFrame;

/// A rectangle of a camera's viewport, drawn at several samples a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tile {
    /// Top left corner in pixels of the viewport; it may lie outside.
    pub origin_px: [i32; 2],
    /// Width and height in pixels of the viewport.
    pub size_px: [u32; 2],
    /// Pixels of the target along each side of a pixel of the viewport.
    pub scale: u32,
}

/// What a pass sees: everything between world space and the pixels of a target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PassView {
    /// The camera.
    pub camera: Camera,
    /// The depths that it shows.
    pub range: ClipRange,
    /// Which end of the depth buffer is near.
    pub direction: DepthDirection,
    /// The part of the viewport that the target shows.
    pub tile: Tile,
}

impl PassView {
    /// All that `camera` sees of a mesh with these bounds, a pixel of the target for each of the viewport. Without
    /// bounds, depths about the camera's target are shown.
    pub fn new(camera: &Camera, bounds: Option<&Bounds>, direction: DepthDirection) -> Self {
        let (eye, target) = (camera.eye().as_dvec3(), camera.target().as_dvec3());
        let about_target = Bounds { min: target, max: target, center: target, radius: 0.5 * eye.distance(target) };
        let range = camera.clip_range(bounds.unwrap_or(&about_target));
        let tile = Tile { origin_px: [0, 0], size_px: camera.size(), scale: 1 };
        Self { camera: *camera, range, direction, tile }
    }

    /// The same view of one tile.
    #[must_use]
    pub fn with_tile(self, tile: Tile) -> Self {
        Self { tile, ..self }
    }

    /// Width and height of the target in pixels.
    pub fn target_px(&self) -> [u32; 2] {
        self.tile.size_px.map(|side| side * self.tile.scale)
    }

    /// World space to the clip space of the target.
    pub fn world_to_clip(&self) -> DMat4 {
        self.crop() * self.camera.world_to_clip(self.range, self.direction)
    }

    /// A mesh's frame to the clip space of the target.
    pub fn local_to_clip(&self, frame: &LocalFrame) -> DMat4 {
        self.crop() * frame.to_clip(&self.camera, self.range, self.direction)
    }

    /// Clip space of the viewport to that of the tile.
    fn crop(&self) -> DMat4 {
        let [x, y] = [0, 1].map(|axis| {
            let full = f64::from(self.camera.size()[axis]);
            let part = f64::from(self.tile.size_px[axis]);
            let from_middle = f64::from(self.tile.origin_px[axis]) + 0.5 * part - 0.5 * full;
            (full / part, -2.0 * from_middle / part)
        });
        // Pixels count downwards, clip space upwards.
        let scale = DMat4::from_scale(DVec3::new(x.0, y.0, 1.0));
        DMat4::from_translation(DVec3::new(x.1, -y.1, 0.0)) * scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use silhouette_core::view::Projection;

    #[test]
    fn a_tile_shows_its_part_of_the_viewport() {
        let projection = Projection::Perspective { fov_y_rad: 0.8 };
        let camera = Camera::new(Vec3::new(1.0, 2.0, 5.0), Vec3::ZERO, Vec3::Y, projection, [300, 200]).unwrap();
        let whole = PassView::new(&camera, None, DepthDirection::Reversed);
        let tile = Tile { origin_px: [-10, 120], size_px: [50, 40], scale: 3 };
        let part = whole.with_tile(tile);
        assert_eq!((whole.target_px(), part.target_px()), ([300, 200], [150, 120]));
        for world in [DVec3::ZERO, DVec3::new(0.4, -0.3, 0.9)] {
            let expected = camera.project(world).unwrap().pixel;
            for view in [whole, part] {
                let ndc = view.world_to_clip().project_point3(world);
                let [width, height] = view.target_px().map(f64::from);
                let target = glam::DVec2::new((ndc.x + 1.0) * 0.5 * width, (1.0 - ndc.y) * 0.5 * height);
                let origin = glam::DVec2::new(f64::from(view.tile.origin_px[0]), f64::from(view.tile.origin_px[1]));
                let pixel = target / f64::from(view.tile.scale) + origin;
                assert!((pixel - expected).length() < 1e-9, "{pixel} {expected}");
            }
        }
    }
}
