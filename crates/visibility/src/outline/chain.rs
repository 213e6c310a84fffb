//! Step 1: the contours as directed edges of the picture.

use super::cycles::walks;
use super::lattice::{DirectedEdge, Point, snap};
use crate::contours::Contour;
use crate::frame::{Homogeneous, PictureFrame};
use rayon::prelude::*;
use silhouette_core::glam::DVec2;

/// Contours that a task takes.
const CONTOURS_PER_TASK: usize = 512;

/// Directed edges with the scene on their left, which together bound all projected faces, what lies farther beyond the
/// picture than `margin_px` cut off. O(contours), parallel.
pub fn chain(contours: &[Contour], frame: &PictureFrame, margin_px: f64) -> Vec<DirectedEdge> {
    let edges: Vec<Edge> =
        contours.par_iter().with_min_len(CONTOURS_PER_TASK).filter_map(|at| edge(at, frame)).collect();
    let unit = edges.iter().fold(0, |unit, edge| greatest_common_divisor(unit, edge.layers));
    let is_inside = |point: &Homogeneous| {
        // Behind the eye all of these fail.
        let (low, high) =
            (point.scaled_pixel + margin_px * point.w, (frame.size() + margin_px) * point.w - point.scaled_pixel);
        low.cmpge(DVec2::ZERO).all() && high.cmpge(DVec2::ZERO).all() && point.w > 0.0
    };
    let directed = |[from, to]: [Homogeneous; 2], layers: u32| {
        let [from, to] = [from, to].map(|point| snap(point.pixel()));
        (from != to).then_some(DirectedEdge { from, to, layers })
    };
    if edges.iter().all(|edge| edge.places.iter().all(is_inside)) {
        return edges.iter().filter_map(|edge| directed(edge.places, edge.layers / unit)).collect();
    }
    // Loops are cut off as polygons, one copy for each layer.
    let single = |edge: &Edge| {
        let [from, to] = edge.vertices;
        std::iter::repeat_n((from, to, edge.places[0]), (edge.layers / unit) as usize)
    };
    let mut cut = Vec::new();
    for walk in walks(edges.iter().flat_map(single).collect()) {
        let polygon = clip(walk, frame.size(), margin_px);
        let next = polygon.iter().cycle().skip(1);
        cut.extend(polygon.iter().zip(next).filter_map(|(from, to)| directed([*from, *to], 1)));
    }
    cut
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
    vertices: [u32; 2],
    places: [Homogeneous; 2],
    layers: u32,
}

/// `None` for a contour on whose sides there are equally many layers.
fn edge(contour: &Contour, frame: &PictureFrame) -> Option<Edge> {
    let (vertices, places) = (contour.vertices, contour.ends.map(|end| frame.map(end.as_dvec3())));
    let more = contour.to_the_left.total();
    let first = usize::from(more < 0);
    (more != 0).then(|| Edge {
        vertices: [vertices[first], vertices[1 - first]],
        places: [places[first], places[1 - first]],
        layers: more.unsigned_abs(),
    })
}

fn greatest_common_divisor(one: u32, other: u32) -> u32 {
    if other == 0 { one } else { greatest_common_divisor(other, one % other) }
}

/// The part of a polygon inside of the picture, grown by a margin (Sutherland and Hodgman 1974), in homogeneous coordinates:
/// the four planes pass through the eye, so that what lies behind it is cut off as well.
fn clip(mut polygon: Vec<Homogeneous>, size: DVec2, margin_px: f64) -> Vec<Homogeneous> {
    let planes: [&dyn Fn(&Homogeneous) -> f64; 4] = [
        &|p| p.scaled_pixel.x + margin_px * p.w,
        &|p| p.scaled_pixel.y + margin_px * p.w,
        &|p| (size.x + margin_px) * p.w - p.scaled_pixel.x,
        &|p| (size.y + margin_px) * p.w - p.scaled_pixel.y,
    ];
    for height in planes {
        let mut kept = Vec::with_capacity(polygon.len() + 4);
        for (index, to) in polygon.iter().enumerate() {
            let from = &polygon[(index + polygon.len() - 1) % polygon.len()];
            let (before, after) = (height(from), height(to));
            if (before < 0.0) != (after < 0.0) {
                kept.push(between(from, to, before / (before - after)));
            }
            if after >= 0.0 {
                kept.push(*to);
            }
        }
        polygon = kept;
    }
    // At the eye itself there is no place in the picture.
    polygon.retain(|point| point.pixel().is_finite());
    polygon
}

fn between(from: &Homogeneous, to: &Homogeneous, share: f64) -> Homogeneous {
    Homogeneous {
        scaled_pixel: from.scaled_pixel.lerp(to.scaled_pixel, share),
        w: from.w + (to.w - from.w) * share,
        depth: from.depth + (to.depth - from.depth) * share,
    }
}
