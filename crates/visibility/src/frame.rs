//! [`PictureFrame`]: points and edges of a scene in homogeneous pixels, clipped before they are divided.

use silhouette_core::Camera;
use silhouette_core::glam::{DVec2, DVec3, DVec4, Vec3};
use silhouette_core::view::Projection;

/// A point before its division: pixel coordinates times `w`, `w` being the depth for a perspective and 1 otherwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Homogeneous {
    /// Pixel coordinates times `w`.
    pub scaled_pixel: DVec2,
    /// Above 0 in front of the eye.
    pub w: f64,
    /// Distance along the viewing axis.
    pub depth: f64,
}

impl Homogeneous {
    /// The pixel. Infinite or NaN where `w` is 0.
    pub fn pixel(self) -> DVec2 {
        self.scaled_pixel / self.w
    }
}

/// The part of an edge that is inside of a rectangle of the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClippedEdge {
    /// Parameters along the edge in space, 0 at its first end and 1 at its second.
    pub range: [f64; 2],
    /// Pixels at both ends of the range. Not finite where the edge passes through the eye.
    pub pixels: [DVec2; 2],
    /// By how much rounding may have moved them, in pixels; infinite where they are not finite.
    pub doubt_px: f64,
    /// Least and largest distance along the viewing axis, doubt included.
    pub depths: [f64; 2],
}

impl ClippedEdge {
    /// Length in the picture.
    pub fn length_px(&self) -> f64 {
        self.pixels[0].distance(self.pixels[1])
    }

    /// Whether another edge may cross this one in the picture. Errs to the safe side.
    #[inline]
    pub fn may_cross(&self, other: &Self) -> bool {
        let reach = self.doubt_px + other.doubt_px;
        let ([a, b], [p, q]) = (self.pixels, other.pixels);
        !(beside([a, b], [p, q], reach) || beside([p, q], [a, b], reach))
    }
}

/// Whether both points lie farther than `reach` on one side of the line through two others. Never for an infinite reach.
#[inline]
fn beside([a, b]: [DVec2; 2], points: [DVec2; 2], reach: f64) -> bool {
    let along = b - a;
    let [p, q] = points.map(|point| along.perp_dot(point - a));
    let margin = reach * (along.x.abs() + along.y.abs());
    p > margin && q > margin || p < -margin && q < -margin
}

/// Most doubt about the place of a drawn edge, in pixels.
const DRAWN_DOUBT_PX: f64 = 0.1;

/// A camera as a map to homogeneous pixels.
#[derive(Debug, Clone, Copy)]
pub struct PictureFrame {
    /// Rows that yield pixel x times w, pixel y times w, w, and depth of a world point.
    rows: [DVec4; 4],
    size: DVec2,
    /// Upper bound of the errors of the first three rows' values for points of the scene.
    error: f64,
    /// The same of the last row, whose unit is another one.
    depth_error: f64,
}

impl PictureFrame {
    /// The frame of a camera for points no farther than `reach` from the origin, on any axis.
    pub fn new(camera: &Camera, reach: f64) -> Self {
        let view = camera.view_matrix().transpose();
        let size = DVec2::from(camera.size().map(f64::from));
        let (w, scale) = match camera.projection() {
            Projection::Perspective { .. } => (-view.z_axis, camera.pixels_per_unit(1.0)),
            Projection::Orthographic { .. } => (DVec4::W, camera.pixels_per_unit(1.0)),
        };
        let (x, y) = (view.x_axis * scale + w * (size.x * 0.5), w * (size.y * 0.5) - view.y_axis * scale);
        let rows = [x, y, w, -view.z_axis];
        let error_of = |row: DVec4| (row.truncate().abs().element_sum() * reach + row.w.abs()) * 16.0 * f64::EPSILON;
        let [of_x, of_y, of_w, depth_error] = rows.map(error_of);
        Self { rows, size, error: of_x.max(of_y).max(of_w), depth_error }
    }

    /// A point of the world, undivided.
    pub fn map(&self, world: DVec3) -> Homogeneous {
        let [x, y, w, depth] = self.rows.map(|row| row.dot(world.extend(1.0)));
        Homogeneous { scaled_pixel: DVec2::new(x, y), w, depth }
    }

    /// The pixel of a point of [`clip_drawn`](Self::clip_drawn)'s part of an edge, without margin. Near to the eye rounding may move it
    /// by a tenth of a pixel, but not out of the picture.
    pub fn drawn_pixel(&self, world: DVec3) -> DVec2 {
        self.map(world).pixel().clamp(DVec2::ZERO, self.size)
    }

    /// How fast the picture of a moving point moves, in pixels.
    pub fn pixel_velocity(&self, world: DVec3, velocity: DVec3) -> DVec2 {
        let place = self.map(world);
        let [x, y, w, _] = self.rows.map(|row| row.truncate().dot(velocity));
        (DVec2::new(x, y) - place.pixel() * w) / place.w
    }

    /// Width and height in pixels.
    pub fn size(&self) -> DVec2 {
        self.size
    }

    /// The part of an edge inside the picture, grown by `margin_px` on each side, as it is drawn: without what is so near to
    /// the eye that it has no certain place in the picture. Its pixels are finite. O(1).
    pub fn clip_drawn(&self, ends: [Vec3; 2], margin_px: f64) -> Option<ClippedEdge> {
        self.clip_beyond(ends, margin_px, 0.0, self.least_w())
    }

    /// The least depth at which a point has a certain place in the picture; 0 for an orthographic camera.
    pub fn least_w(&self) -> f64 {
        let is_perspective = self.rows[2].truncate() != DVec3::ZERO;
        if is_perspective { self.error * (1.0 + self.size.max_element()) / DRAWN_DOUBT_PX } else { 0.0 }
    }

    /// The part of an edge that may be seen inside the picture, grown by `margin_px` on each side; `None` where there is
    /// certainly none. An edge that may pass through the eye may be seen anywhere. O(1).
    pub fn clip(&self, ends: [Vec3; 2], margin_px: f64) -> Option<ClippedEdge> {
        self.clip_beyond(ends, margin_px, self.error * (2.0 + margin_px + self.size.max_element()), 0.0)
    }

    /// The part beyond planes that are moved outwards by `slack`.
    fn clip_beyond(&self, ends: [Vec3; 2], margin_px: f64, slack: f64, least_w: f64) -> Option<ClippedEdge> {
        let [a, b] = ends.map(|end| self.map(end.as_dvec3()));
        let inside = |p: Homogeneous| {
            let (low, high) = (p.scaled_pixel + margin_px * p.w, (self.size + margin_px) * p.w - p.scaled_pixel);
            [low.x + slack, low.y + slack, high.x + slack, high.y + slack, p.w - least_w + slack]
        };
        let mut range = [0.0_f64, 1.0];
        for (at_a, at_b) in inside(a).into_iter().zip(inside(b)) {
            match (at_a >= 0.0, at_b >= 0.0) {
                (true, true) => {}
                (false, false) => return None,
                (false, true) => range[0] = range[0].max(at_a / (at_a - at_b)),
                (true, false) => range[1] = range[1].min(at_a / (at_a - at_b)),
            }
        }
        if range[0] >= range[1] {
            return None;
        }
        let at = |t: f64| Homogeneous {
            scaled_pixel: a.scaled_pixel.lerp(b.scaled_pixel, t),
            w: a.w + (b.w - a.w) * t,
            depth: a.depth + (b.depth - a.depth) * t,
        };
        let [from, to] = range.map(at);
        // The farther the point from the eye's plane, the less an error of the numerator shows.
        let doubt_px = self.error * (1.0 + self.size.max_element()) / from.w.min(to.w).max(f64::MIN_POSITIVE);
        let pixels = [from.pixel(), to.pixel()];
        let doubt_px = if pixels.iter().all(|pixel| pixel.is_finite()) { doubt_px } else { f64::INFINITY };
        let depths = [from.depth.min(to.depth) - self.depth_error, from.depth.max(to.depth) + self.depth_error];
        Some(ClippedEdge { range, pixels, doubt_px, depths })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An edge from the eye across the viewing axis has no place in the picture: the displaced viewer may see it anywhere.
    #[test]
    fn an_edge_through_the_eye_may_cross_any_other() {
        let eye = Vec3::new(4.0, 2.0, 2.0);
        let projection = Projection::Perspective { fov_y_rad: 1.4 };
        let camera = Camera::new(eye, Vec3::new(4.0, 0.0, 1.0), Vec3::Y, projection, [512, 512]).unwrap();
        let frame = PictureFrame::new(&camera, 6.0);
        for along in [Vec3::NEG_X, Vec3::X, Vec3::new(0.0, -1.0, 2.0)] {
            let through = frame.clip([eye + along, eye], 1.0).unwrap();
            assert!(through.doubt_px.is_infinite() || through.pixels.iter().all(|pixel| pixel.is_finite()));
            for ends in [[Vec3::new(3.0, 0.0, 0.0), Vec3::new(3.0, 0.0, 3.0)], [Vec3::ZERO, Vec3::new(6.0, 0.0, 0.0)]] {
                let other = frame.clip(ends, 1.0).unwrap();
                assert!(through.may_cross(&other) && other.may_cross(&through), "{through:?} and {other:?}");
            }
        }
    }
}
