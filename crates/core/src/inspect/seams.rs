//! Seams: boundary edges that lie on each other, or nearly so, which welding closes.

use super::Sides;
use crate::id::HalfEdgeId;
use crate::mesh::TriangleMesh;
use crate::topology::Topology;
use crate::weld::{Welded, weld_exact, weld_within};
use glam::{DVec3, Vec3};
use std::collections::HashMap;

/// Boundary edges that [welding](crate::weld) joins in pairs.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Seams {
    /// The smallest distance within which vertices must be joined to close them all, in object units: 0 where their ends are at equal
    /// positions.
    pub distance: f32,
    /// How many boundary edges fewer there are then.
    pub boundary_edges: usize,
}

/// Share of the largest extent that the ends of a seam's edges may be apart.
const FARTHEST_SHARE: f64 = 1e-4;

/// The same as a share of the mean length of boundary edges: what is farther apart is a gap in a mesh so fine.
const FARTHEST_LENGTHS: f64 = 0.1;

impl Seams {
    /// The seams of a mesh, and the mesh without those of distance 0. O(V + F), expected.
    pub(super) fn of(sides: Sides) -> (Option<Self>, TriangleMesh, Topology) {
        let exact = weld_exact(sides.mesh).mesh;
        let topology = Topology::new(&exact);
        let near = nearest_pairs(&exact, &topology);
        let distance = near.into_iter().fold(0.0, f64::max);
        // Not below it.
        let distance = if distance == 0.0 { 0.0 } else { (distance as f32).next_up() };
        let after = match distance {
            0.0 => boundary_edges(&exact, &topology, 0.0),
            _ => weld_within(&exact, distance)
                .map_or(usize::MAX, |Welded { mesh, .. }| boundary_edges(&mesh, &Topology::new(&mesh), 0.0)),
        };
        // Welding makes shorter ones points, which is no seam.
        let closed = boundary_edges(sides.mesh, sides.topology, distance.into()).saturating_sub(after);
        ((closed > 0).then_some(Self { distance, boundary_edges: closed }), exact, topology)
    }
}

/// Boundary edges longer than a length.
fn boundary_edges(mesh: &TriangleMesh, topology: &Topology, length: f64) -> usize {
    let boundary = topology.edges().iter().filter(|&(edge, _)| topology.half_edges(edge).len() == 1);
    let lengths = boundary.map(|(_, edge)| {
        let [a, b] = edge.map(|vertex| mesh.positions()[vertex as usize]);
        distance(a, b)
    });
    lengths.filter(|&of_edge| of_edge > length).count()
}

/// For each boundary edge that runs close along another one, in the other direction, how far their ends are apart.
fn nearest_pairs(mesh: &TriangleMesh, topology: &Topology) -> Vec<f64> {
    let position = |vertex: u32| mesh.positions()[vertex as usize];
    let ends = |half_edge: HalfEdgeId| {
        let (triangle, slot) = (mesh.triangles()[half_edge.face().index()], half_edge.slot() as usize);
        [triangle[slot], triangle[(slot + 1) % 3]]
    };
    let edges = topology.edges().ids().filter_map(|edge| match topology.half_edges(edge) {
        [half_edge] => Some(ends(*half_edge)).filter(|[a, b]| a != b),
        _ => None,
    });
    let edges: Vec<[u32; 2]> = edges.collect();
    let Some(bounds) = mesh.bounds() else { return Vec::new() };
    let total: f64 = edges.iter().map(|&[a, b]| distance(position(a), position(b))).sum();
    let extent = (bounds.max - bounds.min).max_element();
    let reach = (FARTHEST_SHARE * extent).min(FARTHEST_LENGTHS * total / edges.len().max(1) as f64);
    if reach <= 0.0 {
        return Vec::new();
    }
    // By where they begin.
    let cell = |point: Vec3| ((point.as_dvec3() - bounds.min) / reach).floor().to_array().map(|c| c as i64);
    let mut starts: HashMap<[i64; 3], Vec<[u32; 2]>> = HashMap::new();
    for &edge in &edges {
        starts.entry(cell(position(edge[0]))).or_default().push(edge);
    }
    let nearest = |&[from, to]: &[u32; 2]| {
        let [x, y, z] = cell(position(to));
        let near = (0..27).map(|at| [x + at % 3 - 1, y + at / 3 % 3 - 1, z + at / 9 - 1]);
        let others = near.filter_map(|cell| starts.get(&cell)).flatten();
        let apart = others
            .map(|&[start, end]| distance(position(start), position(to)).max(distance(position(end), position(from))));
        apart.filter(|&apart| apart <= reach).reduce(f64::min)
    };
    edges.iter().filter_map(nearest).collect()
}

fn distance(a: Vec3, b: Vec3) -> f64 {
    let [a, b]: [DVec3; 2] = [a, b].map(Vec3::as_dvec3);
    a.distance(b)
}
