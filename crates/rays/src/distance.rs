//! Distance from a point to a mesh, by branch and bound (N. Roussopoulos, S. Kelley and F. Vincent, "Nearest Neighbor
//! Queries", SIGMOD 1995).
//!
//! All in 64-bit arithmetic on differences of coordinates, so that neither the unit of length nor the distance to the origin
//! matters. Distances are relative to faces as point sets: the mesh may be open, non-manifold or without area.

use crate::mesh_hierarchy::MeshHierarchy;
use obvhs::aabb::Aabb;
use silhouette_core::FaceId;
use silhouette_core::glam::{DVec3, Vec3};

/// The point of a mesh that is nearest to another point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// Its face; of several at the same distance, the lowest.
    pub face: FaceId,
    /// The point of that face.
    pub place: DVec3,
    /// Distance in object units.
    pub distance: f64,
}

/// A box is left out only if it is certainly farther away than the best face, despite rounding: equal distances are then
/// decided by face ids, not by the shape of the hierarchy.
const CERTAINLY: f64 = 1.0 + 1e-12;

impl MeshHierarchy {
    /// The nearest point of the mesh; `None` without faces, or if none is closer than `within`. Expected O(log F).
    pub fn nearest(&self, point: DVec3, within: f64) -> Option<Nearest> {
        let mut best: Option<Nearest> = None;
        let mut reach = within * within;
        self.visit_near_first(point, reach, |corners, face| {
            let place = nearest_on_face(corners, point);
            let squared = place.distance_squared(point);
            if squared < reach || squared <= reach && best.is_some_and(|best| face < best.face) {
                reach = squared;
                best = Some(Nearest { face, place, distance: squared.sqrt() });
            }
            reach
        });
        best
    }

    /// Whether the mesh comes closer to a point than `distance`. Expected O(log F), and less where it does.
    pub fn is_within(&self, point: DVec3, distance: f64) -> bool {
        let reach = distance * distance;
        let mut is_within = false;
        self.visit_near_first(point, reach, |corners, _| {
            is_within |= nearest_on_face(corners, point).distance_squared(point) < reach;
            if is_within { NOTHING } else { reach }
        });
        is_within
    }

    /// Visits faces whose boxes come within a distance, of which `visit` yields the square that counts from then on.
    fn visit_near_first(&self, point: DVec3, mut reach: f64, mut visit: impl FnMut([Vec3; 3], FaceId) -> f64) {
        let nodes = &self.bvh.nodes;
        let mut waiting = Vec::with_capacity(64);
        waiting.extend(nodes.first().map(|root| (distance_squared(&root.aabb, point), 0_u32)));
        while let Some((squared, index)) = waiting.pop() {
            if squared > reach * CERTAINLY {
                continue;
            }
            let node = &nodes[index as usize];
            if let Some(places) = Self::places(node) {
                for place in places {
                    reach = visit(self.corners[place], self.faces[place]);
                }
            } else {
                let children = [node.first_index, node.first_index + 1];
                let [one, other] = children.map(|child| (distance_squared(&nodes[child as usize].aabb, point), child));
                let (near, far) = if one.0 <= other.0 { (one, other) } else { (other, one) };
                waiting.extend([far, near]);
            }
        }
    }
}

/// A reach that ends the search.
const NOTHING: f64 = -1.0;

fn distance_squared(aabb: &Aabb, point: DVec3) -> f64 {
    let (min, max) = (aabb.min.as_dvec3(), aabb.max.as_dvec3());
    (min - point).max(point - max).max(DVec3::ZERO).length_squared()
}

/// The point of a triangle nearest to another point. A triangle without area is the longest of its sides.
fn nearest_on_face(corners: [Vec3; 3], point: DVec3) -> DVec3 {
    // Relative to the point, whose nearest neighbour then is that of the origin.
    let [a, b, c] = corners.map(|corner| corner.as_dvec3() - point);
    let normal = (b - a).cross(c - a);
    let area = normal.length_squared();
    let is_above = |from: DVec3, to: DVec3| normal.dot((to - from).cross(from)) <= 0.0;
    if area > 0.0 && is_above(a, b) && is_above(b, c) && is_above(c, a) {
        return point + normal * (normal.dot(a) / area);
    }
    let sides = [(a, b), (b, c), (c, a)].map(|(from, to)| nearest_on_side(from, to));
    let nearer = |one: DVec3, other: DVec3| if other.length_squared() < one.length_squared() { other } else { one };
    point + nearer(nearer(sides[0], sides[1]), sides[2])
}

/// The point of a segment nearest to the origin.
fn nearest_on_side(from: DVec3, to: DVec3) -> DVec3 {
    let along = to - from;
    let length = along.length_squared();
    let t = if length > 0.0 { (-from.dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
    from + t * along
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use silhouette_core::TriangleMesh;
    use silhouette_testing::strategies::soup;
    use silhouette_testing::{edits, zoo};

    #[test]
    fn a_face_is_nearest_in_its_inside_at_its_sides_and_at_its_corners() {
        let corners = [Vec3::ZERO, Vec3::X * 2.0, Vec3::Y * 2.0];
        for (point, place) in [
            ([0.5, 0.5, 3.0], [0.5, 0.5, 0.0]),
            ([0.5, 0.5, -3.0], [0.5, 0.5, 0.0]),
            ([1.0, -2.0, 1.0], [1.0, 0.0, 0.0]),
            ([2.0, 2.0, 1.0], [1.0, 1.0, 0.0]),
            ([-1.0, -1.0, 0.0], [0.0, 0.0, 0.0]),
            ([5.0, -1.0, 2.0], [2.0, 0.0, 0.0]),
        ] {
            let found = nearest_on_face(corners, DVec3::from(point));
            assert!(found.distance(DVec3::from(place)) < 1e-15, "{point:?}: {found}");
        }
        let line = [Vec3::ZERO, Vec3::X, Vec3::X * 3.0];
        assert_eq!(nearest_on_face(line, DVec3::new(2.0, 1.0, 0.0)), DVec3::X * 2.0);
        assert_eq!(nearest_on_face([Vec3::X; 3], DVec3::ZERO), DVec3::X);
    }

    #[test]
    fn no_mesh_is_near_where_there_is_none() {
        let nothing = MeshHierarchy::new(&zoo::empty());
        assert_eq!(nothing.nearest(DVec3::ZERO, f64::INFINITY), None);
        assert!(!nothing.is_within(DVec3::ZERO, f64::INFINITY));
    }

    /// Each face in turn, without a hierarchy.
    fn by_brute_force(mesh: &TriangleMesh, point: DVec3) -> Option<(f64, usize)> {
        let distances = mesh.triangles().iter().enumerate().map(|(face, triangle)| {
            let corners = triangle.map(|vertex| mesh.positions()[vertex as usize]);
            (nearest_on_face(corners, point).distance_squared(point), face)
        });
        distances.min_by(|a, b| a.partial_cmp(b).unwrap()).map(|(squared, face)| (squared.sqrt(), face))
    }

    proptest! {
        /// In any unit of length and far from the origin.
        #[test]
        fn the_nearest_face_is_that_of_brute_force(
            mesh in soup(40), point in prop::array::uniform3(-5_i8..=5), exponent in -60..60, is_far in any::<bool>(),
        ) {
            let offset = if is_far { DVec3::new(1e6, 2e6, -1e6) } else { DVec3::ZERO };
            let scale = 2.0_f64.powi(exponent);
            let mesh = edits::transformed(&mesh, scale, offset * scale);
            let point = (DVec3::from(point.map(f64::from)) + offset) * scale;
            let hierarchy = MeshHierarchy::new(&mesh);
            let found = hierarchy.nearest(point, f64::INFINITY).map(|nearest| (nearest.distance, nearest.face.index()));
            prop_assert_eq!(found, by_brute_force(&mesh, point));
            if let Some((distance, _)) = found {
                prop_assert!(hierarchy.nearest(point, distance * 0.999).is_none());
                prop_assert!(!hierarchy.is_within(point, distance * 0.999));
                prop_assert!(hierarchy.is_within(point, distance * 1.001 + scale * 1e-9));
            }
        }
    }
}
