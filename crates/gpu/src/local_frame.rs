//! [`LocalFrame`]: the coordinates in which a mesh is uploaded.

use glam::{DMat4, DVec3, Vec3};
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Camera, ClipRange, DepthDirection, Projection};

/// Coordinates about the middle of a mesh, in a unit of about its size.
///
/// 32-bit floats hold seven digits. A vertex shader that multiplies world positions by a world-to-clip matrix spends
/// them on the distance from the origin; here the large terms cancel in 64 bits before anything is rounded. The unit is
/// a power of two, so that changing to it is exact, and any model unit from 1e-30 to 1e30 is drawn the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalFrame {
    center: DVec3,
    unit: f64,
}

impl LocalFrame {
    /// The frame of a mesh with these bounds; of an empty mesh, the world itself.
    pub fn new(bounds: Option<&Bounds>) -> Self {
        let Some(bounds) = bounds else { return Self { center: DVec3::ZERO, unit: 1.0 } };
        let radius = bounds.radius.max(f64::from(f32::MIN_POSITIVE));
        Self { center: bounds.center, unit: radius.log2().ceil().exp2() }
    }

    /// A world position in this frame, rounded to 32 bits last.
    pub fn to_local(&self, world: DVec3) -> Vec3 {
        ((world - self.center) / self.unit).as_vec3()
    }

    /// From this frame to the clip space of `camera`. Clip coordinates of a perspective are in units of the frame;
    /// what they stand for after the division is the same.
    pub fn to_clip(&self, camera: &Camera, range: ClipRange, direction: DepthDirection) -> DMat4 {
        self.through(camera, camera.clip_matrix(range, direction))
    }

    /// The same with a view-to-clip matrix of the caller's own. Rows that two such matrices share are the same bits in
    /// both results.
    pub fn through(&self, camera: &Camera, view_to_clip: DMat4) -> DMat4 {
        let from_local = DMat4::from_translation(self.center) * DMat4::from_scale(DVec3::splat(self.unit));
        view_to_clip * (camera.view_matrix() * from_local) * (1.0 / self.clip_unit(camera))
    }

    /// The world length of the frame's unit.
    pub fn unit(&self) -> f64 {
        self.unit
    }

    /// The world length that one unit of clip-space w stands for.
    pub fn clip_unit(&self, camera: &Camera) -> f64 {
        match camera.projection() {
            Projection::Perspective { .. } => self.unit,
            Projection::Orthographic { .. } => 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera(projection: Projection, center: Vec3) -> Camera {
        Camera::new(center + Vec3::new(3.0, 2.0, 5.0), center, Vec3::Y, projection, [640, 480]).unwrap()
    }

    #[test]
    fn positions_land_where_the_camera_projects_them_even_far_from_the_origin() {
        for center in [Vec3::ZERO, Vec3::new(1e6, -1e6, 5e5)] {
            let world = center.as_dvec3() + DVec3::new(0.25, -0.5, 0.125);
            let bounds =
                Bounds { min: world, max: world, center: center.as_dvec3() + DVec3::splat(0.01), radius: 1.25 };
            let frame = LocalFrame::new(Some(&bounds));
            for projection in [Projection::Perspective { fov_y_rad: 0.7 }, Projection::Orthographic { height: 4.0 }] {
                let camera = camera(projection, center);
                let range = camera.clip_range(&bounds);
                let clip = frame.to_clip(&camera, range, DepthDirection::Reversed).as_mat4()
                    * frame.to_local(world).extend(1.0);
                let expected = camera.project(world).unwrap();
                let x = f64::from(clip.x / clip.w) * 320.0 + 320.0;
                let y = 240.0 - f64::from(clip.y / clip.w) * 240.0;
                assert!((x - expected.pixel.x).abs() < 1e-3 && (y - expected.pixel.y).abs() < 1e-3, "{x} {y}");
                let value = f64::from(clip.z / clip.w);
                let depth = camera.depth_of_buffer_value(value, range, DepthDirection::Reversed);
                assert!((depth / expected.depth - 1.0).abs() < 1e-5, "{depth}");
            }
        }
    }
}
