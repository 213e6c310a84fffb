//! Edges at which a mesh cannot be tracked: refused by name, or cut.
//!
//! Hall ("Silhouette Tracking", 2003, Restrictions) allows two polygons at an edge, and assumes that both are
//! counter-clockwise seen from outside. Where neighbours disagree on that, loops would still close, but consecutive
//! half-edges need not share a vertex.
//!
//! Cutting severs the mesh at these edges ([`Topology::severed`]): nothing lies across, so each front face there has a
//! silhouette half-edge of its own. That is sound for any defect, needs no new vertices and keeps every id; the price
//! is that an edge which is cut belongs to the silhouette whenever one of its faces is front, as a boundary edge does.

use silhouette_core::{EdgeId, FaceId, Topology, TriangleMesh};
use std::fmt;
use std::sync::Arc;

/// Why an edge cannot be tracked across.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DefectKind {
    /// It has three or more faces.
    NonManifold,
    /// Its two faces run along it in the same direction.
    InconsistentWinding,
}

/// An edge that cannot be tracked across.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Defect {
    /// The edge.
    pub edge: EdgeId,
    /// What is wrong there.
    pub kind: DefectKind,
    /// Its faces, ascending.
    pub faces: Vec<FaceId>,
}

/// A mesh that Hall's method is not defined for: every edge at fault, ascending.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub struct NotTrackable {
    /// The edges at fault; at least one.
    pub defects: Vec<Defect>,
}

/// A refusal by a method, with what its user can do about it.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{refusal}; mend the mesh, or {mend}")]
pub struct RefusedByMethod {
    /// What is wrong.
    pub refusal: NotTrackable,
    /// What the method offers beside mending the mesh.
    pub mend: &'static str,
}

impl fmt::Display for NotTrackable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = self.defects.len();
        write!(f, "{count} edges cannot be tracked across")?;
        if let Some(Defect { edge, kind, faces }) = self.defects.first() {
            let faces: Vec<String> = faces.iter().take(8).map(FaceId::to_string).collect();
            let faces = faces.join(", ");
            match kind {
                DefectKind::NonManifold => write!(f, "; the first, edge {edge}, joins more than two faces: {faces}")?,
                DefectKind::InconsistentWinding => {
                    write!(f, "; the first, edge {edge}, joins faces that disagree on which side is out: {faces}")?;
                }
            }
        }
        Ok(())
    }
}

/// Every edge that cannot be tracked across, ascending. O(E).
pub(crate) fn defects(mesh: &TriangleMesh, topology: &Topology) -> Vec<Defect> {
    let start = |half_edge| silhouette_core::loops::start_vertex(mesh, half_edge);
    let defect = |edge| {
        let kind = match *topology.half_edges(edge) {
            // The side of a face from a vertex to itself: such faces have no area and never face the viewer.
            [one, other] if start(one) == start(other) && !is_collapsed(topology, edge) => {
                DefectKind::InconsistentWinding
            }
            [_] | [_, _] => return None,
            _ => DefectKind::NonManifold,
        };
        Some(Defect { edge, kind, faces: topology.faces(edge).collect() })
    };
    topology.edges().ids().filter_map(defect).collect()
}

fn is_collapsed(topology: &Topology, edge: EdgeId) -> bool {
    let [a, b] = topology.end_points(edge);
    a == b
}

/// The topology with all defects cut; the same one where there is none.
pub(crate) fn cut(topology: &Arc<Topology>, defects: &[Defect]) -> Arc<Topology> {
    if defects.is_empty() {
        Arc::clone(topology)
    } else {
        Arc::new(topology.severed(defects.iter().map(|defect| defect.edge)))
    }
}
