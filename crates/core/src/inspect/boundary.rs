//! Boundary edges chained into loops.

use super::Sides;
use crate::id::{HalfEdgeId, PerHalfEdge, VertexId};
use crate::topology::Twin;

/// One boundary of the surface.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct BoundaryLoop {
    /// Its lowest half-edge: the side of a face, `3 * face + slot`.
    pub first_half_edge: HalfEdgeId,
    /// The vertex that this half-edge leaves.
    pub first_vertex: VertexId,
    /// How many edges it has.
    pub edges: usize,
    /// Their total length in object units.
    pub length: f64,
    /// Whether it returns to its start. It does not where it runs into a non-manifold edge or a side from a vertex to
    /// itself.
    pub is_closed: bool,
}

/// One end of a half-edge: its head, or its tail.
#[derive(Clone, Copy, PartialEq)]
struct End {
    half_edge: HalfEdgeId,
    at_head: bool,
}

/// Walks along the boundary; at each vertex it stays in the same fan, so boundaries that touch in a vertex stay apart.
/// Takes edges as undirected, because neighbouring faces need not be wound consistently. O(F).
pub(super) fn chain(sides: Sides) -> Vec<BoundaryLoop> {
    let mut is_done = PerHalfEdge::from(vec![false; sides.topology.half_edge_count()]);
    let mut loops = Vec::new();
    for first in is_done.ids() {
        if is_done[first] || !is_boundary(sides, first) {
            continue;
        }
        is_done[first] = true;
        let first_vertex = VertexId::new(sides.start(first));
        let length = sides.length(sides.topology.edge_of(first));
        let mut boundary = BoundaryLoop { first_half_edge: first, first_vertex, edges: 1, length, is_closed: false };
        // Forwards from the head; if that does not come back, also backwards from the tail.
        for at_head in [true, false] {
            let mut leaving = End { half_edge: first, at_head };
            while !boundary.is_closed
                && let Some(reached) = across_fan(sides, leaving)
            {
                boundary.is_closed = reached.half_edge == first;
                if !boundary.is_closed {
                    is_done[reached.half_edge] = true;
                    boundary.edges += 1;
                    boundary.length += sides.length(sides.topology.edge_of(reached.half_edge));
                    leaving = End { at_head: !reached.at_head, ..reached };
                }
            }
        }
        loops.push(boundary);
    }
    loops
}

fn is_boundary(sides: Sides, half_edge: HalfEdgeId) -> bool {
    sides.topology.twin(half_edge) == Twin::Boundary && !sides.is_collapsed(sides.topology.edge_of(half_edge))
}

/// The other boundary edge of the fan that `end` lies in, by its end at the same vertex. `None` where the fan ends in
/// something else than a boundary edge.
///
/// Both steps, to the other side of a corner and across an edge, are reversible, so a walk that starts at a boundary
/// cannot run in circles.
fn across_fan(sides: Sides, end: End) -> Option<End> {
    let End { mut half_edge, mut at_head } = end;
    loop {
        // The other side of the corner.
        half_edge = half_edge.next_in_face();
        if !at_head {
            half_edge = half_edge.next_in_face();
        }
        at_head = !at_head;
        match sides.topology.twin(half_edge) {
            Twin::HalfEdge(twin) => {
                let same_direction =
                    sides.start(half_edge) == sides.start(twin) && !sides.is_collapsed(sides.topology.edge_of(twin));
                at_head = at_head == same_direction;
                half_edge = twin;
            }
            Twin::Boundary if is_boundary(sides, half_edge) => return Some(End { half_edge, at_head }),
            Twin::Boundary | Twin::NonManifold => return None,
        }
    }
}
