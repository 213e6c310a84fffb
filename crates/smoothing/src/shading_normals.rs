//! Section III-B: a shading normal for each vertex, and several where feature edges separate groups of triangles.
//!
//! Departure: the paper weights faces by their angle at the vertex (Thürmer and Wüthrich 1998). On meshes that were simplified,
//! whose faces differ much in size and shape, outlines come closer to the original with weights by area, the default. The
//! weights of Max ("Weights for computing vertex normals from facet normals", Journal of Graphics Tools 4(2), 1999) are exact
//! wherever a vertex and its neighbours lie on one sphere. `docs/methods/smoothing.md` has the figures.

use silhouette_core::face_normal::face_normal;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::id::{FaceId, PerEdge};
use silhouette_core::{Cancelled, DisjointSets, EdgeId, Progress, Topology, TriangleMesh};

silhouette_core::option_choice! {
    /// How much each face counts in the normal of a vertex.
    pub enum NormalWeights {
        /// Its area.
        Area = "area",
        /// Its angle at the vertex, as the paper has it.
        Angle = "angle",
        /// The sine of its angle at the vertex over the lengths of its two sides there: exact on spheres.
        Sphere = "sphere",
    }
}

/// Corners of a mesh sorted into groups: the corners at one vertex that are joined by edges that are no feature edges.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Groups {
    /// Group of each corner of each face.
    pub of_corner: Vec<[u32; 3]>,
    /// Vertex of each group. Groups are ordered by vertex, then by their first corner; a vertex of no face has one group.
    pub vertex: Vec<u32>,
}

impl Groups {
    /// Sorts corners into groups by union and find. O(F α(F)).
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn new(
        mesh: &TriangleMesh,
        topology: &Topology,
        features: &PerEdge<bool>,
        progress: &dyn Progress,
    ) -> Result<Self, Cancelled> {
        let mut sets = DisjointSets::new(topology.half_edge_count());
        for edge in (0..topology.edge_count()).map(EdgeId::from_usize).filter(|&edge| !features[edge]) {
            // Consistently wound: where one half-edge begins, the other ends.
            if let &[a, b] = topology.half_edges(edge) {
                sets.unite(a.get(), b.next_in_face().get());
                sets.unite(b.get(), a.next_in_face().get());
            }
        }
        progress.check()?;
        let corner_at = |corner: usize| mesh.triangles()[corner / 3][corner % 3];
        let mut roots: Vec<(u32, u32)> = (0..topology.half_edge_count())
            .filter(|&corner| sets.find(corner as u32) == corner as u32)
            .map(|corner| (corner_at(corner), corner as u32))
            .collect();
        let mut is_used = vec![false; mesh.vertex_count()];
        roots.iter().for_each(|&(vertex, _)| is_used[vertex as usize] = true);
        let unused = is_used.iter().enumerate().filter(|(_, used)| !**used);
        roots.extend(unused.map(|(vertex, _)| (vertex as u32, u32::MAX)));
        roots.sort_unstable();
        progress.check()?;
        let mut group_of_root = vec![0; topology.half_edge_count()];
        for (group, &(_, root)) in roots.iter().enumerate() {
            if root != u32::MAX {
                group_of_root[root as usize] = group as u32;
            }
        }
        let mut group = |corner: u32| group_of_root[sets.find(corner) as usize];
        let of_corner =
            (0..mesh.face_count() as u32).map(|face| [0, 1, 2].map(|slot| group(3 * face + slot))).collect();
        Ok(Self { of_corner, vertex: roots.into_iter().map(|(vertex, _)| vertex).collect() })
    }
}

/// The unit normal of each group: the weighted average of its faces' normals. Faces without area contribute nothing. Where the average vanishes, as over a fold, the normal of one of the
/// group's faces takes its place; it is 0 if none has an area. O(F).
pub fn shading_normals(mesh: &TriangleMesh, groups: &Groups, weights: NormalWeights, is_turned: &[bool]) -> Vec<Vec3> {
    let mut sums = vec![DVec3::ZERO; groups.vertex.len()];
    let mut sizes = vec![0.0; groups.vertex.len()];
    let mut any = vec![DVec3::ZERO; groups.vertex.len()];
    for (face, corners) in groups.of_corner.iter().enumerate() {
        let points = mesh.corners(FaceId::from_usize(face));
        let Some(normal) = face_normal(points) else { continue };
        let normal = if is_turned[face] { -normal } else { normal };
        let points = points.map(Vec3::as_dvec3);
        for slot in 0..3 {
            let (at, next, last) = (points[slot], points[(slot + 1) % 3], points[(slot + 2) % 3]);
            let (a, b) = (next - at, last - at);
            let weight = match weights {
                NormalWeights::Sphere => a.cross(b).length() / (a.length_squared() * b.length_squared()),
                NormalWeights::Area => a.cross(b).length(),
                // An angle that is exact for needles too, where the arc cosine is not.
                NormalWeights::Angle => a.cross(b).length().atan2(a.dot(b)),
            };
            let group = corners[slot] as usize;
            sums[group] += weight * normal;
            sizes[group] += weight;
            any[group] = normal;
        }
    }
    let settled = |((sum, size), any): ((&DVec3, &f64), &DVec3)| {
        let is_certain = sum.length() > LEAST_SHARE * size && sum.is_finite();
        if is_certain { sum.normalize() } else { *any }
    };
    sums.iter().zip(&sizes).zip(&any).map(settled).map(DVec3::as_vec3).collect()
}

/// A sum below this share of its weights is cancellation.
const LEAST_SHARE: f64 = 1e-6;

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::NoProgress;
    use silhouette_core::feature_edges::feature_edges;
    use silhouette_core::shapes::{self, Cuboid};

    fn groups_and_normals(mesh: &TriangleMesh, crease_deg: f64) -> (Groups, Vec<Vec3>) {
        let topology = Topology::new(mesh);
        let features = feature_edges(mesh, &topology, &[], crease_deg);
        let groups = Groups::new(mesh, &topology, &features, &NoProgress).unwrap();
        let normals = shading_normals(mesh, &groups, NormalWeights::Angle, &vec![false; mesh.face_count()]);
        (groups, normals)
    }

    #[test]
    fn a_cube_has_three_normals_at_each_corner_each_a_face_normal() {
        let cube = Cuboid::default().mesh().unwrap();
        let (groups, normals) = groups_and_normals(&cube, 75.0);
        assert_eq!(groups.vertex.len(), 24);
        for (face, corners) in groups.of_corner.iter().enumerate() {
            let expected = face_normal(cube.corners(FaceId::from_usize(face))).unwrap().as_vec3();
            assert!(corners.iter().all(|&group| normals[group as usize].distance(expected) < 1e-6));
        }
        assert!(groups.vertex.is_sorted());
    }

    #[test]
    fn without_features_groups_are_vertices_and_angles_make_normals_independent_of_the_triangulation() {
        let cube = Cuboid::default().mesh().unwrap();
        let (groups, normals) = groups_and_normals(&cube, 180.0);
        assert_eq!(groups.vertex, (0..8).collect::<Vec<u32>>());
        for (position, normal) in cube.positions().iter().zip(&normals) {
            assert!(normal.distance(position.normalize()) < 1e-6);
        }
        let sphere = shapes::by_name("icosphere:2").unwrap();
        let (_, normals) = groups_and_normals(&sphere, 75.0);
        assert!(sphere.positions().iter().zip(&normals).all(|(p, n)| p.normalize().distance(*n) < 0.02));
    }

    #[test]
    fn cancelled_fans_flat_faces_and_unused_vertices_have_finite_normals() {
        let p = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ONE, Vec3::splat(9.0)];
        // A fold: two faces on each other, their normals opposite, joined along all sides; and a face without area.
        let mesh = TriangleMesh::new(p.to_vec(), vec![[0, 1, 2], [0, 2, 1], [3, 3, 0]]).unwrap();
        let (groups, normals) = groups_and_normals(&mesh, 180.0);
        assert!(groups.vertex.contains(&4), "a vertex of no face has a group");
        for (&vertex, normal) in groups.vertex.iter().zip(&normals) {
            let expected = if vertex < 3 && normal.length() > 0.0 { 1.0 } else { 0.0 };
            assert!((normal.length() - expected).abs() < 1e-6);
        }
        assert!(normals.iter().any(|normal| normal.length() > 0.0));
    }
}
