//! [`DepthLaw`]: how depths relate to values of the depth buffer.

use crate::frame_view_error::FrameViewError;
use glam::{DMat4, DVec4};
use silhouette_core::view::{ClipRange, DepthDirection};

/// The last two rows of a projection, as functions of depth: clip-space z is `slope * depth + offset`, w is `w_slope * depth`
/// in a perspective and constant otherwise; the depth buffer holds z over w.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DepthLaw {
    slope: f64,
    offset: f64,
    w_slope: f64,
    w_constant: f64,
    /// Sign of view-space z in front of the viewer.
    forward: f64,
    range: ClipRange,
    direction: DepthDirection,
}

impl DepthLaw {
    /// Reads a projection.
    ///
    /// # Errors
    /// [`FrameViewError::Projection`] where z or w depends on more than view-space z, or w on z and on a constant;
    /// [`FrameViewError::Depths`] where the depth buffer runs the other way.
    pub fn new(projection: DMat4, direction: DepthDirection) -> Result<Self, FrameViewError> {
        let (z, w) = (projection.row(2), projection.row(3));
        let depends_on_z_alone = |row: DVec4| row.x == 0.0 && row.y == 0.0;
        let is_perspective = w.z != 0.0 && w.w == 0.0;
        let is_orthographic = w.z == 0.0 && w.w > 0.0;
        if !depends_on_z_alone(z) || !depends_on_z_alone(w) || !(is_perspective || is_orthographic) {
            return Err(FrameViewError::Projection);
        }
        let grows = if direction == DepthDirection::Standard { 1.0 } else { -1.0 };
        // Values of an orthographic view tell which way is forward; a perspective has w above 0 in front.
        let forward = if is_perspective { w.z.signum() } else { (grows * z.z).signum() };
        let mut law = Self {
            slope: forward * z.z,
            offset: z.w,
            w_slope: forward * w.z,
            w_constant: w.w,
            forward,
            range: ClipRange { near: 0.0, far: 0.0 },
            direction,
        };
        let [at_zero, at_one] = [law.depth_of_value(0.0), law.depth_of_value(1.0)];
        let (near, far) = match direction {
            DepthDirection::Standard => (at_zero, at_one),
            DepthDirection::Reversed => (at_one, at_zero),
        };
        // A plane at infinity comes out with either sign.
        let far = if far.is_infinite() { far.abs() } else { far };
        let fits = near.is_finite() && far > near && (!is_perspective || near > 0.0);
        law.range = ClipRange { near, far };
        if fits && (is_perspective || far.is_finite()) { Ok(law) } else { Err(FrameViewError::Depths(direction)) }
    }

    /// Near and far plane; the far one of a perspective may be infinite.
    pub fn range(&self) -> ClipRange {
        self.range
    }

    /// Which end of the depth buffer is near.
    pub fn direction(&self) -> DepthDirection {
        self.direction
    }

    /// Whether w grows with depth.
    pub fn is_perspective(&self) -> bool {
        self.w_slope != 0.0
    }

    /// The depth of a point with this z in view space.
    pub fn depth_of_view_z(&self, z: f64) -> f64 {
        self.forward * z
    }

    /// The z in view space of a point at this depth.
    pub fn view_z_of_depth(&self, depth: f64) -> f64 {
        self.forward * depth
    }

    /// Clip-space w at a depth.
    pub fn w_at(&self, depth: f64) -> f64 {
        self.w_slope * depth + self.w_constant
    }

    /// What the depth buffer holds for a depth.
    pub fn value_at(&self, depth: f64) -> f64 {
        (self.slope * depth + self.offset) / self.w_at(depth)
    }

    /// The depth that a value of the depth buffer stands for; infinite for the value of an infinite far plane.
    pub fn depth_of_value(&self, value: f64) -> f64 {
        let [p, q, r, s] = self.depth_of_value_terms();
        (p * value + q) / (r * value + s)
    }

    /// `(p, q, r, s)`: a value v of the depth buffer stands for the depth `(p v + q) / (r v + s)`.
    pub fn depth_of_value_terms(&self) -> [f64; 4] {
        [self.w_constant, -self.offset, -self.w_slope, self.slope]
    }

    /// `(p, q, r, s)`: a value v of the depth buffer stands for the depth `(p v + q) / (r v + s)` beyond the near plane, of which 32 bits
    /// hold much more than of the depth itself where all that is seen is far away. 0 at the near plane, to the last bit.
    pub fn depth_beyond_near_terms(&self) -> [f64; 4] {
        let [p, _, r, s] = self.depth_of_value_terms();
        let nearest = match self.direction {
            DepthDirection::Standard => 0.0,
            DepthDirection::Reversed => 1.0,
        };
        let slope = p - self.range.near * r;
        [slope, -slope * nearest, r, s]
    }

    /// The row of a projection for clip-space z with another near and far plane, all else equal.
    pub fn z_row(&self, range: ClipRange) -> DVec4 {
        let (at_zero, at_one) = match self.direction {
            DepthDirection::Standard => (range.near, range.far),
            DepthDirection::Reversed => (range.far, range.near),
        };
        // z is 0 at the first and w at the second; a plane at infinity is a limit.
        let w = self.w_at(at_one);
        let (slope, offset) = if at_zero.is_infinite() {
            (0.0, w)
        } else if at_one.is_infinite() {
            (self.w_slope, -self.w_slope * at_zero)
        } else {
            let slope = w / (at_one - at_zero);
            (slope, -slope * at_zero)
        };
        DVec4::new(0.0, 0.0, self.forward * slope, offset)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use silhouette_core::view::{Camera, Projection};

    const RANGE: ClipRange = ClipRange { near: 0.5, far: 20.0 };

    fn cameras() -> [Camera; 2] {
        [Projection::Perspective { fov_y_rad: 0.8 }, Projection::Orthographic { height: 3.0 }]
            .map(|projection| Camera::new(Vec3::Z * 4.0, Vec3::ZERO, Vec3::Y, projection, [64, 48]).unwrap())
    }

    #[test]
    fn a_law_is_the_camera_s_own() {
        for camera in cameras() {
            for direction in [DepthDirection::Standard, DepthDirection::Reversed] {
                let law = DepthLaw::new(camera.clip_matrix(RANGE, direction), direction).unwrap();
                assert!((law.range().near - 0.5).abs() < 1e-12 && (law.range().far - 20.0).abs() < 1e-9, "{law:?}");
                for depth in [0.5, 3.0, 20.0] {
                    let value = law.value_at(depth);
                    assert!((camera.depth_of_buffer_value(value, RANGE, direction) - depth).abs() < 1e-9);
                    assert!((law.depth_of_value(value) - depth).abs() < 1e-9);
                }
            }
        }
    }

    #[test]
    fn a_far_plane_may_be_infinite_in_a_perspective_and_nowhere_else() {
        let infinite = ClipRange { near: 0.5, far: f64::INFINITY };
        let [perspective, orthographic] = cameras();
        for direction in [DepthDirection::Standard, DepthDirection::Reversed] {
            let law = DepthLaw::new(perspective.clip_matrix(infinite, direction), direction).unwrap();
            assert_eq!(law.range(), infinite);
            assert!((law.depth_of_value(law.value_at(1e6)) / 1e6 - 1.0).abs() < 1e-6);
            let orthographic = orthographic.clip_matrix(infinite, direction);
            assert!(!orthographic.is_finite() || DepthLaw::new(orthographic, direction).is_err());
        }
    }

    #[test]
    fn the_row_of_other_planes_is_that_of_a_camera_with_them() {
        for camera in cameras() {
            for direction in [DepthDirection::Standard, DepthDirection::Reversed] {
                let law = DepthLaw::new(camera.clip_matrix(RANGE, direction), direction).unwrap();
                for range in [RANGE, ClipRange { near: 0.25, far: 7.0 }] {
                    let expected = camera.clip_matrix(range, direction).row(2);
                    assert!((law.z_row(range) - expected).length() < 1e-12, "{camera:?} {direction:?}");
                }
            }
        }
    }

    #[test]
    fn the_wrong_direction_and_oblique_depths_are_refused() {
        let [camera, _] = cameras();
        let standard = camera.clip_matrix(RANGE, DepthDirection::Standard);
        let wrong = DepthLaw::new(standard, DepthDirection::Reversed);
        assert_eq!(wrong, Err(FrameViewError::Depths(DepthDirection::Reversed)));
        let mut oblique = standard;
        oblique.x_axis.z = 0.1;
        assert_eq!(DepthLaw::new(oblique, DepthDirection::Standard), Err(FrameViewError::Projection));
    }
}
