//! [`Quadric`]: the sum of squared distances to planes, as a function of a point.
//!
//! M. Garland and P. S. Heckbert, "Surface Simplification Using Quadric Error Metrics", SIGGRAPH 1997.

use glam::{DMat3, DVec3};
use silhouette_core::glam;

/// Weight of the distance to a face's middle beside that to its plane: in flat surroundings, where planes leave the place
/// open, it keeps vertices among their neighbours.
const MIDDLE: f64 = 1e-3;

/// `p A p + 2 b p + c`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Quadric {
    square: DMat3,
    linear: DVec3,
    constant: f64,
}

impl Quadric {
    /// That of no plane.
    pub(super) const ZERO: Self = Self { square: DMat3::ZERO, linear: DVec3::ZERO, constant: 0.0 };

    /// That of a triangle's plane, weighted by its area.
    pub(super) fn of_face([a, b, c]: [DVec3; 3]) -> Self {
        let across = (b - a).cross(c - a);
        let area = across.length() * 0.5;
        let normal = across.normalize_or_zero();
        let middle = (a + b + c) / 3.0;
        let outer = DMat3::from_cols(normal * normal.x, normal * normal.y, normal * normal.z);
        let square = outer + DMat3::IDENTITY * MIDDLE;
        let linear = -(square * middle);
        Self { square: square * area, linear: linear * area, constant: -linear.dot(middle) * area }
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        Self {
            square: self.square + other.square,
            linear: self.linear + other.linear,
            constant: self.constant + other.constant,
        }
    }

    /// The weighted sum at a point.
    pub(super) fn at(&self, point: DVec3) -> f64 {
        (self.square * point + 2.0 * self.linear).dot(point) + self.constant
    }

    /// Where it is smallest; `None` where rounding leaves that open.
    pub(super) fn lowest(&self) -> Option<DVec3> {
        let place = -(self.square.inverse() * self.linear);
        place.is_finite().then_some(place)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_corner_of_three_planes_is_lowest() {
        let corner = DVec3::new(0.3, 0.2, 0.1);
        let face = |u: DVec3, v: DVec3| Quadric::of_face([corner, corner + u, corner + v]);
        let all = face(DVec3::X, DVec3::Y).plus(&face(DVec3::Y, DVec3::Z)).plus(&face(DVec3::Z, DVec3::X));
        assert!(all.lowest().unwrap().distance(corner) < 3.0 * MIDDLE);
        assert!(all.at(corner) < 3.0 * MIDDLE && all.at(corner + DVec3::splat(0.1)) > 0.01);
        assert!((all.at(corner + DVec3::X) - 0.5).abs() < 0.01, "{}", all.at(corner + DVec3::X));
        assert!(Quadric::ZERO.lowest().is_none());
    }
}
