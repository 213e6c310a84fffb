//! [`found_edges`]: edges by the vertices that another program names; [`visible_parts`]: what is seen of them.

use super::error::ForeignFault;
use super::trace::Polyline;
use crate::truth::visible::VisibleLine;
use crate::truth::{Truth, TruthError, TruthFinder};
use silhouette_core::{EdgeId, Progress, SilhouetteEdges, Topology, VertexId};
use silhouette_visibility::{Chain, LineOptions, SegmentSource};

/// The edges between pairs of vertices, each once. O(S log E).
///
/// # Errors
/// [`ForeignFault::OtherMesh`] names the first pair that is no edge of the mesh, which is called `mesh`.
pub fn found_edges(
    pairs: &[[u32; 2]],
    topology: &Topology,
    vertices: usize,
    mesh: &str,
) -> Result<SilhouetteEdges, ForeignFault> {
    let mut edges = Vec::with_capacity(pairs.len());
    for (at, pair) in pairs.iter().enumerate() {
        let other = |found: String, wanted: String| ForeignFault::OtherMesh {
            place: format!("edges[{at}]"),
            found,
            mesh: mesh.to_owned(),
            wanted,
        };
        if let Some(vertex) = pair.iter().find(|&&vertex| vertex as usize >= vertices) {
            return Err(other(format!("names vertex {vertex}"), format!("{vertices} vertices, from 0")));
        }
        let [a, b] = pair.map(VertexId::new);
        let edge = topology.find_edge(a, b);
        edges.push(edge.ok_or_else(|| other(format!("is [{a}, {b}]"), "no face with such an edge".to_owned()))?);
    }
    let mut found = SilhouetteEdges::default();
    found.refill(edges);
    Ok(found)
}

/// The visible parts of edges in a view. Parts of silhouette edges are those of the truth to the bit. O(S log S); where some are no
/// silhouette edges, as much as the visible lines of all edges of the mesh take.
///
/// # Errors
/// [`TruthError`] where some are no silhouette edges, and a drawing of all edges is too crowded to be decided.
pub fn visible_parts(
    found: &SilhouetteEdges,
    truth: &Truth,
    finder: &mut TruthFinder,
    progress: &dyn Progress,
) -> Result<Vec<Polyline>, TruthError> {
    let mut parts = Vec::new();
    for line in &truth.visible {
        keep(line, found, &mut parts);
    }
    if found.iter().any(|edge| !truth.edges.contains(edge)) {
        let every_edge = LineOptions {
            silhouette: false,
            boundary: false,
            mesh: true,
            ..crate::truth::finder::silhouette_options()
        };
        let lines = finder.find_lines(&truth.camera, &every_edge, progress)?;
        let mut others = SilhouetteEdges::default();
        others.refill(found.iter().filter(|&edge| !truth.edges.contains(edge)));
        for chain in lines.chains.iter() {
            if let Some(line) = line_of(&chain) {
                keep(&line, &others, &mut parts);
            }
        }
    }
    Ok(parts)
}

/// A chain whose segments all lie on edges.
fn line_of(chain: &Chain<'_>) -> Option<VisibleLine> {
    let edge = |source: &SegmentSource| if let SegmentSource::Edge(edge) = source { Some(*edge) } else { None };
    let edges: Option<Vec<EdgeId>> = chain.sources.iter().map(edge).collect();
    Some(VisibleLine { points: chain.pixels.to_vec(), edges: edges?, closed: chain.closed })
}

/// Appends the parts of a line that lie on some edges: the whole line where all of it does.
fn keep(line: &VisibleLine, edges: &SilhouetteEdges, parts: &mut Vec<Polyline>) {
    let count = line.edges.len();
    let is_kept = |at: usize| edges.contains(line.edges[at % count]);
    let Some(first_gap) = (0..count).find(|&at| !is_kept(at)) else {
        parts.push(Polyline { points: line.points.clone(), closed: line.closed });
        return;
    };
    // A closed line is read from a gap, so that no part is cut in two by the start.
    let start = if line.closed { first_gap } else { 0 };
    let mut at = start;
    while at < start + count {
        let end = (at..start + count).find(|&next| is_kept(next) != is_kept(at)).unwrap_or(start + count);
        if is_kept(at) {
            let points = (at..=end).map(|at| line.points[at % line.points.len()]).collect();
            parts.push(Polyline { points, closed: false });
        }
        at = end;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;
    use silhouette_core::shapes;

    #[test]
    fn pairs_are_edges_in_either_order_and_count_once() {
        let mesh = shapes::by_name("cube").unwrap();
        let topology = Topology::new(&mesh);
        let [a, b] = topology.end_points(EdgeId::new(3)).map(VertexId::get);
        let found = found_edges(&[[a, b], [b, a]], &topology, mesh.vertex_count(), "cube").unwrap();
        assert_eq!(found.iter().collect::<Vec<_>>(), [EdgeId::new(3)]);
        let refused = |pair: [u32; 2]| {
            found_edges(&[[a, b], pair], &topology, mesh.vertex_count(), "a cube").unwrap_err().to_string()
        };
        let beyond = refused([0, mesh.vertex_count() as u32]);
        assert!(
            beyond.starts_with("edges[1]: names vertex 8, but a cube has 8 vertices, from 0; name the mesh"),
            "{beyond}"
        );
        assert!(refused([0, 0]).contains("edges[1]: is [0, 0], but a cube has no face with such an edge"));
    }

    #[test]
    fn lines_are_parted_where_edges_are_missing() {
        let points: Vec<DVec2> = (0..5).map(|at| DVec2::splat(f64::from(at))).collect();
        let parts_of = |closed: bool, kept: &[u32]| {
            let edges = (0..if closed { 5 } else { 4 }).map(EdgeId::new).collect();
            let line = VisibleLine { points: points.clone(), edges, closed };
            let mut found = SilhouetteEdges::default();
            found.refill(kept.iter().copied().map(EdgeId::new));
            let mut parts = Vec::new();
            keep(&line, &found, &mut parts);
            let places = |part: &Polyline| part.points.iter().map(|point| point.x as u32).collect::<Vec<_>>();
            parts.iter().map(|part| (places(part), part.closed)).collect::<Vec<_>>()
        };
        assert_eq!(parts_of(false, &[0, 1, 2, 3]), [(vec![0, 1, 2, 3, 4], false)]);
        assert_eq!(parts_of(false, &[0, 2, 3]), [(vec![0, 1], false), (vec![2, 3, 4], false)]);
        assert_eq!(parts_of(true, &[0, 1, 2, 3, 4]), [(vec![0, 1, 2, 3, 4], true)]);
        assert_eq!(parts_of(true, &[4, 0, 1]), [(vec![4, 0, 1, 2], false)]);
        assert_eq!(parts_of(true, &[]), []);
    }
}
