//! Everything that is wrong with a mesh, with element ids.

use super::fans::Fans;
use super::{Sides, faces, folds, vertices};
use crate::id::{EdgeId, FaceId, VertexId};

/// An edge at which something is wrong.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct EdgeDefect {
    /// The edge.
    pub edge: EdgeId,
    /// Its end points, lower vertex first.
    pub vertices: [VertexId; 2],
    /// The faces at it, ascending. A face that names a vertex twice may appear twice.
    pub faces: Vec<FaceId>,
}

/// Defects by kind. Every list is ascending by its (first) element; boundary edges are no defect.
#[derive(Debug, Clone, PartialEq, Eq, Default, serde::Serialize)]
pub struct Defects {
    /// Edges with three or more faces.
    pub non_manifold_edges: Vec<EdgeDefect>,
    /// Vertices at which several fans of faces touch without sharing an edge there. The end points of a non-manifold
    /// edge are not listed for that alone.
    pub non_manifold_vertices: Vec<VertexId>,
    /// Interior edges along which both faces run in the same direction, so that they disagree on which side is out.
    pub inconsistent_edges: Vec<EdgeDefect>,
    /// Interior edges whose two faces lie in one plane and overlap: folds by 180 degrees. Nearly all come from concave
    /// polygons that were cut into a fan. In one plane means up to the rounding of coordinates to 32 bits.
    pub folded_edges: Vec<EdgeDefect>,
    /// Faces with collinear corners, by exact arithmetic; those that name a vertex twice included.
    pub zero_area_faces: Vec<FaceId>,
    /// Faces that name a vertex twice.
    pub repeated_vertex_faces: Vec<FaceId>,
    /// Groups of faces over the same three vertices, in any order.
    pub duplicate_faces: Vec<Vec<FaceId>>,
    /// Vertices that no face names.
    pub unreferenced_vertices: Vec<VertexId>,
    /// Groups of vertices at the same position.
    pub duplicate_vertices: Vec<Vec<VertexId>>,
}

impl Defects {
    /// Each kind of defect, in words, with the number of its entries (groups for duplicates).
    pub fn counts(&self) -> [(&'static str, usize); 9] {
        [
            ("non-manifold edges", self.non_manifold_edges.len()),
            ("non-manifold vertices", self.non_manifold_vertices.len()),
            ("inconsistently wound edges", self.inconsistent_edges.len()),
            ("edges between faces folded onto each other", self.folded_edges.len()),
            ("zero-area faces", self.zero_area_faces.len()),
            ("faces that name a vertex twice", self.repeated_vertex_faces.len()),
            ("groups of duplicate faces", self.duplicate_faces.len()),
            ("unreferenced vertices", self.unreferenced_vertices.len()),
            ("groups of duplicate vertices", self.duplicate_vertices.len()),
        ]
    }

    /// Whether nothing is wrong.
    pub fn is_empty(&self) -> bool {
        self.counts().iter().all(|&(_, count)| count == 0)
    }
}

pub(super) fn find(sides: Sides, fans: &Fans) -> Defects {
    let mut defects = Defects {
        non_manifold_vertices: fans.pinches.iter().map(|pinch| pinch.vertex).collect(),
        zero_area_faces: faces::zero_area(sides.mesh),
        repeated_vertex_faces: faces::repeated_vertex(sides.mesh),
        duplicate_faces: faces::duplicates(sides),
        unreferenced_vertices: vertices::unreferenced(fans),
        duplicate_vertices: vertices::duplicates(sides.mesh),
        ..Defects::default()
    };
    for edge in sides.topology.edges().ids().filter(|&edge| !sides.is_collapsed(edge)) {
        let report = || EdgeDefect {
            edge,
            vertices: sides.topology.end_points(edge),
            faces: sides.topology.faces(edge).collect(),
        };
        match *sides.topology.half_edges(edge) {
            [_] => {}
            [one, other] => {
                if sides.start(one) == sides.start(other) {
                    defects.inconsistent_edges.push(report());
                }
                if folds::is_fold(sides, edge, [one, other]) {
                    defects.folded_edges.push(report());
                }
            }
            _ => defects.non_manifold_edges.push(report()),
        }
    }
    defects
}
