//! Mending of T-junctions: where a vertex lies on an edge that it does not divide.
//!
//! Constructive solid geometry, decimation and tessellators that work face by face leave meshes in which one face has a
//! long edge where its neighbours have two short ones. No edge joins the faces there, so that all three are boundary edges
//! in the middle of a flat side. [`heal_t_junctions`] divides the long edge, and with it its face.

use crate::id::{FaceId, HalfEdgeId};
use crate::mesh::TriangleMesh;
use crate::topology::Topology;
use crate::weld::{WeldError, weld_within};
use glam::DVec3;
use std::collections::HashMap;

/// A healed mesh, and what became of the old one.
#[derive(Debug, Clone, PartialEq)]
pub struct Healed {
    /// The mesh. Vertices are those that welding leaves, in their order; faces keep their order, each divided one being
    /// followed by its parts.
    pub mesh: TriangleMesh,
    /// For each face of the new mesh its face in the old one.
    pub face_of: Vec<FaceId>,
    /// For each vertex of the old mesh its vertex in the new one.
    pub vertex_of: Vec<u32>,
    /// Edges that were divided.
    pub divided: usize,
    /// Faces that were left out because they are no higher than the distance: fillings of T-junctions.
    pub left_out: usize,
}

/// Merges vertices no farther apart than `distance` (object units), leaves out faces no higher than that, and divides
/// every boundary edge at the vertices of other boundary edges that lie no farther from it than that.
///
/// A divided face is bent by at most the distance. O(F + boundary edges x their length in units of the mean boundary edge),
/// expected.
///
/// # Errors
/// [`WeldError::Tolerance`] where `distance` is negative, infinite or NaN.
///
/// # Panics
/// Where the divided mesh would have more than [`MAX_FACES`](crate::mesh::MAX_FACES) faces.
pub fn heal_t_junctions(mesh: &TriangleMesh, distance: f32) -> Result<Healed, WeldError> {
    let welded = weld_within(mesh, distance)?;
    let distance = f64::from(distance);
    let place = |vertex: u32| welded.mesh.positions()[vertex as usize].as_dvec3();
    let is_high = |triangle: &[u32; 3]| height(triangle.map(place)) > distance;
    let kept: Vec<(FaceId, [u32; 3])> = (0..)
        .map(FaceId::new)
        .zip(welded.mesh.triangles().iter().copied())
        .filter(|(_, triangle)| is_high(triangle))
        .collect();
    let left_out = mesh.face_count() - kept.len();
    let positions = welded.mesh.positions().to_vec();
    let triangles: Vec<[u32; 3]> = kept.iter().map(|(_, triangle)| *triangle).collect();
    let without = TriangleMesh::new(positions.clone(), triangles).expect("some faces of a valid mesh are a valid mesh");
    let topology = Topology::new(&without);
    let dividers = dividers(&without, &boundary_of(&topology), distance);

    let (mut triangles, mut face_of) = (Vec::with_capacity(without.face_count()), Vec::new());
    for (index, &(face, corners)) in kept.iter().enumerate() {
        let on_side = [0, 1, 2].map(|slot| {
            let half_edge = HalfEdgeId::of(FaceId::from_usize(index), slot);
            dividers.get(&half_edge).map_or(&[][..], Vec::as_slice)
        });
        divide(corners, on_side, &mut triangles);
        face_of.resize(triangles.len(), face);
    }
    let healed = TriangleMesh::new(positions, triangles).expect("parts of valid faces are valid");
    let mesh = healed.with_origin(mesh.origin());
    Ok(Healed { mesh, face_of, vertex_of: welded.vertex_of, divided: dividers.len(), left_out })
}

/// The T-junctions of a mesh that [`heal_t_junctions`] would mend.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct TJunctions {
    /// Boundary edges with a vertex of another one in between.
    pub edges: usize,
    /// The largest distance of such a vertex from its edge, in object units. To heal by this distance mends them all.
    pub largest_distance: f64,
}

/// Share of the largest extent within which vertices are looked for that divide an edge without touching it: rounding moves none
/// farther in a file of seven digits.
pub const NEAR_SHARE: f64 = 1e-6;

/// The T-junctions of a mesh without seams (see [`weld`](crate::weld)), of which `topology` must be the topology, no farther apart than
/// [`NEAR_SHARE`] of the largest extent; `None` if there are none. O(boundary edges x their length in units of the mean one), expected.
pub fn find_t_junctions(mesh: &TriangleMesh, topology: &Topology) -> Option<TJunctions> {
    let bounds = mesh.bounds()?;
    let distance = NEAR_SHARE * (bounds.max - bounds.min).max_element();
    let dividers = dividers(mesh, &boundary_of(topology), distance);
    let mut largest_distance = 0.0;
    for (half_edge, vertices) in &dividers {
        let (triangle, slot) = (mesh.triangles()[half_edge.face().index()], half_edge.slot() as usize);
        let place = |vertex: u32| mesh.positions()[vertex as usize].as_dvec3();
        let [from, to] = [triangle[slot], triangle[(slot + 1) % 3]].map(place);
        for &vertex in vertices {
            let distance = (place(vertex) - from).cross(to - from).length() / from.distance(to);
            largest_distance = f64::max(largest_distance, distance);
        }
    }
    (!dividers.is_empty()).then_some(TJunctions { edges: dividers.len(), largest_distance })
}

/// The sides of faces that are boundary edges.
fn boundary_of(topology: &Topology) -> Vec<HalfEdgeId> {
    let sides = topology.edges().ids().filter_map(|edge| match topology.half_edges(edge) {
        [half_edge] => Some(*half_edge),
        _ => None,
    });
    sides.collect()
}

/// The least height of a triangle: over its longest side. 0 for one without area.
fn height([a, b, c]: [DVec3; 3]) -> f64 {
    let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
    if longest > 0.0 { (b - a).cross(c - a).length() / longest } else { 0.0 }
}

/// For each boundary edge that is to be divided the vertices that lie on it, in the order along it.
fn dividers(mesh: &TriangleMesh, boundary: &[HalfEdgeId], distance: f64) -> HashMap<HalfEdgeId, Vec<u32>> {
    let ends = |half_edge: HalfEdgeId| {
        let (triangle, slot) = (mesh.triangles()[half_edge.face().index()], half_edge.slot() as usize);
        [triangle[slot], triangle[(slot + 1) % 3]]
    };
    let place = |vertex: u32| mesh.positions()[vertex as usize].as_dvec3();
    let length = |half_edge: HalfEdgeId| {
        let [from, to] = ends(half_edge).map(place);
        from.distance(to)
    };
    let lengths = boundary.iter().map(|&half_edge| length(half_edge));
    let (sum, longest) = lengths.fold((0.0, 0.0), |(sum, longest), length| (sum + length, f64::max(longest, length)));
    // Cells of the mean edge's size: an edge passes few, and few vertices share one. No coordinate is so large that a cell has no number.
    let side = (sum / boundary.len().max(1) as f64).max(longest * LEAST_CELL).max(4.0 * distance);
    let mut vertices: Vec<u32> = boundary.iter().flat_map(|&half_edge| ends(half_edge)).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let cell = |point: DVec3| (point / side).floor().to_array().map(|c| c as i64);
    let mut grid: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
    vertices.iter().for_each(|&vertex| grid.entry(cell(place(vertex))).or_default().push(vertex));

    let mut dividers = HashMap::new();
    let mut found: Vec<(f64, u32)> = Vec::new();
    for &half_edge in boundary {
        let corners = mesh.triangles()[half_edge.face().index()];
        let [from, to] = ends(half_edge).map(place);
        let (along, length) = (to - from, from.distance(to));
        found.clear();
        // Points half a cell apart have all cells near the edge among their neighbours.
        let steps = (2.0 * length / side).ceil().max(1.0);
        let mut look_at = |vertex: u32| {
            let point = place(vertex);
            let share = (point - from).dot(along) / (length * length);
            let is_inside = share > 0.0
                && share < 1.0
                && point.distance(from) > distance
                && point.distance(to) > distance
                && !corners.contains(&vertex);
            if is_inside && (point - from).cross(along).length() <= distance * length {
                found.push((share, vertex));
            }
        };
        if 27.0 * steps > vertices.len() as f64 {
            // An edge far longer than most.
            vertices.iter().for_each(|&vertex| look_at(vertex));
        } else {
            for step in 0..=steps as u32 {
                let [x, y, z] = cell(from.lerp(to, f64::from(step) / steps));
                for neighbour in 0..27 {
                    let near = [x + neighbour % 3 - 1, y + neighbour / 3 % 3 - 1, z + neighbour / 9 - 1];
                    grid.get(&near).into_iter().flatten().for_each(|&vertex| look_at(vertex));
                }
            }
        }
        found.sort_unstable_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
        found.dedup();
        if !found.is_empty() {
            dividers.insert(half_edge, found.iter().map(|&(_, vertex)| vertex).collect());
        }
    }
    dividers
}

/// The least side of a cell as a share of the longest edge.
const LEAST_CELL: f64 = 1e-9;

/// Appends the parts of a triangle that has vertices on its sides: fans from the corner opposite of one side, of which the
/// first and the last part have the other two.
fn divide([a, b, c]: [u32; 3], [on_ab, on_bc, on_ca]: [&[u32]; 3], out: &mut Vec<[u32; 3]>) {
    if on_ab.is_empty() && on_bc.is_empty() && on_ca.is_empty() {
        out.push([a, b, c]);
    } else if on_ab.is_empty() {
        // Another side first.
        divide([b, c, a], [on_bc, on_ca, on_ab], out);
    } else {
        let last = on_ab.len() - 1;
        divide([a, on_ab[0], c], [&[], &[], on_ca], out);
        out.extend(on_ab.windows(2).map(|pair| [pair[0], pair[1], c]));
        divide([on_ab[last], b, c], [&[], on_bc, &[]], out);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use proptest::prelude::*;

    fn mesh(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> TriangleMesh {
        TriangleMesh::new(positions.iter().copied().map(Vec3::from).collect(), triangles.to_vec()).unwrap()
    }

    fn area(mesh: &TriangleMesh) -> f64 {
        let of = |triangle: &[u32; 3]| {
            let [a, b, c] = triangle.map(|vertex| mesh.positions()[vertex as usize].as_dvec3());
            (b - a).cross(c - a).length() * 0.5
        };
        mesh.triangles().iter().map(of).sum()
    }

    /// A square of two triangles, one divided in the middle of the diagonal.
    const CORNERS: [[f32; 3]; 5] =
        [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0], [1.0, 1.0, 0.0]];

    #[test]
    fn a_t_junction_is_mended_filled_or_not() {
        let open = mesh(&CORNERS, &[[0, 1, 2], [0, 4, 3], [4, 2, 3]]);
        let filled = mesh(&CORNERS, &[[0, 1, 2], [0, 2, 4], [0, 4, 3], [4, 2, 3]]);
        for (mesh, left_out) in [(open, 0), (filled, 1)] {
            assert!(Topology::new(&mesh).boundary_edge_count() != 4 || left_out == 1);
            let healed = heal_t_junctions(&mesh, 0.0).unwrap();
            assert_eq!((healed.divided, healed.left_out, healed.mesh.face_count()), (1, left_out, 4));
            assert_eq!(Topology::new(&healed.mesh).boundary_edge_count(), 4, "the square's sides");
            assert!((area(&healed.mesh) - 4.0).abs() < 1e-12);
            assert_eq!(healed.face_of[..2], [FaceId::new(0); 2]);
        }
    }

    #[test]
    fn the_distance_decides() {
        let mut corners = CORNERS;
        corners[4][0] += 0.01;
        let mesh = mesh(&corners, &[[0, 1, 2], [0, 4, 3], [4, 2, 3]]);
        assert_eq!(heal_t_junctions(&mesh, 0.001).unwrap().divided, 0);
        assert_eq!(heal_t_junctions(&mesh, 0.01).unwrap().divided, 1);
        assert!(heal_t_junctions(&mesh, f32::NAN).is_err());
    }

    proptest! {
        /// Any number of vertices on any side: the parts have the same area, run the same way and name each vertex.
        #[test]
        fn a_divided_triangle_is_the_sum_of_its_parts(counts in prop::array::uniform3(0_u32..4)) {
            let corners = [Vec3::ZERO, Vec3::new(3.0, 0.0, 0.0), Vec3::new(1.0, 2.0, 0.0)];
            let mut positions = corners.to_vec();
            let mut sides: [Vec<u32>; 3] = Default::default();
            for slot in 0..3 {
                for step in 1..=counts[slot] {
                    sides[slot].push(positions.len() as u32);
                    positions.push(corners[slot].lerp(corners[(slot + 1) % 3], step as f32 / (counts[slot] + 1) as f32));
                }
            }
            let mut parts = Vec::new();
            divide([0, 1, 2], [&sides[0], &sides[1], &sides[2]], &mut parts);
            let count: u32 = counts.iter().sum();
            prop_assert_eq!(parts.len() as u32, 1 + count);
            let turn = |&[a, b, c]: &[u32; 3]| {
                let [a, b, c] = [a, b, c].map(|vertex| positions[vertex as usize].as_dvec3());
                (b - a).cross(c - a).z
            };
            prop_assert!(parts.iter().all(|part| turn(part) > 1e-6), "{:?}", parts);
            prop_assert!((parts.iter().map(turn).sum::<f64>() - 6.0).abs() < 1e-5);
            let mut named: Vec<u32> = parts.into_iter().flatten().collect();
            named.sort_unstable();
            named.dedup();
            prop_assert_eq!(named.len(), positions.len());
        }
    }
}
