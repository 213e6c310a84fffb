//! [`LocalFrame`]: the coordinates in which a mesh is uploaded.

use crate::frame_view::FrameView;
use glam::{DMat3, DMat4, DVec3, Vec3, Vec4};
use silhouette_core::mesh::Bounds;

/// Coordinates about the middle of a mesh, in a unit of about its size.
///
/// 32-bit floats hold seven digits. A vertex shader that multiplies a mesh's own positions by a matrix to clip space spends
/// them on the distance from the origin; here the large terms cancel in 64 bits before anything is rounded. The unit is
/// a power of two, so that changing to it is exact, and any model unit from 1e-30 to 1e30 is drawn the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalFrame {
    center: DVec3,
    unit: f64,
}

impl LocalFrame {
    /// The frame of a mesh with these bounds; without bounds, the mesh's own space.
    pub fn new(bounds: Option<&Bounds>) -> Self {
        let Some(bounds) = bounds else { return Self { center: DVec3::ZERO, unit: 1.0 } };
        let radius = bounds.radius.max(f64::from(f32::MIN_POSITIVE));
        Self { center: bounds.center, unit: radius.log2().ceil().exp2() }
    }

    /// A position of the mesh's own space in this frame, rounded to 32 bits last.
    pub fn to_local(&self, object: DVec3) -> Vec3 {
        ((object - self.center) / self.unit).as_vec3()
    }

    /// Where the mesh is seen from, in this frame: the eye with w = 1, or the unit direction towards the viewer with w = 0.
    pub fn viewer(&self, view: &FrameView) -> Vec4 {
        let eye = view.object_eye();
        if view.is_perspective() {
            self.to_local(eye.truncate()).extend(1.0)
        } else {
            eye.truncate().normalize().as_vec3().extend(0.0)
        }
    }

    /// The length in the mesh's own space of the frame's unit.
    pub fn unit(&self) -> f64 {
        self.unit
    }

    /// From this frame to clip space. Clip coordinates of a perspective are scaled by a power of two so that w is about as
    /// large as positions are; what they stand for after the division is the same.
    pub fn to_clip(&self, view: &FrameView) -> DMat4 {
        self.through(view, view.projection())
    }

    /// The same with another projection. Rows that two projections share are the same bits in both results.
    pub fn through(&self, view: &FrameView, projection: DMat4) -> DMat4 {
        let from_local = DMat4::from_translation(self.center) * DMat4::from_scale(DVec3::splat(self.unit));
        projection * (view.object_to_view() * from_local) * (1.0 / self.clip_unit(view))
    }

    /// The length in view space that one unit of clip-space w stands for, in a perspective; 1 otherwise.
    pub fn depth_per_w(&self, view: &FrameView) -> f64 {
        let law = view.depth_law();
        let w_slope = law.w_at(1.0) - law.w_at(0.0);
        if law.is_perspective() { self.clip_unit(view) / w_slope } else { 1.0 }
    }

    /// From this frame to its *shape*: the same axes and origin with the proportions that the mesh has in the world, in the unit
    /// of clip-space w (of the frame itself in an orthographic view). The identity for a mesh that the model matrix leaves as it
    /// is.
    pub fn shape(&self, view: &FrameView) -> DMat3 {
        let view_scale = DMat3::from_mat4(view.object_to_view() * view.model().inverse()).x_axis.length();
        let unit = if view.is_perspective() { self.depth_per_w(view) } else { self.unit };
        DMat3::from_mat4(view.model()) * (self.unit * view_scale / unit)
    }

    /// The power of two by which clip coordinates are divided.
    fn clip_unit(&self, view: &FrameView) -> f64 {
        let law = view.depth_law();
        if !law.is_perspective() {
            return 1.0;
        }
        let gradient = view.object_to_view().row(2).truncate().length() * (law.w_at(1.0) - law.w_at(0.0));
        (self.unit * gradient).log2().round().exp2()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::view::{Camera, DepthDirection, Projection};

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
                let view = FrameView::from_camera(&camera, range, DepthDirection::Reversed).unwrap();
                let clip = frame.to_clip(&view).as_mat4() * frame.to_local(world).extend(1.0);
                let expected = camera.project(world).unwrap();
                let x = f64::from(clip.x / clip.w) * 320.0 + 320.0;
                let y = 240.0 - f64::from(clip.y / clip.w) * 240.0;
                assert!((x - expected.pixel.x).abs() < 1e-3 && (y - expected.pixel.y).abs() < 1e-3, "{x} {y}");
                let value = f64::from(clip.z / clip.w);
                let depth = camera.depth_of_buffer_value(value, range, DepthDirection::Reversed);
                assert!((depth / expected.depth - 1.0).abs() < 1e-5, "{depth}");
                if view.is_perspective() {
                    assert!((f64::from(clip.w) * frame.depth_per_w(&view) / expected.depth - 1.0).abs() < 1e-5);
                }
            }
        }
    }

    #[test]
    fn the_shape_has_the_proportions_of_the_world() {
        let bounds = Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE, center: DVec3::ZERO, radius: 3.0 };
        let frame = LocalFrame::new(Some(&bounds));
        for projection in [Projection::Perspective { fov_y_rad: 0.7 }, Projection::Orthographic { height: 4.0 }] {
            let camera = camera(projection, Vec3::ZERO);
            let view = FrameView::from_camera(&camera, camera.clip_range(&bounds), DepthDirection::Reversed).unwrap();
            assert_eq!(frame.shape(&view).as_mat3(), glam::Mat3::IDENTITY);
            let stretched = view.with_model(DMat4::from_scale(DVec3::new(100.0, -200.0, 50.0))).unwrap();
            let shape = frame.shape(&stretched);
            assert!((shape.y_axis.y / shape.x_axis.x + 2.0).abs() < 1e-12);
            assert!((shape.z_axis.z / shape.x_axis.x - 0.5).abs() < 1e-12);
            if view.is_perspective() {
                let (eye, shaped) = (stretched.object_eye().truncate(), shape);
                let local_eye = (eye - bounds.center) / frame.unit();
                let distance = (shaped * local_eye).length() * frame.depth_per_w(&stretched);
                assert!((distance / camera.eye().as_dvec3().length() - 1.0).abs() < 1e-6, "{distance}");
            }
        }
    }
}
