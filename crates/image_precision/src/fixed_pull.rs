//! Section 3.2: back faces moved towards the camera by a fixed amount t, along the viewing axis.
//!
//! A move along the axis also magnifies in a perspective: a point p pixels from the image's centre at depth z shifts
//! outwards by `p t / (z - t)` ([`radial_shift_px`]), so that lines are thicker at the image's rim and lie beside the edge
//! there. [`scale`](crate::scale) about the eye has no such shift. t is in radii of the bounding sphere: an absolute t
//! vanishes below a depth step from afar, which the renderer warns of.

use silhouette_core::view::{Camera, ClipRange, Projection};

/// View to clip space for back faces pulled by `pull` world units.
#[cfg(feature = "gpu")]
pub(crate) fn projection(view: &silhouette_gpu::FrameView, pull: f64) -> silhouette_core::glam::DMat4 {
    use silhouette_core::glam::{DMat4, DVec3};
    let toward_viewer = DVec3::Z * view.depth_law().view_z_of_depth(-pull);
    view.projection() * DMat4::from_translation(toward_viewer)
}

/// `range` with its near plane where the pull brings a point on it. In a perspective what is pulled past the eye is lost.
pub fn widened(camera: &Camera, range: ClipRange, pull: f64) -> ClipRange {
    let near = match camera.projection() {
        Projection::Perspective { .. } => (range.near - pull).max(range.near * 0.01),
        Projection::Orthographic { .. } => range.near - pull,
    };
    ClipRange { near, ..range }
}

/// How far a pull shifts a point outwards in a perspective, in pixels: `p t / (z - t)`, where p is its distance from the
/// image's centre in pixels and z its depth. 0 in an orthographic view.
pub fn radial_shift_px(from_center_px: f64, pull: f64, depth: f64) -> f64 {
    from_center_px * pull / (depth - pull)
}

#[cfg(all(test, feature = "gpu"))]
mod tests {
    use super::*;
    use silhouette_core::glam::{DVec3, Vec3};
    use silhouette_core::view::DepthDirection;
    use silhouette_gpu::FrameView;

    #[test]
    fn points_shift_outwards_as_the_law_says() {
        let projection = Projection::Perspective { fov_y_rad: 0.8 };
        let camera = Camera::new(Vec3::Z * 4.0, Vec3::ZERO, Vec3::Y, projection, [400, 400]).unwrap();
        let range = ClipRange { near: 1.0, far: 9.0 };
        let frame_view = FrameView::from_camera(&camera, range, DepthDirection::Reversed).unwrap();
        for (view, pull) in [(DVec3::new(0.7, 0.0, -3.0), 0.03), (DVec3::new(0.0, -0.4, -5.0), 0.2)] {
            let [before, after] = [0.0, pull].map(|pull| {
                let ndc = super::projection(&frame_view, pull).project_point3(view);
                200.0 * ndc.truncate().length()
            });
            assert!((after - before - radial_shift_px(before, pull, -view.z)).abs() < 1e-9);
        }
    }

    #[test]
    fn nothing_is_pulled_across_the_widened_near_plane() {
        for projection in [Projection::Perspective { fov_y_rad: 0.8 }, Projection::Orthographic { height: 3.0 }] {
            let camera = Camera::new(Vec3::Z * 4.0, Vec3::ZERO, Vec3::Y, projection, [64, 64]).unwrap();
            let widened = widened(&camera, ClipRange { near: 1.5, far: 8.0 }, 0.25);
            let view = FrameView::from_camera(&camera, widened, DepthDirection::Standard).unwrap();
            let nearest = super::projection(&view, 0.25).project_point3(DVec3::Z * -1.5);
            assert!(nearest.z > -1e-12, "{nearest}");
        }
    }
}
