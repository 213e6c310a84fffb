//! Faces that are degenerate or there more than once.

use super::Sides;
use crate::id::{EdgeId, FaceId};
use crate::mesh::TriangleMesh;
use glam::Vec3;
use rayon::prelude::*;
use robust::{Coord, orient2d};

/// Whether a face with these corners has no area: whether three points are collinear, exactly.
///
/// The components of `(b - a) x (c - a)` are the signed areas of the triangle's projections along the three axes, each
/// an `orient2d` of two of the coordinates. That predicate is exact as long as nothing over- or underflows, and with
/// 32-bit inputs nothing does in 64-bit arithmetic: products and their rounding errors lie between 2^-298 and 2^258. The
/// corners are collinear if and only if all three vanish.
pub fn has_zero_area([a, b, c]: [Vec3; 3]) -> bool {
    let vanishes_along = |drop: usize| {
        let project = |p: Vec3| Coord { x: p[(drop + 1) % 3], y: p[(drop + 2) % 3] };
        orient2d(project(a), project(b), project(c)) == 0.0
    };
    (0..3).all(vanishes_along)
}

/// Faces whose corners are collinear, ascending. O(F).
pub(super) fn zero_area(mesh: &TriangleMesh) -> Vec<FaceId> {
    select(mesh, |face| has_zero_area(mesh.corners(face)))
}

/// Faces that name a vertex twice, ascending. O(F).
pub(super) fn repeated_vertex(mesh: &TriangleMesh) -> Vec<FaceId> {
    select(mesh, |face| {
        let [a, b, c] = mesh.triangles()[face.index()];
        a == b || b == c || c == a
    })
}

fn select(mesh: &TriangleMesh, test: impl Fn(FaceId) -> bool + Sync + Send) -> Vec<FaceId> {
    (0..mesh.face_count() as u32).into_par_iter().map(FaceId::new).filter(|&face| test(face)).collect()
}

/// Groups of faces over the same three vertices, in any order and winding. Groups by their lowest face, faces ascending.
///
/// Such faces meet at all their edges, so it is enough to compare, at each edge, the faces of which it joins the two
/// lowest vertices. O(F log d) for the largest number d of faces at an edge.
pub(super) fn duplicates(sides: Sides) -> Vec<Vec<FaceId>> {
    let edges = (0..sides.topology.edge_count() as u32).into_par_iter().map(EdgeId::new);
    let shared = edges.filter(|&edge| sides.topology.half_edges(edge).len() > 1);
    let mut groups: Vec<Vec<FaceId>> = shared.flat_map_iter(|edge| duplicates_at(sides, edge)).collect();
    groups.par_sort_unstable_by_key(|group| group[0]);
    groups
}

fn duplicates_at(sides: Sides, edge: EdgeId) -> Vec<Vec<FaceId>> {
    let highest_end = sides.topology.edges()[edge][1];
    let opposite = |half_edge: &crate::id::HalfEdgeId| sides.start(half_edge.next_in_face().next_in_face());
    let half_edges = sides.topology.half_edges(edge).iter();
    let mut apexes: Vec<(u32, FaceId)> = half_edges
        .map(|half_edge| (opposite(half_edge), half_edge.face()))
        .filter(|&(apex, _)| apex >= highest_end)
        .collect();
    apexes.sort_unstable();
    // A face that names a vertex twice meets an edge with two of its sides.
    apexes.dedup();
    let same_apex = apexes.chunk_by(|one, other| one.0 == other.0).filter(|group| group.len() > 1);
    same_apex.map(|group| group.iter().map(|&(_, face)| face).collect()).collect()
}
