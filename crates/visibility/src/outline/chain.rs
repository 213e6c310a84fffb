//! Step 1: the contours as directed edges of the picture.

use super::lattice::{DirectedEdge, Point, snap};
use super::window::{CutChain, Window};
use crate::contours::Contour;
use crate::frame::{Homogeneous, PictureFrame};
use crate::scene::Extent;
use crate::viewed_mesh::ViewedMesh;
use rayon::prelude::*;

/// Contours that a task takes.
const CONTOURS_PER_TASK: usize = 512;

/// Directed edges with the scene on their left, which together bound all projected faces, what lies beyond the window cut off.
/// O(contours), parallel, and O(F) where the scene reaches beyond the window.
pub fn chain(view: &ViewedMesh<'_>, contours: &[Contour], frame: &PictureFrame, extent: &Extent) -> Vec<DirectedEdge> {
    let edges: Vec<Edge> =
        contours.par_iter().with_min_len(CONTOURS_PER_TASK).filter_map(|at| edge(at, frame)).collect();
    let window = Window::around(frame);
    if extent.corners().all(|corner| window.holds(&frame.map(corner))) {
        let unit = edges.iter().fold(0, |unit, edge| greatest_common_divisor(unit, edge.layers));
        let directed = |edge: &Edge| {
            let [from, to] = edge.places.map(|point| snap(point.pixel()));
            (from != to).then_some(DirectedEdge { from, to, layers: edge.layers / unit })
        };
        return edges.iter().filter_map(directed).collect();
    }
    let middle = frame.map(extent.center().as_dvec3());
    let mut cut = CutChain::default();
    edges.iter().for_each(|edge| window.push(edge.places.each_ref(), edge.layers, &middle, &mut cut));
    window.close(cut, view, frame)
}

/// A chain that bounds the same, in which edges with the same ends are one. O(edges log edges).
pub fn without_repeats(chain: Vec<DirectedEdge>) -> Vec<DirectedEdge> {
    let undirected = |edge: DirectedEdge| {
        let layers = i64::from(edge.layers);
        if edge.from < edge.to { (edge.from, edge.to, layers) } else { (edge.to, edge.from, -layers) }
    };
    let mut edges: Vec<_> = chain.into_iter().map(undirected).collect();
    edges.sort_unstable();
    let sum = |same: &[(Point, Point, i64)]| {
        let (from, to, layers) = (same[0].0, same[0].1, same.iter().map(|(.., layers)| layers).sum::<i64>());
        let [from, to] = if layers > 0 { [from, to] } else { [to, from] };
        (layers != 0).then_some(DirectedEdge { from, to, layers: layers.unsigned_abs() as u32 })
    };
    edges.chunk_by(|one, other| (one.0, one.1) == (other.0, other.1)).filter_map(sum).collect()
}

/// A contour as a directed edge.
struct Edge {
    places: [Homogeneous; 2],
    layers: u32,
}

/// `None` for a contour on whose sides there are equally many layers.
fn edge(contour: &Contour, frame: &PictureFrame) -> Option<Edge> {
    let places = contour.ends.map(|end| frame.map(end.as_dvec3()));
    let more = contour.to_the_left.total();
    let first = usize::from(more < 0);
    (more != 0).then(|| Edge { places: [places[first], places[1 - first]], layers: more.unsigned_abs() })
}

fn greatest_common_divisor(one: u32, other: u32) -> u32 {
    if other == 0 { one } else { greatest_common_divisor(other, one % other) }
}
