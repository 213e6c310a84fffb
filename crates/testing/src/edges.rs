//! End points and lengths of edges, in double precision.

use silhouette_core::glam::DVec3;
use silhouette_core::loops::start_vertex;
use silhouette_core::{EdgeId, HalfEdgeId, Topology, TriangleMesh, VertexId};

/// Where an edge ends, lower vertex first.
pub fn edge_ends(mesh: &TriangleMesh, topology: &Topology, edge: EdgeId) -> [DVec3; 2] {
    topology.end_points(edge).map(|vertex| position(mesh, vertex))
}

/// Where a half-edge starts and where it ends.
pub fn half_edge_ends(mesh: &TriangleMesh, half_edge: HalfEdgeId) -> [DVec3; 2] {
    [half_edge, half_edge.next_in_face()].map(|side| position(mesh, start_vertex(mesh, side)))
}

/// Length of the longest edge of a mesh; 0 where there is none.
pub fn longest_edge(mesh: &TriangleMesh) -> f64 {
    let topology = Topology::new(mesh);
    let length = |edge| {
        let [a, b] = edge_ends(mesh, &topology, edge);
        a.distance(b)
    };
    topology.edges().ids().map(length).fold(0.0, f64::max)
}

fn position(mesh: &TriangleMesh, vertex: VertexId) -> DVec3 {
    mesh.positions()[vertex.index()].as_dvec3()
}
