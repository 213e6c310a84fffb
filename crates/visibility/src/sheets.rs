//! Whether surfaces pass through each other along the line that two of their faces have in common.
//!
//! Where the line runs inside of both faces, they do. Where it is an edge of a face, it depends on what else is at the edge:
//! around the line, the half-planes of one surface must come between those of the other.

use silhouette_core::glam::Vec3;
use silhouette_core::orientation::orientation;
use silhouette_core::{EdgeId, FaceId, HalfEdgeId, Topology, TriangleMesh};

/// A surface at a line.
struct Sheet {
    /// Points off the line, one in each half-plane of the surface.
    apexes: Vec<Vec3>,
    /// The edge that lies on the line, and the lowest of the faces there.
    edge: Option<(EdgeId, FaceId)>,
}

/// Whether the surfaces of two faces that have a line in common, and are not of one plane, pass through each other there. Of
/// several pairs of faces along one line, only the lowest does. Exact. O(faces at the edges of both).
pub fn pass_through(mesh: &TriangleMesh, topology: &Topology, faces: [FaceId; 2]) -> bool {
    let [one, other] = faces;
    let sheets = [sheet(mesh, topology, one, other), sheet(mesh, topology, other, one)];
    let line = match (&sheets[0].edge, &sheets[1].edge) {
        (None, None) => return true,
        (Some((edge, _)), _) | (None, Some((edge, _))) => {
            topology.edges()[*edge].map(|vertex| mesh.positions()[vertex as usize])
        }
    };
    let is_lowest = |sheet: &Sheet, face: FaceId| sheet.edge.is_none_or(|(_, lowest)| lowest == face);
    is_lowest(&sheets[0], one) && is_lowest(&sheets[1], other) && interleave(line, &sheets[0].apexes, &sheets[1].apexes)
}

/// The surface of a face along the line in which it meets the plane of another.
fn sheet(mesh: &TriangleMesh, topology: &Topology, face: FaceId, other: FaceId) -> Sheet {
    let [u, v, w] = mesh.corners(other);
    let corners = mesh.corners(face);
    let lies_in_plane = corners.map(|corner| orientation(u, v, w, corner) == 0.0);
    match (0..3).find(|&slot| lies_in_plane[slot] && lies_in_plane[(slot + 1) % 3]) {
        None => {
            // The line runs through the face: corners on either side of the plane.
            Sheet {
                apexes: corners.into_iter().zip(lies_in_plane).filter(|(_, lies)| !lies).map(|(at, _)| at).collect(),
                edge: None,
            }
        }
        Some(slot) => {
            let edge = topology.edge_of(HalfEdgeId::of(face, slot as u32));
            let at_edge = topology.half_edges(edge);
            let apex = |half_edge: &HalfEdgeId| mesh.corners(half_edge.face())[(half_edge.slot() as usize + 2) % 3];
            let lowest = at_edge.iter().map(|half_edge| half_edge.face()).min().unwrap_or(face);
            Sheet { apexes: at_edge.iter().map(apex).collect(), edge: Some((edge, lowest)) }
        }
    }
}

/// Whether half-planes of one surface lie strictly on both sides of two of another, around their common line.
fn interleave([a, b]: [Vec3; 2], ones: &[Vec3], others: &[Vec3]) -> bool {
    let turn = |from: Vec3, to: Vec3| {
        let value = orientation(a, b, from, to);
        i32::from(value > 0.0) - i32::from(value < 0.0)
    };
    // On the line's side of `from` towards `to`, counter-clockwise; `None` on either of them.
    let is_between = |from: Vec3, to: Vec3, at: Vec3| {
        let (of_to, of_at, beyond) = (turn(from, to), turn(from, at), turn(at, to));
        let lies_on = |half_plane: Vec3| turn(half_plane, at) == 0 && is_same_side(a, b, half_plane, at);
        if lies_on(from) || lies_on(to) {
            return None;
        }
        Some(match of_to {
            1 => of_at > 0 && beyond > 0,
            -1 => of_at > 0 || beyond > 0,
            _ => of_at > 0,
        })
    };
    ones.iter().enumerate().any(|(index, &from)| {
        ones[index + 1..].iter().any(|&to| {
            let mut sides = others.iter().filter_map(|&at| is_between(from, to, at));
            let Some(first) = sides.next() else { return false };
            sides.any(|side| side != first)
        })
    })
}

/// Whether two points of one plane through a line lie on one side of the line.
fn is_same_side(a: Vec3, b: Vec3, one: Vec3, other: Vec3) -> bool {
    let step = a.abs().max(b.abs()).max(one.abs()).max(other.abs()).max_element();
    // A point off the plane, whichever way the plane lies.
    [Vec3::X, Vec3::Y, Vec3::Z].into_iter().any(|axis| {
        let off = a + axis * if a.dot(axis) > 0.0 { -step } else { step };
        orientation(a, b, off, one) * orientation(a, b, off, other) > 0.0
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_planes_interleave_as_hands_of_a_clock() {
        let hand = |hour: u32| {
            let angle = f64::from(hour) * std::f64::consts::TAU / 12.0;
            Vec3::new(angle.cos() as f32, angle.sin() as f32, 0.3)
        };
        let line = [Vec3::ZERO, Vec3::Z];
        let pass = |ones: &[u32], others: &[u32]| {
            let hands = |hours: &[u32]| hours.iter().map(|&hour| hand(hour)).collect::<Vec<_>>();
            let found = interleave(line, &hands(ones), &hands(others));
            assert_eq!(found, interleave(line, &hands(others), &hands(ones)), "{ones:?} {others:?}");
            found
        };
        assert!(pass(&[0, 5], &[2, 8]) && pass(&[1, 8], &[4, 11]));
        assert!(!pass(&[0, 2], &[4, 8]) && !pass(&[0, 8], &[2, 4]));
        assert!(!pass(&[0, 5], &[2]), "a surface that ends there");
        assert!(!pass(&[0, 5], &[0, 2]) && !pass(&[0, 5], &[0, 5]), "surfaces that lie on each other");
        assert!(pass(&[0, 5], &[2, 3, 9]), "three at one edge");
    }
}
