//! Where azimuths begin, T, at each vertex of the hull (section 3.3).
//!
//! The paper leaves T to a library that derives it from texture coordinates. Here T is chosen for what it is used for: as even as
//! can be, so that T interpolated over a face neither turns quickly nor cancels. A tangent is a complex number in a basis across
//! C at its vertex. Carried along an edge by the least rotation that takes one C to the other, it is compared with its neighbour:
//! the field that agrees best with itself is the eigenvector of the averaging of neighbours for the largest eigenvalue, and
//! [`SWEEPS`] power iterations come close to it. F. Knoeppel, K. Crane, U. Pinkall and P. Schroeder, "Globally Optimal Direction
//! Fields", ACM Transactions on Graphics 32 (4), 2013, section 3, with uniform weights.
//!
//! On a sphere no field is without zeros; around one, T turns once within the few texels next to it, and azimuths there are
//! blurred. Wherever T vanishes, [`Frame`] replaces it, for baker and renderer alike.

use crate::frame::Frame;
use crate::hull::Hull;
use glam::{DVec2, Quat, Vec3};
use silhouette_core::{EdgeId, Topology, glam};

/// Power iterations. The distance over which the field evens out grows with the square root of their number: here about 30 edges.
pub const SWEEPS: usize = 1000;

/// T for each vertex of the hull, unit, across C. Follows from the order of vertices alone. O(E x [`SWEEPS`]).
pub fn tangents(hull: &Hull, centers: &[Vec3]) -> Vec<Vec3> {
    let topology = Topology::new(hull.mesh());
    let frames: Vec<Frame> = centers.iter().map(|&center| Frame::new(center, Vec3::ZERO)).collect();
    // Per edge: its ends, and the turn that carries tangents from the first to the second.
    let links: Vec<(usize, usize, DVec2)> = (0..topology.edge_count())
        .map(EdgeId::from_usize)
        .map(|edge| topology.end_points(edge).map(silhouette_core::VertexId::index))
        .filter(|[a, b]| a != b)
        .map(|[a, b]| (a, b, turn(&frames[a], &frames[b])))
        .collect();
    let mut degrees = vec![0.0_f64; centers.len()];
    for &(a, b, _) in &links {
        degrees[a] += 1.0;
        degrees[b] += 1.0;
    }
    let mut field = vec![DVec2::X; centers.len()];
    for _ in 0..SWEEPS {
        let mut sums = vec![DVec2::ZERO; field.len()];
        for &(a, b, turn) in &links {
            sums[b] += turn.rotate(field[a]);
            sums[a] += DVec2::new(turn.x, -turn.y).rotate(field[b]);
        }
        // Half of itself keeps the iteration from swinging on bipartite parts.
        let mut largest = 0.0_f64;
        for ((value, sum), degree) in field.iter_mut().zip(sums).zip(&degrees) {
            *value = *value * 0.5 + sum * (0.5 / degree.max(1.0));
            largest = largest.max(value.length());
        }
        if largest > 0.0 {
            field.iter_mut().for_each(|value| *value /= largest);
        }
    }
    let tangent = |(frame, value): (&Frame, DVec2)| {
        let unit = value.try_normalize().unwrap_or(DVec2::X).as_vec2();
        (unit.x * frame.tangent + unit.y * frame.binormal).normalize()
    };
    frames.iter().zip(field).map(tangent).collect()
}

/// The complex number that takes coordinates in one frame to those in another, after the least rotation of one C to the other.
fn turn(from: &Frame, to: &Frame) -> DVec2 {
    let carried = Quat::from_rotation_arc(from.center, to.center) * from.tangent;
    DVec2::new(f64::from(carried.dot(to.tangent)), f64::from(carried.dot(to.binormal))).normalize_or(DVec2::X)
}
