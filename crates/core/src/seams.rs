//! Seams that welding would close: boundary edges that lie on each other, or nearly so, over vertices of their own.
//!
//! Exporters split vertices along seams of texture coordinates, normals and materials, and write them rounded. What is one surface
//! to its author is then open: each seam is drawn as two boundaries, and no crease or silhouette is found along it.

use crate::id::{EdgeId, FaceId};
use crate::mesh::TriangleMesh;
use crate::topology::Topology;
use crate::weld::ExactPositions;
use glam::{DVec3, Vec3};
use std::collections::HashMap;

/// Boundary edges that [`weld`](crate::weld) would join to others.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize)]
pub struct OpenSeams {
    /// How many there are. A lower bound where hundreds of edges of one length crowd in one place.
    pub edges: usize,
    /// The distance within which their ends lie, in object units, rounded up to two digits: 0 where they coincide. Welding within
    /// it joins them.
    pub distance: f32,
}

/// Ends of two edges that lie within this share of their length may be ends of one edge.
const NEARNESS: f64 = 0.01;

/// Most edges that one is compared with in each of the cells around it, which bounds the work.
const MOST_COMPARED: usize = 32;

impl OpenSeams {
    /// The open seams of a mesh, of which `topology` must be the topology. O(E + boundary edges), expected.
    pub fn of(mesh: &TriangleMesh, topology: &Topology) -> Self {
        let boundary = topology.edges().ids().filter(|&edge| topology.half_edges(edge).len() == 1);
        Self::among(mesh, topology, boundary)
    }

    /// The open seams among some boundary edges. Edges lie on each other if both ends coincide or lie within a hundredth of their
    /// length, unless they are sides of one face. O(edges), expected.
    pub fn among(mesh: &TriangleMesh, topology: &Topology, boundary: impl IntoIterator<Item = EdgeId>) -> Self {
        let position = |vertex: u32| mesh.positions()[vertex as usize];
        let mut places = ExactPositions::default();
        let mut ends_of: HashMap<[u32; 2], (u32, Side)> = HashMap::new();
        for edge in boundary {
            let ends = topology.edges()[edge].map(position);
            let mut place = ends.map(|end| places.id_of(end));
            place.sort_unstable();
            if place[0] != place[1] {
                let face = topology.half_edges(edge)[0].face();
                ends_of.entry(place).or_insert((0, Side { ends: ends.map(Vec3::as_dvec3), face })).0 += 1;
            }
        }
        let coinciding: usize =
            ends_of.values().filter(|(count, _)| *count > 1).map(|&(count, _)| count as usize).sum();
        // In the order of their places, so that equal meshes have equal seams.
        let mut single: Vec<_> = ends_of.into_iter().filter(|(_, (count, _))| *count == 1).collect();
        single.sort_unstable_by_key(|&(place, _)| place);
        let single: Vec<Side> = single.into_iter().map(|(_, (_, side))| side).collect();
        let near = near_edges(&single);
        let distance = near.iter().copied().flatten().fold(0.0, f64::max);
        Self { edges: coinciding + near.iter().flatten().count(), distance: rounded_up(distance) }
    }
}

/// A boundary edge.
struct Side {
    ends: [DVec3; 2],
    /// A face at it.
    face: FaceId,
}

/// For each edge how far the ends of the nearest other one are from its own, if that is near.
fn near_edges(edges: &[Side]) -> Vec<Option<f64>> {
    let mut grid: HashMap<Cell, Vec<u32>> = HashMap::new();
    for (index, Side { ends, .. }) in edges.iter().enumerate() {
        let class = class_of(ends[0].distance(ends[1]));
        let entries = grid.entry(cell(class, place_in(class, ends).floor())).or_default();
        if entries.len() < MOST_COMPARED {
            entries.push(index as u32);
        }
    }
    let nearest = |Side { ends, face }: &Side| {
        let length = ends[0].distance(ends[1]);
        let classes = [length * (1.0 - 3.0 * NEARNESS), length, length * (1.0 + 3.0 * NEARNESS)].map(class_of);
        let mut nearest: Option<f64> = None;
        for (rank, &class) in classes.iter().enumerate() {
            if classes[..rank].contains(&class) {
                continue;
            }
            let scaled = place_in(class, ends);
            let own = scaled.floor();
            let nearer = own + DVec3::select((scaled - own).cmplt(DVec3::splat(0.5)), DVec3::NEG_ONE, DVec3::ONE);
            for corner in 0..8 {
                let axis = |i: usize| if corner >> i & 1 == 0 { own[i] } else { nearer[i] };
                let found = grid.get(&cell(class, DVec3::new(axis(0), axis(1), axis(2))));
                let others = found.into_iter().flatten().map(|&other| &edges[other as usize]);
                // Among them is this edge itself.
                for other in others.filter(|other| other.face != *face) {
                    let distance = distance(ends, &other.ends);
                    if distance <= NEARNESS * length && nearest.is_none_or(|least| distance < least) {
                        nearest = Some(distance);
                    }
                }
            }
        }
        nearest
    };
    edges.iter().map(nearest).collect()
}

/// A class of lengths, and a cell of the grid of that class.
type Cell = (i32, [u64; 3]);

/// Lengths of one class differ by less than a factor of two.
fn class_of(length: f64) -> i32 {
    length.log2().floor() as i32
}

/// The middle of an edge in cells of a class: their sides are at least twice what the middles of near edges lie apart, so that those
/// are in the edge's own cell or in the nearer one along each axis.
fn place_in(class: i32, [a, b]: &[DVec3; 2]) -> DVec3 {
    (*a + *b) / (8.0 * NEARNESS * f64::from(class).exp2())
}

fn cell(class: i32, place: DVec3) -> Cell {
    (class, place.to_array().map(|coordinate| (coordinate + 0.0).to_bits()))
}

/// The larger distance between the ends of two edges, whichever way they run.
fn distance([a, b]: &[DVec3; 2], [p, q]: &[DVec3; 2]) -> f64 {
    let along = a.distance(*p).max(b.distance(*q));
    along.min(a.distance(*q).max(b.distance(*p)))
}

/// The next number of two digits that is no less.
fn rounded_up(distance: f64) -> f32 {
    if distance <= 0.0 {
        return 0.0;
    }
    let step = 10_f64.powf(distance.log10().floor() - 1.0);
    let rounded = ((distance / step).ceil() * step) as f32;
    if f64::from(rounded) < distance { rounded.next_up() } else { rounded }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes;
    use crate::weld::weld_within;
    use proptest::prelude::*;

    /// The mesh with the faces for which `apart` holds over vertices of their own, moved by `by`.
    fn torn(mesh: &TriangleMesh, by: Vec3, apart: impl Fn(usize) -> bool) -> TriangleMesh {
        let count = mesh.vertex_count() as u32;
        let positions = mesh.positions().iter().copied().chain(mesh.positions().iter().map(|&place| place + by));
        let corners =
            |(face, &corners): (usize, &[u32; 3])| corners.map(|at| if apart(face) { at + count } else { at });
        TriangleMesh::new(positions.collect(), mesh.triangles().iter().enumerate().map(corners).collect()).unwrap()
    }

    fn seams(mesh: &TriangleMesh) -> OpenSeams {
        OpenSeams::of(mesh, &Topology::new(mesh))
    }

    fn boundary_edges(mesh: &TriangleMesh) -> usize {
        Topology::new(mesh).boundary_edge_count()
    }

    #[test]
    fn closed_and_open_surfaces_have_no_seams() {
        for name in ["cube", "torus", "grid", "icosphere:3", "knot"] {
            assert_eq!(seams(&shapes::by_name(name).unwrap()), OpenSeams::default(), "{name}");
        }
    }

    proptest! {
        /// What is torn along an edge is closed by the distance that is found, and by no much smaller one.
        #[test]
        fn welding_within_the_distance_closes_the_seams(
            modulus in 2..9_usize, shift in 0.0..1.5_f64, scale in -12..12_i32, far in any::<bool>(),
        ) {
            let scale = 10_f32.powi(scale);
            let sphere = shapes::by_name("icosphere:2").unwrap();
            let center = if far { Vec3::splat(50.0 * scale) } else { Vec3::ZERO };
            let positions = sphere.positions().iter().map(|&place| place * scale + center).collect();
            let sphere = TriangleMesh::new(positions, sphere.triangles().to_vec()).unwrap();
            // Edges are 0.28 to 0.33 long, so that a hundredth is reached at a shift of 1.
            let by = Vec3::new(0.6, 0.0, 0.8) * (0.0028 * shift) as f32 * scale;
            let mesh = torn(&sphere, by, |face| face % modulus == 0);
            let (found, open) = (seams(&mesh), boundary_edges(&mesh));
            if shift < 0.95 {
                prop_assert_eq!(found.edges, open);
                let welded = weld_within(&mesh, found.distance).unwrap().mesh;
                prop_assert_eq!(boundary_edges(&welded), 0, "{:?}", found);
                if shift > 0.1 {
                    let less = weld_within(&mesh, found.distance * 0.8).unwrap().mesh;
                    prop_assert!(boundary_edges(&less) > 0, "{:?}", found);
                }
            } else if shift > 1.3 {
                prop_assert_eq!(found.edges, 0);
            }
        }
    }

    #[test]
    fn distances_are_rounded_up_to_two_digits() {
        for (distance, expected) in [(0.0, 0.0), (1e-4, 1e-4), (1.01e-4, 1.1e-4), (0.123, 0.13), (9.95, 10.0)] {
            let rounded = rounded_up(distance);
            assert!(f64::from(rounded) >= distance && (rounded - expected).abs() <= expected * 1e-5, "{rounded}");
        }
    }

    #[test]
    fn two_sides_of_a_needle_are_no_seam() {
        let corners = vec![Vec3::ZERO, Vec3::new(10.0, 0.0, 0.0), Vec3::new(10.0, 0.01, 0.0)];
        assert_eq!(seams(&TriangleMesh::new(corners, vec![[0, 1, 2]]).unwrap()), OpenSeams::default());
    }

    /// A crowd of copies is counted in one pass, and a crowd of near edges in bounded time.
    #[test]
    fn crowds_are_bounded() {
        let fan = |step: f32| {
            let count = 20_000_u32;
            let positions = (0..count).flat_map(|copy| {
                let place = Vec3::X * step * copy as f32;
                [place, place + Vec3::Y, place + Vec3::Z]
            });
            let triangles = (0..count).map(|copy| [3 * copy, 3 * copy + 1, 3 * copy + 2]);
            seams(&TriangleMesh::new(positions.collect(), triangles.collect()).unwrap())
        };
        assert_eq!(fan(0.0), OpenSeams { edges: 60_000, distance: 0.0 });
        assert!(fan(1e-7).edges > 0);
    }
}
