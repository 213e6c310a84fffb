//! The corners of a polygon in its plane.

use glam::{DVec2, DVec3};

/// A corner of a polygon.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    /// Where it is in space, from the first corner.
    position: DVec3,
    /// Where the projection along the polygon's normal is, in the coordinate plane that the polygon is most parallel to.
    pub(super) flat: DVec2,
}

/// Replaces `points` by the projections of a polygon's corners along its normal, which must not be 0. Seen in the plane
/// the polygon runs counter-clockwise.
///
/// Along an axis the projection is exact; otherwise its rounding must not bend what is straight in space: see
/// [`orientation`].
pub(super) fn project(corners: impl Iterator<Item = DVec3>, normal: DVec3, points: &mut Vec<Point>) {
    let axis = normal.abs().max_position();
    let (right, up) = ((axis + 1) % 3, (axis + 2) % 3);
    // A coordinate plane seen from its back is seen in a mirror.
    let (right, up) = if normal[axis] > 0.0 { (right, up) } else { (up, right) };
    let slope = DVec2::new(normal[right], normal[up]) / normal[axis];
    points.clear();
    let mut origin = None;
    points.extend(corners.map(|corner| {
        let position = corner - *origin.get_or_insert(corner);
        let flat = DVec2::new(position[right], position[up]) - slope * position[axis];
        Point { position, flat }
    }));
}

/// Twice the signed area of a triangle in the plane: positive if counter-clockwise, and 0 exactly if its corners are
/// collinear in the plane or in space.
pub(super) fn orientation(a: &Point, b: &Point, c: &Point) -> f64 {
    if (b.position - a.position).cross(c.position - a.position) == DVec3::ZERO {
        return 0.0;
    }
    let [a, b, c] = [a, b, c].map(|point| robust::Coord { x: point.flat.x, y: point.flat.y });
    robust::orient2d(a, b, c)
}
