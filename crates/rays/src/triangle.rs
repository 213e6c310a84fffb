//! Faces near a triangle.

use crate::mesh_hierarchy::MeshHierarchy;
use obvhs::aabb::Aabb;
use silhouette_core::FaceId;
use silhouette_core::glam::{DVec3, Vec3, Vec3A};

/// Share by which boxes are grown, of the largest coordinate and of the largest terms of the triangle's normal: a hundred times the rounding
/// of the operations below.
const GROWTH: f64 = 1.0 / (1_u64 << 46) as f64;

impl MeshHierarchy {
    /// Visits every face that a triangle meets or touches, and others whose boxes meet that of the triangle, with their corners, until
    /// `visit` yields `true`. Of a large triangle these are the faces near its plane. Expected O(log F + faces visited).
    pub fn near_triangle(&self, corners: [Vec3; 3], mut visit: impl FnMut(FaceId, [Vec3; 3]) -> bool) {
        let triangle = Triangle::new(corners);
        self.walk(
            |aabb| triangle.meets_box(aabb.min, aabb.max) && triangle.may_meet_in_plane(aabb),
            |place| {
                let [a, b, c] = self.corners[place].map(Vec3A::from);
                triangle.meets_box(a.min(b).min(c), a.max(b).max(c)) && visit(self.faces[place], self.corners[place])
            },
        );
    }
}

struct Triangle {
    min: Vec3A,
    max: Vec3A,
    corner: DVec3,
    normal: DVec3,
    /// Sums of the sizes of the terms whose differences make up the normal.
    terms: DVec3,
}

impl Triangle {
    fn new(corners: [Vec3; 3]) -> Self {
        let [min, max] = [corners.into_iter().reduce(Vec3::min), corners.into_iter().reduce(Vec3::max)];
        let [min, max] = [min, max].map(|corner| corner.unwrap_or_default().into());
        let [corner, b, c] = corners.map(Vec3::as_dvec3);
        let (one, other) = (b - corner, c - corner);
        let (u, v) = (one.abs(), other.abs());
        let terms = DVec3::new(u.y * v.z + u.z * v.y, u.z * v.x + u.x * v.z, u.x * v.y + u.y * v.x);
        Self { min, max, corner, normal: one.cross(other), terms }
    }

    fn meets_box(&self, min: Vec3A, max: Vec3A) -> bool {
        min.cmple(self.max).all() && self.min.cmple(max).all()
    }

    /// `false` only if a box lies on one side of the triangle's plane.
    fn may_meet_in_plane(&self, aabb: &Aabb) -> bool {
        let [min, max] = [aabb.min, aabb.max].map(Vec3A::as_dvec3);
        let largest = aabb.min.abs().max(aabb.max.abs()).max(self.min.abs()).max(self.max.abs()).max_element();
        let height = self.normal.dot(self.corner - (min + max) * 0.5).abs();
        let reach = self.normal.abs().dot((max - min) * 0.5);
        height <= reach + self.terms.element_sum() * (f64::from(largest) * GROWTH)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::segment::tests::placing;
    use proptest::prelude::*;
    use silhouette_core::shapes;
    use silhouette_testing::edits;
    use silhouette_testing::strategies::soup;

    fn visited(hierarchy: &MeshHierarchy, corners: [Vec3; 3]) -> Vec<usize> {
        let mut visited = Vec::new();
        hierarchy.near_triangle(corners, |face, _| {
            visited.push(face.index());
            false
        });
        visited
    }

    /// A large triangle beside a sphere, the box of which holds an eighth of it, and one that cuts the sphere.
    #[test]
    fn few_faces_are_near_a_large_triangle() {
        let ball = shapes::by_name("icosphere:5").unwrap();
        let hierarchy = MeshHierarchy::new(&ball);
        let across = |far: f32| [far * Vec3::X, far * Vec3::Y, far * Vec3::Z];
        assert!(visited(&hierarchy, across(3.0)).is_empty());
        let cut = visited(&hierarchy, across(1.5)).len();
        assert!((100..1000).contains(&cut), "{cut} of {}", ball.face_count());
    }

    proptest! {
        /// Triangles with a side through a point of each face: a corner, the middle of a side, a point inside. Many lie in the face's
        /// plane, or have no area.
        #[test]
        fn no_face_that_a_triangle_touches_is_missing(
            mesh in soup(30), from in prop::array::uniform3(-9_i8..=9), third in prop::array::uniform3(-9_i8..=9),
            weights in prop::array::uniform3(0_u8..3), exponent in -60..60, is_far in any::<bool>(),
        ) {
            let place = placing(exponent, is_far);
            let placed = edits::mapped(&mesh, |position| place(position.as_dvec3()));
            let hierarchy = MeshHierarchy::new(&placed);
            let sum = f64::from(weights.iter().map(|&weight| u32::from(weight)).sum::<u32>());
            prop_assume!([1.0, 2.0, 3.0, 4.0, 6.0].contains(&sum));
            let [from, third] = [from, third].map(|corner| DVec3::from(corner.map(f64::from)));
            for (face, triangle) in mesh.triangles().iter().enumerate() {
                let corner = |slot: usize| mesh.positions()[triangle[slot] as usize].as_dvec3() * f64::from(weights[slot]);
                let on_face = (corner(0) + corner(1) + corner(2)) / sum;
                let of_face = corner(0) - corner(1) + from;
                for third in [third, of_face] {
                    let corners = [from, 2.0 * on_face - from, third].map(place);
                    prop_assert!(visited(&hierarchy, corners).contains(&face));
                }
            }
        }
    }
}
