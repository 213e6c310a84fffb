//! [`Fan`]: which of very many faces around a vertex may lie along a segment.
//!
//! Slivers from the apex of a fine cone have boxes that overlap all over, so that a hierarchy of boxes looks at nearly all of
//! them. Seen from the apex, each face is an arc: that of its opposite edge. And so is the segment, so that the faces that it
//! may meet are those whose arcs its own arc may meet. Boxes are around arcs on the unit sphere.

use crate::candidate::Candidate;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use silhouette_core::glam::{DVec3, Vec3A};
use silhouette_core::{FaceId, TriangleMesh};
use silhouette_rays::hierarchy::{Boxed, build};

/// By how much boxes are grown on every side, beyond the height of the arc over its chord. A direction of length 1 is rounded
/// to within `2^-24` on each axis, and computed to within far less.
const GROWTH: f32 = 1.0e-6;

/// Longest arc of a segment that is asked about at once, in radians: its box is then a thirtieth higher than its chord.
const LONGEST_ARC: f64 = 0.25;

/// A point closer to the apex than this share of the largest coordinate has no certain direction from there.
const LEAST_DISTANCE: f64 = 1e-6;

/// The faces around a vertex of very many.
pub struct Fan {
    vertex: u32,
    apex: DVec3,
    /// Points nearer than this have no certain direction.
    near: f64,
    bvh: Bvh2,
    faces: Vec<Candidate>,
}

/// A box around the arc between two directions.
fn around_arc(from: DVec3, to: DVec3) -> Aabb {
    let chord = from.distance(to) * 0.5;
    // The height of an arc over its chord; a half circle reaches any direction.
    let height = 1.0 - (1.0 - (chord * chord).min(1.0)).sqrt();
    let growth = Vec3A::splat(GROWTH + height as f32);
    let [from, to] = [from, to].map(DVec3::as_vec3a);
    Aabb::new(from.min(to) - growth, from.max(to) + growth)
}

impl Fan {
    /// The fan of these faces, all of which have the vertex. O(F log F).
    pub fn new(mesh: &TriangleMesh, vertex: u32, faces: &[FaceId]) -> Self {
        let apex = mesh.positions()[vertex as usize].as_dvec3();
        let reach = mesh.positions().iter().fold(0.0_f32, |reach, at| reach.max(at.abs().max_element()));
        let arc = |&face: &FaceId| {
            let mut rest = mesh.triangles()[face.index()].into_iter().filter(|&corner| corner != vertex);
            let mut direction = || {
                let corner = rest.next().map(|corner| mesh.positions()[corner as usize].as_dvec3());
                corner.and_then(|corner| (corner - apex).try_normalize())
            };
            match (direction(), direction()) {
                (Some(from), Some(to)) => Boxed(around_arc(from, to)),
                // A face without area, which may lie anywhere.
                _ => Boxed(Aabb::new(Vec3A::NEG_ONE, Vec3A::ONE)),
            }
        };
        let arcs: Vec<Boxed> = faces.iter().map(arc).collect();
        let bvh = build(&arcs);
        let candidate = |&face: &FaceId| {
            let vertices = mesh.triangles()[face.index()];
            Candidate { face, vertices, may_hold: [true; 2] }
        };
        let faces = faces.iter().map(candidate).collect();
        Self { vertex, apex, near: f64::from(reach) * LEAST_DISTANCE, bvh, faces }
    }

    /// The vertex.
    pub fn vertex(&self) -> u32 {
        self.vertex
    }

    /// Visits the faces that may lie along a segment: a superset, each once. `found` is scratch.
    pub fn faces_along(&self, [a, b]: [DVec3; 2], found: &mut Vec<u32>, visit: &mut impl FnMut(Candidate)) {
        found.clear();
        let [from, to] = [a, b].map(|end| end - self.apex);
        let share = if a == b { 0.0 } else { from.dot(from - to) / from.distance_squared(to) };
        if from.lerp(to, share.clamp(0.0, 1.0)).length() <= self.near {
            // From so near, it may be seen in any direction.
            self.faces.iter().for_each(|&face| visit(face));
            return;
        }
        let angle = from.angle_between(to);
        let pieces = (angle / LONGEST_ARC).ceil().max(1.0) as u32;
        // Pieces of equal angle: the segment's point at a share of the angle, by the law of sines.
        let at = |piece: u32| {
            let share = f64::from(piece) / f64::from(pieces);
            let (here, there) = ((angle * (1.0 - share)).sin(), (angle * share).sin());
            if pieces == 1 || angle.sin() < 1e-3 {
                from.normalize().lerp(to.normalize(), share).normalize_or_zero()
            } else {
                (from.normalize() * here + to.normalize() * there).normalize()
            }
        };
        for piece in 0..pieces {
            let arc = around_arc(at(piece), at(piece + 1));
            self.bvh.aabb_traverse(arc, |bvh, node| {
                let node = &bvh.nodes[node as usize];
                let places = node.first_index as usize..(node.first_index + node.prim_count) as usize;
                found.extend(places.map(|place| bvh.primitive_indices[place]));
                true
            });
        }
        found.sort_unstable();
        found.dedup();
        found.iter().for_each(|&index| visit(self.faces[index as usize]));
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        size_of_val(self.bvh.nodes.as_slice())
            + size_of_val(self.bvh.primitive_indices.as_slice())
            + size_of_val(self.faces.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::piercing::passage;
    use silhouette_core::glam::Vec3;

    /// Slivers around the z axis, crossed by segments from everywhere.
    #[test]
    fn no_face_is_missing_and_few_are_visited() {
        let count = 600_u32;
        let rim = |index: u32| {
            let angle = index as f32 / count as f32 * std::f32::consts::TAU;
            Vec3::new(angle.cos(), angle.sin(), (5.0 * angle).sin() * 0.2)
        };
        let positions: Vec<Vec3> = std::iter::once(Vec3::Z).chain((0..count).map(rim)).collect();
        let triangles = (0..count).map(|index| [0, 1 + index, 1 + (index + 1) % count]).collect();
        let mesh = TriangleMesh::new(positions, triangles).unwrap();
        let fan = Fan::new(&mesh, 0, &(0..count as usize).map(FaceId::from_usize).collect::<Vec<_>>());
        let place = |index: u32| {
            let turn = index as f32 * 2.399_963_2;
            Vec3::new(turn.cos() * 0.9, turn.sin() * 0.8, (index as f32 * 0.37).sin())
        };
        let (mut passed, mut visited, mut segments) = (0, 0, 0);
        let mut scratch = Vec::new();
        for one in 0..40 {
            for other in one + 1..40 {
                let ends = [place(one), place(other)];
                let mut found = Vec::new();
                fan.faces_along(ends.map(Vec3::as_dvec3), &mut scratch, &mut |candidate| found.push(candidate.face));
                for face in (0..count as usize).map(FaceId::from_usize) {
                    if passage(ends, mesh.corners(face)).is_some() {
                        passed += 1;
                        assert!(found.contains(&face), "{face} from {one} to {other}");
                    }
                }
                visited += found.len();
                segments += 1;
            }
        }
        assert!(passed > 300 && visited < 40 * segments, "{passed} passed, {visited} visited by {segments}");
    }
}
