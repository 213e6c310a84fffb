//! [`Eye`] and [`SmoothingView`]: where a mesh is seen from, and how large.

use silhouette_core::glam::{DMat4, DVec2, DVec3, DVec4, Vec4Swizzles as _};
use silhouette_core::view::{Camera, ClipRange, DepthDirection, Viewpoint};

/// Where a mesh is seen from, in its own space: a point with w = 1, or a direction towards the viewer with w = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Eye(DVec4);

impl From<Viewpoint> for Eye {
    fn from(viewpoint: Viewpoint) -> Self {
        match viewpoint {
            Viewpoint::Perspective { eye } => Self(eye.as_dvec3().extend(1.0)),
            Viewpoint::Orthographic { toward_viewer } => Self(toward_viewer.as_dvec3().normalize_or_zero().extend(0.0)),
        }
    }
}

impl Eye {
    /// From a point with w = 1 or a direction towards the viewer with w = 0, in object space.
    pub fn new(homogeneous: DVec4) -> Self {
        Self(homogeneous)
    }

    /// The vector from a point towards the viewer: the paper's D of section II; its D of Eq. 7 is the negative. Of unit length
    /// for a direction, not for an eye.
    #[inline]
    pub fn toward(self, point: DVec3) -> DVec3 {
        self.0.truncate() - self.0.w * point
    }

    /// The eye, or `None` for parallel projection.
    pub fn position(self) -> Option<DVec3> {
        (self.0.w != 0.0).then(|| self.0.truncate())
    }

    /// The same rounded to 32 bits: what the exact facing of faces depends on.
    pub(crate) fn viewpoint(self) -> Viewpoint {
        let vector = self.0.truncate().as_vec3();
        match self.position() {
            Some(_) => Viewpoint::Perspective { eye: vector },
            None => Viewpoint::Orthographic { toward_viewer: vector },
        }
    }

    /// The point with w = 1 or direction with w = 0.
    pub fn homogeneous(self) -> DVec4 {
        self.0
    }
}

/// A view of a mesh in pixels: what smoothing depends on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmoothingView {
    eye: Eye,
    /// Object space to pixels: x, y and w are those of the pixel times w.
    to_pixel: DMat4,
}

impl SmoothingView {
    /// The view of a camera whose world is the mesh's own space.
    pub fn from_camera(camera: &Camera) -> Self {
        // Pixels do not depend on the range of depths.
        let range = ClipRange { near: 1.0, far: 2.0 };
        let mut to_clip = camera.world_to_clip(range, DepthDirection::Standard).transpose();
        // A camera has no range of its own: all that is in front of it lies in the middle of one.
        to_clip.z_axis = 0.5 * to_clip.w_axis;
        Self::new(Eye::from(camera.viewpoint()), to_clip.transpose(), camera.size())
    }

    /// A view from an eye, with a matrix from object space to clip space and the size of the viewport in pixels.
    pub fn new(eye: Eye, object_to_clip: DMat4, size: [u32; 2]) -> Self {
        let half = size.map(|side| 0.5 * f64::from(side));
        let to_pixel = DMat4::from_translation(DVec3::new(half[0], half[1], 0.0))
            * DMat4::from_scale(DVec3::new(half[0], -half[1], 1.0));
        Self { eye, to_pixel: to_pixel * object_to_clip }
    }

    /// Where the mesh is seen from.
    pub fn eye(&self) -> Eye {
        self.eye
    }

    /// Object space to pixels, homogeneous: x right, y down.
    pub fn to_pixel(&self) -> DMat4 {
        self.to_pixel
    }

    /// Where a point appears, in homogeneous pixels: x and y times w, and w.
    #[inline]
    pub fn homogeneous(&self, point: DVec3) -> DVec3 {
        let all = &self.to_pixel;
        point.x * all.x_axis.xyw() + point.y * all.y_axis.xyw() + point.z * all.z_axis.xyw() + all.w_axis.xyw()
    }

    /// How far a way in object space leads in homogeneous pixels.
    #[inline]
    pub fn homogeneous_way(&self, way: DVec3) -> DVec3 {
        let all = &self.to_pixel;
        way.x * all.x_axis.xyw() + way.y * all.y_axis.xyw() + way.z * all.z_axis.xyw()
    }

    /// Whether a ball lies in front of the viewer and within the range of depths as a whole, so that no plane cuts it.
    pub fn holds(&self, center: DVec3, radius: f64) -> bool {
        let [depth, w] = [self.to_pixel.row(2), self.to_pixel.row(3)];
        [depth, w - depth].iter().all(|plane| plane.dot(center.extend(1.0)) >= radius * plane.xyz().length())
    }

    /// Where a point appears, in pixels, and its w, which is above 0 in front of the viewer.
    pub fn pixel(&self, point: DVec3) -> (DVec2, f64) {
        let pixel = self.to_pixel * point.extend(1.0);
        (pixel.xy() / pixel.w, pixel.w)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::Vec3;
    use silhouette_core::view::Projection;

    #[test]
    fn a_ball_is_held_unless_the_eye_or_a_plane_is_in_it() {
        let camera =
            Camera::new(5.0 * Vec3::Z, Vec3::ZERO, Vec3::Y, Projection::Perspective { fov_y_rad: 0.7 }, [64; 2])
                .unwrap();
        let whole = SmoothingView::from_camera(&camera);
        assert!(whole.holds(DVec3::ZERO, 4.99) && !whole.holds(DVec3::ZERO, 5.01) && !whole.holds(9.0 * DVec3::Z, 1.0));
        for direction in [DepthDirection::Standard, DepthDirection::Reversed] {
            let to_clip = camera.world_to_clip(ClipRange { near: 4.0, far: 7.0 }, direction);
            let view = SmoothingView::new(whole.eye(), to_clip, [64; 2]);
            assert!(view.holds(DVec3::ZERO, 0.99) && !view.holds(DVec3::ZERO, 1.01), "near");
            assert!(view.holds(-DVec3::Z, 0.99) && !view.holds(-DVec3::Z, 1.01), "far");
        }
    }

    #[test]
    fn pixels_are_those_of_the_camera() {
        for projection in [Projection::Perspective { fov_y_rad: 0.7 }, Projection::Orthographic { height: 3.0 }] {
            let camera =
                Camera::new(Vec3::new(1.0, 2.0, 6.0), Vec3::new(0.1, 0.0, 0.0), Vec3::Y, projection, [640, 400])
                    .unwrap();
            let view = SmoothingView::from_camera(&camera);
            for point in [DVec3::ZERO, DVec3::new(0.3, -0.4, 0.5)] {
                let (pixel, w) = view.pixel(point);
                assert!(pixel.distance(camera.project(point).unwrap().pixel) < 1e-9 && w > 0.0);
            }
            let is_perspective = matches!(projection, Projection::Perspective { .. });
            assert_eq!(view.eye().position().is_some(), is_perspective);
        }
    }
}
