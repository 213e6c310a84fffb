//! Step 3: whether a pass has kept the topology, and if not, which vertices are at fault.

use crate::id::VertexId;
use crate::inspect::Inspection;
use crate::mesh::TriangleMesh;
use crate::topology::Topology;
use std::collections::{BTreeSet, HashMap};

/// What a pass has done to the topology.
pub(super) enum Change {
    /// Nothing.
    None,
    /// The surface now touches itself at these vertices.
    At(Vec<u32>),
    /// A part, a hole or a handle has vanished.
    Somewhere,
}

/// Compares two meshes over the same vertices, of which `mesh` is the later one.
pub(super) fn change(before: &Inspection, after: &Inspection, mesh: &TriangleMesh) -> Change {
    let (old, new) = (defects(before), defects(after));
    let mut at_fault: BTreeSet<u32> = new.difference(&old).flatten().map(|vertex| vertex.get()).collect();
    if after.defects.duplicate_faces.len() > before.defects.duplicate_faces.len() {
        let doubled = after.defects.duplicate_faces.iter().map(|group| group[0]);
        at_fault.extend(doubled.flat_map(|face| mesh.triangles()[face.index()]));
    }
    let kept = |inspection: &Inspection| {
        (inspection.euler_characteristic, inspection.components.len(), inspection.boundary_loops.len())
    };
    if !at_fault.is_empty() {
        Change::At(at_fault.into_iter().collect())
    } else if kept(before) != kept(after) {
        Change::Somewhere
    } else {
        Change::None
    }
}

/// The edges and vertices that are no manifold, by their vertices.
fn defects(inspection: &Inspection) -> BTreeSet<Vec<VertexId>> {
    let defects = &inspection.defects;
    let edges = defects.non_manifold_edges.iter().map(|defect| defect.vertices.to_vec());
    edges.chain(defects.non_manifold_vertices.iter().map(|&vertex| vec![vertex])).collect()
}

/// The vertices that share an edge with one of these.
pub(super) fn neighbours(topology: &Topology, vertices: &[u32]) -> Vec<u32> {
    let is_one = |vertex: u32| vertices.binary_search(&vertex).is_ok();
    topology.edges().as_slice().iter().filter(|ends| ends.iter().any(|&end| is_one(end))).flatten().copied().collect()
}

/// Edges of a boundary too short to lose one: of three edges, a collapse leaves two, which coincide, so that the hole is
/// gone. One more, because collapses of a pass do not know of each other's.
const SHORT_BOUNDARY: usize = 4;

/// The vertices of boundaries of no more than [`SHORT_BOUNDARY`] edges.
pub(super) fn on_short_boundaries(topology: &Topology, mesh: &TriangleMesh) -> Vec<u32> {
    let edges = topology.edges().ids().filter_map(|edge| {
        let &[half_edge] = topology.half_edges(edge) else { return None };
        let (triangle, slot) = (mesh.triangles()[half_edge.face().index()], half_edge.slot() as usize);
        Some((triangle[slot], triangle[(slot + 1) % 3]))
    });
    let next: HashMap<u32, u32> = edges.collect();
    let is_back = |start: u32| {
        std::iter::successors(next.get(&start), |vertex| next.get(vertex)).take(SHORT_BOUNDARY).any(|&v| v == start)
    };
    next.keys().copied().filter(|&start| is_back(start)).collect()
}
