//! Where a vertex goes and where the new point of an edge lies: the table of the parent module.

use super::corners::{Corners, arriving, origin};
use crate::id::{EdgeId, HalfEdgeId, VertexId};
use crate::mesh::TriangleMesh;
use crate::topology::{Topology, Twin};
use glam::DVec3;

/// The point of an edge.
pub(super) fn edge(mesh: &TriangleMesh, topology: &Topology, positions: &[DVec3], index: usize) -> DVec3 {
    let edge = EdgeId::from_usize(index);
    let [a, b] = topology.end_points(edge).map(|vertex| positions[vertex.index()]);
    match *topology.half_edges(edge) {
        [one, other] if !is_sharp(topology, edge) => {
            let across = |half_edge| positions[origin(mesh, arriving(half_edge)) as usize];
            (a + b) * 0.375 + (across(one) + across(other)) * 0.125
        }
        _ => (a + b) * 0.5,
    }
}

/// What a vertex moves to.
pub(super) fn vertex(
    mesh: &TriangleMesh,
    topology: &Topology,
    corners: &Corners,
    positions: &[DVec3],
    vertex: usize,
) -> DVec3 {
    let leaving = corners.leaving(vertex);
    let old = positions[vertex];
    match sharp_edges(topology, leaving) {
        SharpEdges::None if is_one_fan(mesh, topology, vertex as u32, leaving) => {
            // Every neighbour lies in two corners.
            let neighbours = leaving.iter().flat_map(|&half_edge| [half_edge.next_in_face(), arriving(half_edge)]);
            let twice: DVec3 = neighbours.map(|half_edge| positions[origin(mesh, half_edge) as usize]).sum();
            let count = leaving.len() as f64;
            let weight = neighbour_weight(leaving.len());
            old * (1.0 - count * weight) + twice * (0.5 * weight)
        }
        SharpEdges::Two(edges) => {
            let ends = edges.map(|edge| {
                let [a, b] = topology.end_points(edge).map(VertexId::index);
                positions[if a == vertex { b } else { a }]
            });
            old * 0.75 + (ends[0] + ends[1]) * 0.125
        }
        _ => old,
    }
}

/// Warren's weight of one of `count` neighbours.
fn neighbour_weight(count: usize) -> f64 {
    if count > 3 { 0.375 / count as f64 } else { 0.1875 }
}

/// Whether the surface is not smooth across an edge.
fn is_sharp(topology: &Topology, edge: EdgeId) -> bool {
    let [a, b] = topology.end_points(edge);
    topology.half_edges(edge).len() != 2 || a == b
}

/// The sharp edges at a vertex, as far as the rules tell them apart.
enum SharpEdges {
    None,
    Two([EdgeId; 2]),
    /// One, three or more, or one from the vertex to itself.
    Other,
}

fn sharp_edges(topology: &Topology, leaving: &[HalfEdgeId]) -> SharpEdges {
    let mut found = [None; 2];
    for half_edge in leaving.iter().flat_map(|&half_edge| [half_edge, arriving(half_edge)]) {
        let edge = topology.edge_of(half_edge);
        if found.contains(&Some(edge)) || !is_sharp(topology, edge) {
            continue;
        }
        let [a, b] = topology.end_points(edge);
        match found.iter_mut().find(|place| place.is_none()) {
            Some(place) if a != b => *place = Some(edge),
            _ => return SharpEdges::Other,
        }
    }
    match found {
        [None, _] => SharpEdges::None,
        [Some(one), Some(other)] => SharpEdges::Two([one, other]),
        [Some(_), None] => SharpEdges::Other,
    }
}

/// Whether the faces at a vertex without sharp edges, of which there is at least one, are one closed fan. Crosses edges
/// without regard to winding. Each step can be undone, so the walk returns to its beginning.
fn is_one_fan(mesh: &TriangleMesh, topology: &Topology, vertex: u32, leaving: &[HalfEdgeId]) -> bool {
    let Some(&begin) = leaving.first() else { return false };
    let (mut into, mut faces) = (begin, 0);
    loop {
        faces += 1;
        let out = if origin(mesh, into) == vertex { arriving(into) } else { into.next_in_face() };
        let Twin::HalfEdge(twin) = topology.twin(out) else { return false };
        into = twin;
        if into == begin {
            return faces == leaving.len();
        }
    }
}
