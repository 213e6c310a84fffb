//! A camera: a viewpoint with a projection and a viewport.

use super::{ViewError, Viewpoint};
use crate::mesh::Bounds;
use glam::{DMat4, DVec2, DVec3, DVec4, Vec3};

/// How a camera maps view space to its viewport.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Projection {
    /// Through the eye.
    Perspective {
        /// Vertical field of view in radians, between 0 and pi, both excluded.
        fov_y_rad: f64,
    },
    /// Along the viewing axis.
    Orthographic {
        /// World units from the top to the bottom of the viewport, above 0.
        height: f64,
    },
}

/// Largest width and height of a viewport: what WebGPU adapters offer at most.
pub const MAX_VIEWPORT: u32 = 16_384;

/// Depths between which a camera draws.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClipRange {
    /// Depth of the near plane, above 0 for a perspective.
    pub near: f64,
    /// Depth of the far plane, beyond `near`; a perspective's may be infinite.
    pub far: f64,
}

/// Which end of the depth buffer is near.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum DepthDirection {
    /// Near is 0, far is 1, the test is "less".
    Standard,
    /// Near is 1, far is 0, the test is "greater": with a float buffer, precision hardly depends on `near`.
    #[default]
    Reversed,
}

/// A point as a camera sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Projected {
    /// Pixel coordinates.
    pub pixel: DVec2,
    /// Depth: distance along the viewing axis, in world units.
    pub depth: f64,
}

/// A viewpoint with a projection and a viewport. Valid by construction.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Camera {
    eye: Vec3,
    target: Vec3,
    up: Vec3,
    projection: Projection,
    size: [u32; 2],
}

/// Nearest near plane as a share of the far plane. With a reversed 32-bit float buffer a depth step stays below 1e-6 of
/// the depth at this ratio; farther in, 16-bit and 24-bit buffers lose the whole scene.
const MIN_NEAR_TO_FAR: f64 = 1e-5;

impl Camera {
    /// A camera at `eye` looking at `target`, with `up` pointing to the top of a viewport of `size` pixels (width,
    /// height).
    ///
    /// # Errors
    /// [`ViewError`] where the parts do not make a camera.
    pub fn new(eye: Vec3, target: Vec3, up: Vec3, projection: Projection, size: [u32; 2]) -> Result<Self, ViewError> {
        if !(eye.is_finite() && target.is_finite() && up.is_finite()) {
            return Err(ViewError::NotFinite);
        }
        let direction = target.as_dvec3() - eye.as_dvec3();
        let direction = direction.try_normalize().ok_or(ViewError::NoDirection)?;
        let up_direction = up.as_dvec3().try_normalize().ok_or(ViewError::NoUp)?;
        if direction.cross(up_direction).length_squared() < 1e-16 {
            return Err(ViewError::NoUp);
        }
        let projection_is_valid = match projection {
            Projection::Perspective { fov_y_rad } => fov_y_rad > 0.0 && fov_y_rad < std::f64::consts::PI,
            Projection::Orthographic { height } => height > 0.0 && height.is_finite(),
        };
        if !projection_is_valid {
            return Err(ViewError::Projection);
        }
        if size.iter().any(|&side| side == 0 || side > MAX_VIEWPORT) {
            return Err(ViewError::Viewport);
        }
        Ok(Self { eye, target, up, projection, size })
    }

    /// A camera that looks at the centre of `bounds` from `direction` (object towards viewer) and sees all of the
    /// bounding sphere, with `margin` of the viewport's smaller side left free around it.
    ///
    /// # Errors
    /// [`ViewError`] where the parts do not make a camera.
    pub fn framing(
        bounds: &Bounds,
        direction: DVec3,
        up: Vec3,
        fov: Framing,
        size: [u32; 2],
    ) -> Result<Self, ViewError> {
        let direction = direction.try_normalize().ok_or(ViewError::NoDirection)?;
        let radius = bounds.radius.max(f64::from(f32::MIN_POSITIVE)) * (1.0 + FRAMING_MARGIN);
        let aspect = f64::from(size[0].max(1)) / f64::from(size[1].max(1));
        let (projection, distance) = match fov {
            Framing::Perspective { fov_y_rad } => {
                let half_y = fov_y_rad * 0.5;
                let half_x = (half_y.tan() * aspect).atan();
                (Projection::Perspective { fov_y_rad }, radius / half_y.min(half_x).sin())
            }
            Framing::Orthographic => {
                (Projection::Orthographic { height: 2.0 * radius / aspect.min(1.0) }, 3.0 * radius)
            }
        };
        let eye = (bounds.center + direction * distance).as_vec3();
        if up.is_finite() && !eye.is_finite() {
            return Err(ViewError::TooLarge);
        }
        Self::new(eye, bounds.center.as_vec3(), up, projection, size)
    }

    /// The same camera with another viewport.
    ///
    /// # Errors
    /// [`ViewError::Viewport`].
    pub fn with_size(self, size: [u32; 2]) -> Result<Self, ViewError> {
        Self::new(self.eye, self.target, self.up, self.projection, size)
    }

    /// What facing depends on: the eye, or for an orthographic camera the direction `eye - target`.
    pub fn viewpoint(&self) -> Viewpoint {
        match self.projection {
            Projection::Perspective { .. } => Viewpoint::Perspective { eye: self.eye },
            Projection::Orthographic { .. } => Viewpoint::Orthographic { toward_viewer: self.eye - self.target },
        }
    }

    /// The eye, in world space.
    pub fn eye(&self) -> Vec3 {
        self.eye
    }

    /// The point looked at, in world space.
    pub fn target(&self) -> Vec3 {
        self.target
    }

    /// The direction that points to the top of the viewport.
    pub fn up(&self) -> Vec3 {
        self.up
    }

    /// The projection.
    pub fn projection(&self) -> Projection {
        self.projection
    }

    /// Width and height of the viewport in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Viewport width over height.
    pub fn aspect(&self) -> f64 {
        f64::from(self.size[0]) / f64::from(self.size[1])
    }

    /// World to view space.
    pub fn view_matrix(&self) -> DMat4 {
        let back = (self.eye.as_dvec3() - self.target.as_dvec3()).normalize();
        let right = self.up.as_dvec3().cross(back).normalize();
        let rotation = glam::DMat3::from_cols(right, back.cross(right), back).transpose();
        DMat4::from_mat3(rotation) * DMat4::from_translation(-self.eye.as_dvec3())
    }

    /// View to clip space. The far plane of a perspective may be infinite; that of an orthographic view must be finite.
    pub fn clip_matrix(&self, range: ClipRange, direction: DepthDirection) -> DMat4 {
        let (at_zero, at_one) = match direction {
            DepthDirection::Standard => (range.near, range.far),
            DepthDirection::Reversed => (range.far, range.near),
        };
        // Depth d maps to 0 at `at_zero` and to 1 at `at_one`.
        let columns = match self.projection {
            Projection::Perspective { fov_y_rad } => {
                let focal = 1.0 / (fov_y_rad * 0.5).tan();
                // A plane at infinity is the limit of one that moves away.
                let (scale, shift) = if at_zero.is_infinite() {
                    (0.0, at_one)
                } else if at_one.is_infinite() {
                    (-1.0, -at_zero)
                } else {
                    let scale = at_one / (at_zero - at_one);
                    (scale, scale * at_zero)
                };
                [
                    [focal / self.aspect(), 0.0, 0.0, 0.0],
                    [0.0, focal, 0.0, 0.0],
                    [0.0, 0.0, scale, -1.0],
                    [0.0, 0.0, shift, 0.0],
                ]
            }
            Projection::Orthographic { height } => {
                let focal = 2.0 / height;
                let scale = 1.0 / (at_zero - at_one);
                [
                    [focal / self.aspect(), 0.0, 0.0, 0.0],
                    [0.0, focal, 0.0, 0.0],
                    [0.0, 0.0, scale, 0.0],
                    [0.0, 0.0, scale * at_zero, 1.0],
                ]
            }
        };
        DMat4::from_cols_array_2d(&columns)
    }

    /// World to clip space.
    pub fn world_to_clip(&self, range: ClipRange, direction: DepthDirection) -> DMat4 {
        self.clip_matrix(range, direction) * self.view_matrix()
    }

    /// Depths that hold all of `bounds` that a perspective can show: tight around the bounding sphere, the near plane
    /// never closer than 1e-5 of the far plane.
    pub fn clip_range(&self, bounds: &Bounds) -> ClipRange {
        let depth = -self.view_matrix().transform_point3(bounds.center).z;
        let reach = (bounds.radius * 1.01).max(depth.abs() * 1e-6).max(f64::from(f32::MIN_POSITIVE));
        match self.projection {
            Projection::Perspective { .. } => {
                let far = (depth + reach).max(reach);
                ClipRange { near: (depth - reach).max(far * MIN_NEAR_TO_FAR), far }
            }
            Projection::Orthographic { .. } => ClipRange { near: depth - reach, far: depth + reach },
        }
    }

    /// Pixels that a world unit covers at `depth`, across the viewing axis.
    pub fn pixels_per_unit(&self, depth: f64) -> f64 {
        let height_px = f64::from(self.size[1]);
        match self.projection {
            Projection::Perspective { fov_y_rad } => height_px * 0.5 / ((fov_y_rad * 0.5).tan() * depth),
            Projection::Orthographic { height } => height_px / height,
        }
    }

    /// Where a point of view space appears. For a perspective, depth must be above 0: clip first.
    pub fn view_to_pixel(&self, view: DVec3) -> Projected {
        let depth = -view.z;
        let scale = self.pixels_per_unit(depth);
        let center = DVec2::new(f64::from(self.size[0]), f64::from(self.size[1])) * 0.5;
        Projected { pixel: center + DVec2::new(view.x, -view.y) * scale, depth }
    }

    /// Where a point of world space appears; `None` behind the eye of a perspective. The point may lie outside of the
    /// viewport.
    pub fn project(&self, world: DVec3) -> Option<Projected> {
        let view = self.view_matrix().transform_point3(world);
        let behind = matches!(self.projection, Projection::Perspective { .. }) && -view.z <= 0.0;
        (!behind).then(|| self.view_to_pixel(view))
    }

    /// The depth that a depth-buffer value stands for: inverse of [`clip_matrix`](Self::clip_matrix).
    pub fn depth_of_buffer_value(&self, value: f64, range: ClipRange, direction: DepthDirection) -> f64 {
        let view = self.clip_matrix(range, direction).inverse() * DVec4::new(0.0, 0.0, value, 1.0);
        -view.z / view.w
    }
}

/// How [`Camera::framing`] projects.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Framing {
    /// Moves the eye until the mesh fits.
    Perspective {
        /// Vertical field of view in radians.
        fov_y_rad: f64,
    },
    /// Chooses the height until the mesh fits.
    Orthographic,
}

/// Share of the bounding sphere's radius that [`Camera::framing`] leaves free around it: enough for a thick pen.
pub const FRAMING_MARGIN: f64 = 0.05;

#[cfg(test)]
mod tests {
    use super::*;

    const RANGE: ClipRange = ClipRange { near: 0.5, far: 20.0 };

    fn cameras() -> [Camera; 2] {
        let make = |projection| {
            Camera::new(Vec3::new(3.0, 2.0, 5.0), Vec3::new(0.2, 0.1, 0.0), Vec3::Y, projection, [640, 480]).unwrap()
        };
        [make(Projection::Perspective { fov_y_rad: 0.8 }), make(Projection::Orthographic { height: 3.0 })]
    }

    #[test]
    fn clip_space_and_pixels_agree() {
        for camera in cameras() {
            for direction in [DepthDirection::Standard, DepthDirection::Reversed] {
                let world = DVec3::new(0.4, -0.3, 0.7);
                let seen = camera.project(world).unwrap();
                let clip = camera.world_to_clip(RANGE, direction) * world.extend(1.0);
                let ndc = clip.truncate() / clip.w;
                let pixel = DVec2::new((ndc.x + 1.0) * 320.0, (1.0 - ndc.y) * 240.0);
                assert!(pixel.distance(seen.pixel) < 1e-9, "{pixel} {}", seen.pixel);
                let depth = camera.depth_of_buffer_value(ndc.z, RANGE, direction);
                assert!((depth - seen.depth).abs() < 1e-9, "{depth} {}", seen.depth);
            }
        }
    }

    #[test]
    fn an_infinite_far_plane_is_the_limit_of_a_far_one() {
        let [camera, _] = cameras();
        for direction in [DepthDirection::Standard, DepthDirection::Reversed] {
            let [infinite, far] = [f64::INFINITY, 1e12].map(|far| {
                let clip = camera.clip_matrix(ClipRange { near: 0.5, far }, direction);
                [0.5, 3.0, 1e3].map(|depth| clip.project_point3(DVec3::new(0.1, 0.2, -depth)))
            });
            for (infinite, far) in infinite.into_iter().zip(far) {
                assert!((infinite - far).length() < 1e-11, "{direction:?}: {infinite} {far}");
            }
        }
    }

    #[test]
    fn depth_directions_run_from_near_to_far() {
        for camera in cameras() {
            let value = |depth: f64, direction| {
                let clip = camera.clip_matrix(RANGE, direction) * DVec4::new(0.0, 0.0, -depth, 1.0);
                clip.z / clip.w
            };
            assert!((value(0.5, DepthDirection::Standard)).abs() < 1e-12);
            assert!((value(20.0, DepthDirection::Standard) - 1.0).abs() < 1e-12);
            assert!((value(0.5, DepthDirection::Reversed) - 1.0).abs() < 1e-12);
            assert!((value(20.0, DepthDirection::Reversed)).abs() < 1e-12);
        }
    }

    #[test]
    fn framing_shows_the_whole_sphere_in_any_aspect() {
        let bounds = Bounds { min: DVec3::splat(4.0), max: DVec3::splat(6.0), center: DVec3::splat(5.0), radius: 1.5 };
        for size in [[100, 100], [300, 100], [100, 300]] {
            for fov in [Framing::Perspective { fov_y_rad: 0.7 }, Framing::Orthographic] {
                let camera = Camera::framing(&bounds, DVec3::new(1.0, 2.0, 3.0), Vec3::Y, fov, size).unwrap();
                for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
                    for sign in [-1.0, 1.0] {
                        let p = camera.project(bounds.center + axis * sign * bounds.radius).unwrap().pixel;
                        assert!(
                            p.x > 0.0 && p.y > 0.0 && p.x < f64::from(size[0]) && p.y < f64::from(size[1]),
                            "{p} in {size:?}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn impossible_cameras_are_refused() {
        let new =
            |eye, up, fov_y_rad, size| Camera::new(eye, Vec3::ZERO, up, Projection::Perspective { fov_y_rad }, size);
        assert_eq!(new(Vec3::ZERO, Vec3::Y, 0.7, [8, 8]), Err(ViewError::NoDirection));
        assert_eq!(new(Vec3::Y, Vec3::Y, 0.7, [8, 8]), Err(ViewError::NoUp));
        assert_eq!(new(Vec3::X, Vec3::Y, 3.2, [8, 8]), Err(ViewError::Projection));
        assert_eq!(new(Vec3::X, Vec3::Y, 0.7, [0, 8]), Err(ViewError::Viewport));
        assert_eq!(new(Vec3::splat(f32::NAN), Vec3::Y, 0.7, [8, 8]), Err(ViewError::NotFinite));
    }
}
