//! Edges that are drawn along whatever the view: boundary edges and creases. The only part of the method that needs
//! topology, and only where it is asked for.

use crate::settings::ExtraEdges;
use silhouette_core::glam::DVec3;
use silhouette_core::{EdgeId, Topology, TriangleMesh, VertexId};

/// The vertices of every edge asked for, in the order of edge ids. O(E). An edge with three or more faces counts as a
/// crease; one whose faces include one without area does not.
pub fn feature_edges(mesh: &TriangleMesh, topology: &Topology, wanted: ExtraEdges) -> Vec<[u32; 2]> {
    let edges = (0..topology.edge_count()).map(EdgeId::from_usize);
    let is_wanted = |edge: &EdgeId| match wanted {
        ExtraEdges::None => false,
        ExtraEdges::Boundary => topology.half_edges(*edge).len() == 1,
        ExtraEdges::BoundaryAndCreases(angle_rad) => match topology.half_edges(*edge) {
            [_] => true,
            &[a, b] => {
                let [a, b] = [a, b].map(|half_edge| normal(mesh, half_edge.face().index()));
                a.zip(b).is_some_and(|(a, b)| a.angle_between(b) >= angle_rad)
            }
            _ => true,
        },
    };
    edges.filter(is_wanted).map(|edge| topology.end_points(edge).map(VertexId::get)).collect()
}

fn normal(mesh: &TriangleMesh, face: usize) -> Option<DVec3> {
    let [a, b, c] = mesh.triangles()[face].map(|vertex| mesh.positions()[vertex as usize].as_dvec3());
    (b - a).cross(c - a).try_normalize()
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::shapes::Cuboid;

    #[test]
    fn a_cube_has_twelve_creases_and_an_open_one_a_boundary() {
        let cube = Cuboid::default().mesh().unwrap();
        let count = |mesh: &TriangleMesh, wanted| feature_edges(mesh, &Topology::new(mesh), wanted).len();
        assert_eq!(count(&cube, ExtraEdges::BoundaryAndCreases(1.5)), 12);
        assert_eq!(count(&cube, ExtraEdges::BoundaryAndCreases(1.6)), 0);
        assert_eq!(count(&cube, ExtraEdges::Boundary), 0);
        let open = TriangleMesh::new(cube.positions().to_vec(), cube.triangles()[..10].to_vec()).unwrap();
        assert_eq!(count(&open, ExtraEdges::Boundary), 4);
        assert_eq!(count(&open, ExtraEdges::None), 0);
    }
}
