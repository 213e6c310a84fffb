//! Edges along which two faces are folded onto each other.

use super::Sides;
use crate::id::{EdgeId, HalfEdgeId};

/// Roundings of a coordinate to 32 bits by which a corner may lie off the plane of the other face and count as in it. The
/// corner and the three of the plane are each off by one at most.
const OFF_PLANE: f64 = 4.0;

/// Roundings by which both faces must rise above the edge, lest rounding decides on which side of it they lie.
const LEAST_HEIGHT: f64 = 16.0 * OFF_PLANE;

/// Whether the faces on the two sides of an edge lie in one plane, on the same side of the edge. Two faces over the same
/// three vertices are duplicates, not a fold.
pub(super) fn is_fold(sides: Sides, edge: EdgeId, half_edges: [HalfEdgeId; 2]) -> bool {
    let apexes = half_edges.map(|half_edge| sides.start(half_edge.next_in_face().next_in_face()));
    let [foot, tip] = sides.topology.edges()[edge];
    if apexes[0] == apexes[1] || apexes.iter().any(|&apex| apex == foot || apex == tip) {
        return false;
    }
    let position = |vertex: u32| sides.mesh.positions()[vertex as usize].as_dvec3();
    let (foot, tip, [one, other]) = (position(foot), position(tip), apexes.map(position));
    let largest = [foot, tip, one, other].into_iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    let rounding = largest * f64::from(f32::EPSILON) / 2.0;

    // Perpendicular to the edge, both faces are lines from its foot.
    let Some(along) = (tip - foot).try_normalize() else { return false };
    let rise = |apex: glam::DVec3| (apex - foot).reject_from_normalized(along);
    let (one, other) = (rise(one), rise(other));
    if one.length().min(other.length()) <= LEAST_HEIGHT * rounding || one.dot(other) <= 0.0 {
        return false;
    }
    let (lower, higher) = if one.length() < other.length() { (one, other) } else { (other, one) };
    lower.reject_from(higher).length() <= OFF_PLANE * rounding
}
