//! Which edges are feature edges: sharp because whoever made the mesh says so, by their dihedral angle, or because the surface
//! ends or branches there.

use crate::face_normal::face_normal;
use crate::id::{EdgeId, PerEdge, VertexId};
use crate::mesh::TriangleMesh;
use crate::topology::Topology;
use rayon::prelude::*;

/// Edges that a task takes at least: about 0.3 ms of work.
const EDGES_PER_TASK: usize = 4096;

/// Whether each edge is a feature edge. An edge is one
///
/// - if `given` names it,
/// - if its faces make a dihedral angle of `crease_deg` or more, 0 for coplanar ones; faces without area make none,
/// - if it does not join exactly two consistently wound faces: boundary edges, non-manifold edges, edges where the winding
///   changes, and sides from a vertex to itself. No shading normal is continuous there.
///
/// Pairs of `given` that are no edges of the mesh are ignored. O(E), parallel.
pub fn feature_edges(
    mesh: &TriangleMesh,
    topology: &Topology,
    given: &[[VertexId; 2]],
    crease_deg: f64,
) -> PerEdge<bool> {
    let least_cosine = crease_deg.to_radians().cos();
    let is_feature = |edge: EdgeId| {
        let Some(faces) = topology.consistent_pair(mesh, edge) else { return true };
        let normals = faces.map(|face| face_normal(mesh.corners(face)));
        let [Some(n0), Some(n1)] = normals else { return false };
        crease_deg < 180.0 && n0.dot(n1) <= least_cosine
    };
    let edges = (0..topology.edge_count()).into_par_iter().with_min_len(EDGES_PER_TASK).map(EdgeId::from_usize);
    let mut features = PerEdge::from(edges.map(is_feature).collect::<Vec<_>>());
    for &[a, b] in given {
        if let Some(edge) = topology.find_edge(a, b) {
            features[edge] = true;
        }
    }
    features
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{self, Cuboid};

    fn count(mesh: &TriangleMesh, given: &[[u32; 2]], crease_deg: f64) -> usize {
        let given: Vec<_> = given.iter().map(|pair| pair.map(VertexId::new)).collect();
        let features = feature_edges(mesh, &Topology::new(mesh), &given, crease_deg);
        features.iter().filter(|(_, is_feature)| **is_feature).count()
    }

    #[test]
    fn a_cube_has_twelve_at_ninety_degrees_and_none_above() {
        let cube = Cuboid::default().mesh().unwrap();
        assert_eq!([89.0, 91.0, 180.0].map(|deg| count(&cube, &[], deg)), [12, 0, 0]);
        let [a, b, _] = cube.triangles()[0];
        assert_eq!(count(&cube, &[[a, b], [b, a], [0, 0], [7, 1000]], 180.0), 1);
    }

    #[test]
    fn where_the_surface_ends_branches_or_changes_its_winding_there_is_one() {
        let cube = Cuboid::default().mesh().unwrap();
        let open = TriangleMesh::new(cube.positions().to_vec(), cube.triangles()[..10].to_vec()).unwrap();
        assert_eq!(count(&open, &[], 180.0), 4);
        let mut turned = cube.triangles().to_vec();
        turned[0].swap(0, 1);
        let turned = TriangleMesh::new(cube.positions().to_vec(), turned).unwrap();
        assert_eq!(count(&turned, &[], 180.0), 3);
        let mut fin = cube.triangles().to_vec();
        fin.push([0, 1, 7]);
        let branching = count(&TriangleMesh::new(cube.positions().to_vec(), fin).unwrap(), &[], 180.0);
        assert!((1..=3).contains(&branching), "{branching}");
    }

    #[test]
    fn a_smooth_shape_has_none() {
        assert_eq!(count(&shapes::by_name("icosphere:1").unwrap(), &[], 75.0), 0);
    }
}
