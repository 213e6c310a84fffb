//! Section 3.2, first way of the z-scaled translation: back faces scaled about the eye by k.
//!
//! Scaling about the eye moves no point in the image. So only the depth that is written changes: x, y and w of clip space
//! stay the same bits, and the same pixels are covered. The width follows the shape ([`rim_width`], [`wedge_width`]).
//!
//! An orthographic view has no eye to scale about. There, back faces are pulled along the axis by 1 - k of the depth of the
//! mesh's middle; the paper does not say.

use silhouette_core::view::{ClipRange, Projection};

/// View to clip space for back faces scaled by `k`, of a mesh whose middle is at `middle_depth`.
///
/// In perspective the depth buffer holds A + B / d for a depth d, as z = A d + B over w = d. At k d that is A + B / (k d):
/// B becomes B / k over the same w. In orthographic views it holds A d + B over a constant w, and a pull p takes away A p.
#[cfg(feature = "gpu")]
pub(crate) fn projection(view: &silhouette_gpu::FrameView, k: f64, middle_depth: f64) -> silhouette_core::glam::DMat4 {
    let mut projection = view.projection();
    if view.is_perspective() {
        projection.w_axis.z /= k;
    } else {
        projection.w_axis.z += projection.z_axis.z * view.depth_law().view_z_of_depth(-(1.0 - k) * middle_depth);
    }
    projection
}

/// `range` with its near plane where scaling brings a point on it; the mesh lies in the middle of `range`.
pub fn widened(projection: Projection, range: ClipRange, k: f64) -> ClipRange {
    let middle = 0.5 * (range.near + range.far);
    ClipRange { near: range.near - pull_at(projection, range.near, middle, k), ..range }
}

/// How far scaling by `k` brings a point at a depth nearer to the viewer, in world units, for a mesh whose middle is at
/// `middle_depth`.
pub fn pull_at(projection: Projection, depth: f64, middle_depth: f64, k: f64) -> f64 {
    match projection {
        Projection::Perspective { .. } => (1.0 - k) * depth,
        Projection::Orthographic { .. } => (1.0 - k) * middle_depth,
    }
}

/// Width of the ink on a smooth rim, in world units across the view, for a pull in world units and the surface's radius
/// of curvature along the view: `pull² / (8 radius)`.
///
/// At a distance w inside the rim, front and back of the surface are `2 sqrt(2 radius w)` apart; ink shows where the pull
/// is more. So the width falls with the square of the pull: on a sphere of radius 1 at a distance of 3, k = 0.99 pulls
/// by 0.027 and leaves 9e-5, far below a pixel of most images; k = 0.95 pulls by 0.13 and leaves 2e-3. Holds for pulls
/// well below the radius.
pub fn rim_width(pull: f64, radius: f64) -> f64 {
    pull * pull / (8.0 * radius)
}

/// Width of the ink at a crease, in world units across the view: `pull / (b - a)` for inward depth slopes a of the front
/// face and b > a of the back face.
pub fn wedge_width(pull: f64, front_slope: f64, back_slope: f64) -> f64 {
    pull / (back_slope - front_slope)
}

#[cfg(all(test, feature = "gpu"))]
mod tests {
    use super::*;
    use silhouette_core::glam::{DVec3, Vec3};
    use silhouette_core::view::{Camera, DepthDirection};
    use silhouette_gpu::FrameView;

    const RANGE: ClipRange = ClipRange { near: 1.5, far: 8.0 };
    const MIDDLE: f64 = 4.75;

    fn cameras() -> [Camera; 2] {
        [Projection::Perspective { fov_y_rad: 0.9 }, Projection::Orthographic { height: 3.0 }]
            .map(|projection| Camera::new(Vec3::Z * 4.0, Vec3::ZERO, Vec3::Y, projection, [64, 48]).unwrap())
    }

    /// Where scaling puts a point of view space.
    fn pulled(projection: Projection, view: DVec3, k: f64) -> DVec3 {
        match projection {
            Projection::Perspective { .. } => view * k,
            Projection::Orthographic { .. } => view + DVec3::Z * pull_at(projection, -view.z, MIDDLE, k),
        }
    }

    #[test]
    fn the_matrix_does_to_the_depth_buffer_what_scaling_does_to_the_point() {
        for camera in cameras() {
            for direction in [DepthDirection::Standard, DepthDirection::Reversed] {
                let frame_view = FrameView::from_camera(&camera, RANGE, direction).unwrap();
                for k in [1.0, 0.99, 0.6] {
                    for view in [DVec3::new(0.3, -0.2, -2.0), DVec3::new(-1.0, 0.4, -7.5)] {
                        let ours = projection(&frame_view, k, MIDDLE).project_point3(view);
                        let scaled = pulled(camera.projection(), view, k);
                        let scaled = frame_view.projection().project_point3(scaled);
                        assert!((ours - scaled).length() < 1e-12, "{direction:?} {k}: {ours} {scaled}");
                    }
                }
            }
        }
    }

    #[test]
    fn nothing_is_pulled_across_the_widened_near_plane() {
        for projection in cameras().map(|camera| camera.projection()) {
            let nearest = pulled(projection, DVec3::new(0.0, 0.0, -RANGE.near), 0.7);
            assert!((widened(projection, RANGE, 0.7).near + nearest.z).abs() < 1e-12);
        }
    }

    #[test]
    fn the_rim_is_as_wide_as_where_the_pull_closes_the_gap() {
        // Exact for a sphere in an orthographic view: half the pull is the depth of the front at the strip's inner end.
        let (radius, pull) = (2.0_f64, 0.1_f64);
        let exact = radius - (radius * radius - 0.25 * pull * pull).sqrt();
        assert!((rim_width(pull, radius) / exact - 1.0).abs() < 1e-3);
        assert!((wedge_width(0.1, -0.5, 1.5) - 0.05).abs() < 1e-12);
    }
}
