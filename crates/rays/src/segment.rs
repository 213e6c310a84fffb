//! Faces near a segment.

use crate::mesh_hierarchy::MeshHierarchy;
use obvhs::aabb::Aabb;
use silhouette_core::FaceId;
use silhouette_core::glam::{DVec3, Vec3};

/// Share of the largest coordinate by which boxes are grown: far above the rounding of the few 64-bit operations below, far
/// below the spacing of 32-bit floats.
const GROWTH: f64 = 1.0 / (1_u64 << 46) as f64;

impl MeshHierarchy {
    /// Visits every face that a segment meets or touches, and others whose boxes it meets, with their corners. Expected
    /// O(log F + faces visited).
    pub fn near_segment(&self, ends: [Vec3; 2], mut visit: impl FnMut(FaceId, [Vec3; 3])) {
        let segment = Segment::new(ends);
        self.walk(
            |aabb| segment.may_meet(aabb),
            |place| {
                visit(self.faces[place], self.corners[place]);
                false
            },
        );
    }
}

/// A segment by its middle and half of its extent.
struct Segment {
    middle: DVec3,
    half: DVec3,
    reach: f64,
}

impl Segment {
    fn new(ends: [Vec3; 2]) -> Self {
        let reach = ends.map(|end| f64::from(end.abs().max_element()));
        let [a, b] = ends.map(Vec3::as_dvec3);
        Self { middle: (a + b) * 0.5, half: (b - a) * 0.5, reach: reach[0].max(reach[1]) }
    }

    /// `false` only if an axis separates segment and box: one of the coordinate axes, or one across these and the segment.
    fn may_meet(&self, aabb: &Aabb) -> bool {
        let (min, max) = (aabb.min.as_dvec3(), aabb.max.as_dvec3());
        let reach = self.reach.max(min.abs().max_element()).max(max.abs().max_element());
        let extent = (max - min) * 0.5 + reach * GROWTH;
        let middle = self.middle - (min + max) * 0.5;
        let half = self.half.abs();
        if (middle.abs() - half).cmpgt(extent).any() {
            return false;
        }
        let across = middle.cross(self.half).abs();
        let reached = DVec3::new(
            extent.y * half.z + extent.z * half.y,
            extent.z * half.x + extent.x * half.z,
            extent.x * half.y + extent.y * half.x,
        );
        !across.cmpgt(reached).any()
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use proptest::prelude::*;
    use silhouette_core::shapes;
    use silhouette_testing::edits;
    use silhouette_testing::strategies::soup;

    #[test]
    fn few_faces_are_near_a_short_segment() {
        let ball = shapes::by_name("icosphere:5").unwrap();
        let mut visited = 0;
        MeshHierarchy::new(&ball).near_segment([Vec3::ZERO, Vec3::new(2.0, 2.1, 2.2)], |_, _| visited += 1);
        assert!((1..30).contains(&visited), "{visited} of {}", ball.face_count());
    }

    /// Places the integer lattice at twelve times its size, on which all means lie whose weights add up to 1, 2, 3, 4 or 6; far from the
    /// origin if asked to, and scaled by a power of two. Nothing is rounded.
    pub(crate) fn placing(exponent: i32, is_far: bool) -> impl Fn(DVec3) -> Vec3 + Copy {
        let scale = 2.0_f64.powi(exponent);
        let offset = if is_far { DVec3::new(1e6, 2e6, -1e6) } else { DVec3::ZERO };
        move |point| ((point * 12.0 + offset) * scale).as_vec3()
    }

    proptest! {
        /// Segments to a point of each face: to a corner, to the middle of a side, through the inside.
        #[test]
        fn no_face_that_a_segment_touches_is_missing(
            mesh in soup(30), from in prop::array::uniform3(-9_i8..=9), weights in prop::array::uniform3(0_u8..3),
            exponent in -60..60, is_far in any::<bool>(),
        ) {
            let place = placing(exponent, is_far);
            let placed = edits::mapped(&mesh, |position| place(position.as_dvec3()));
            let hierarchy = MeshHierarchy::new(&placed);
            let sum = f64::from(weights.iter().map(|&weight| u32::from(weight)).sum::<u32>());
            prop_assume!([1.0, 2.0, 3.0, 4.0, 6.0].contains(&sum));
            let from = DVec3::from(from.map(f64::from));
            for (face, triangle) in mesh.triangles().iter().enumerate() {
                let corner = |slot: usize| mesh.positions()[triangle[slot] as usize].as_dvec3() * f64::from(weights[slot]);
                let on_face = (corner(0) + corner(1) + corner(2)) / sum;
                for beyond in [on_face, 2.0 * on_face - from] {
                    let mut visited = Vec::new();
                    hierarchy.near_segment([place(from), place(beyond)], |face, _| visited.push(face.index()));
                    prop_assert!(visited.contains(&face));
                }
            }
        }
    }
}
