//! Section III-A, first half: feature edges are chained into maximal feature polylines.

use silhouette_core::glam::DVec3;
use silhouette_core::id::PerEdge;
use silhouette_core::{EdgeId, Topology, TriangleMesh, VertexId};

/// A maximal chain of feature edges.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FeaturePolyline {
    /// Its vertices in order; of a closed one the first is not repeated.
    pub vertices: Vec<VertexId>,
    /// The edge from each vertex to the next; of a closed one the last returns to the first.
    pub edges: Vec<EdgeId>,
    /// Whether it is closed.
    pub closed: bool,
}

/// Chains feature edges. A polyline continues at a vertex where exactly two feature edges meet and turn by less than
/// `corner_deg`; it ends where one, or three and more meet, and at sharper turns. Every feature edge but a side from a vertex to
/// itself belongs to exactly one polyline. Ordered by the lowest edge, at which an open polyline need not begin. O(V + E).
pub fn feature_polylines(
    mesh: &TriangleMesh,
    topology: &Topology,
    features: &PerEdge<bool>,
    corner_deg: f64,
) -> Vec<FeaturePolyline> {
    let mut at_vertex = vec![Meeting::None; mesh.vertex_count()];
    let proper = |edge: EdgeId| topology.end_points(edge)[0] != topology.end_points(edge)[1];
    for edge in features.ids().filter(|&edge| features[edge] && proper(edge)) {
        for vertex in topology.end_points(edge) {
            let met = &mut at_vertex[vertex.index()];
            *met = match *met {
                Meeting::None => Meeting::One(edge),
                Meeting::One(other) => Meeting::Two([other, edge]),
                Meeting::Two(_) | Meeting::More => Meeting::More,
            };
        }
    }
    let position = |vertex: VertexId| mesh.positions()[vertex.index()].as_dvec3();
    let other_end = |edge: EdgeId, vertex: VertexId| {
        let [a, b] = topology.end_points(edge);
        if a == vertex { b } else { a }
    };
    let least_cosine = corner_deg.to_radians().cos();
    let continues = |edge: EdgeId, vertex: VertexId| match at_vertex[vertex.index()] {
        Meeting::Two([a, b]) => {
            let next = if a == edge { b } else { a };
            let before = position(vertex) - position(other_end(edge, vertex));
            let after = position(other_end(next, vertex)) - position(vertex);
            (is_smooth_turn(before, after, least_cosine) || corner_deg >= 180.0).then_some(next)
        }
        _ => None,
    };

    let mut taken = PerEdge::from(vec![false; features.len()]);
    let mut polylines = Vec::new();
    for first in features.ids().filter(|&edge| features[edge] && proper(edge)) {
        if taken[first] {
            continue;
        }
        // Backwards from the lower end of the first edge to where the polyline begins, or around to the same edge.
        let (mut edge, mut start) = (first, topology.end_points(first)[0]);
        let mut closed = false;
        while let Some(previous) = continues(edge, start) {
            if previous == first {
                closed = true;
                break;
            }
            (edge, start) = (previous, other_end(previous, start));
        }
        if closed {
            (edge, start) = (first, topology.end_points(first)[0]);
        }
        let mut polyline = FeaturePolyline { vertices: vec![start], edges: Vec::new(), closed };
        loop {
            taken[edge] = true;
            polyline.edges.push(edge);
            let end = other_end(edge, polyline.vertices[polyline.vertices.len() - 1]);
            match continues(edge, end) {
                Some(next) if !taken[next] => {
                    polyline.vertices.push(end);
                    edge = next;
                }
                _ => {
                    if !closed {
                        polyline.vertices.push(end);
                    }
                    break;
                }
            }
        }
        polylines.push(polyline);
    }
    polylines
}

/// How many feature edges meet at a vertex.
#[derive(Debug, Clone, Copy)]
enum Meeting {
    None,
    One(EdgeId),
    Two([EdgeId; 2]),
    More,
}

fn is_smooth_turn(before: DVec3, after: DVec3, least_cosine: f64) -> bool {
    let lengths = before.length() * after.length();
    lengths > 0.0 && before.dot(after) > least_cosine * lengths
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::feature_edges::feature_edges;
    use silhouette_core::shapes::{self, Cuboid};

    fn polylines_of(mesh: &TriangleMesh, crease_deg: f64, corner_deg: f64) -> Vec<FeaturePolyline> {
        let topology = Topology::new(mesh);
        let features = feature_edges(mesh, &topology, &[], crease_deg);
        let polylines = feature_polylines(mesh, &topology, &features, corner_deg);
        let mut edges: Vec<_> = polylines.iter().flat_map(|polyline| polyline.edges.iter().copied()).collect();
        edges.sort_unstable();
        let expected: Vec<_> = features.ids().filter(|&edge| features[edge]).collect();
        assert_eq!(edges, expected, "each feature edge once");
        for polyline in &polylines {
            assert_eq!(polyline.vertices.len(), polyline.edges.len() + usize::from(!polyline.closed));
            for (i, &edge) in polyline.edges.iter().enumerate() {
                let next = polyline.vertices[(i + 1) % polyline.vertices.len()];
                assert_eq!(topology.find_edge(polyline.vertices[i], next), Some(edge));
            }
        }
        polylines
    }

    #[test]
    fn a_cylinder_has_two_closed_ones() {
        let cylinder = shapes::by_name("cylinder").unwrap();
        let polylines = polylines_of(&cylinder, 75.0, 75.0);
        assert_eq!(polylines.len(), 2);
        assert!(polylines.iter().all(|polyline| polyline.closed && polyline.edges.len() > 8));
    }

    #[test]
    fn three_faces_at_a_corner_end_them() {
        let cube = Cuboid::default().mesh().unwrap();
        let polylines = polylines_of(&cube, 75.0, 180.0);
        assert_eq!(polylines.len(), 12);
        assert!(polylines.iter().all(|polyline| polyline.edges.len() == 1 && !polyline.closed));
    }

    #[test]
    fn a_square_sheet_has_one_boundary_or_four_by_its_corners() {
        let sheet = shapes::by_name("grid:4,4").unwrap();
        let counts = [75.0, 180.0].map(|corner| polylines_of(&sheet, 180.0, corner).len());
        assert_eq!(counts, [4, 1]);
    }
}
