//! [`TrueFrame`]: the true lines of a frame as places in the picture.

use super::reference_scale;
use crate::metrics::point_grid::PointGrid;
use crate::truth::Truth;
use crate::truth::sight::sight_ray;
use crate::truth::visible::VisibleLine;
use glam::{DVec2, DVec3};
use silhouette_core::glam::Vec3;
use silhouette_core::{Camera, DisjointSets, EdgeId, SilhouetteEdges, Topology, VertexId};
use silhouette_visibility::Outline;

/// Length that a place stands for, in reference pixels, at most.
pub const SPACING: f64 = 2.0;

/// The direction of a line at a place is that of its chord from so far before to so far after, in reference pixels: meshes'
/// lines zigzag from edge to edge.
const CHORD_REACH: f64 = 4.0;

/// A place is *clear* if no other line, nor a bend of its own by more than [`STRAIGHT_WITHIN`], lies in a corridor of this half
/// length along the line and this half width across.
const CORRIDOR: [f64; 2] = [6.0, 12.0];

/// How far a line may stray from its tangent within the corridor.
const STRAIGHT_WITHIN: f64 = 2.0;

/// A place of a visible true line. Lengths are in reference pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TruePlace {
    /// Where it appears, the origin at the picture's top left.
    pub at: DVec2,
    /// Unit vector across the line, towards its front face.
    pub normal: DVec2,
    /// Length of the stretch that it stands for, at most [`SPACING`].
    pub length: f64,
    /// The visible line that it lies on. Places of a line follow each other.
    pub line: u32,
    /// The loop that it belongs to: a connected set of silhouette edges of the frame.
    pub loop_id: u32,
    /// The silhouette edge that it lies on.
    pub edge: EdgeId,
    /// Where on the edge: 0 at its first end, 1 at its second.
    pub share: f64,
    /// Whether it is far enough from other lines for its distance to a drawn line to be measured.
    pub is_clear: bool,
    /// Whether it lies on the outline, where the mesh covers one side of the line only.
    pub is_outer: bool,
}

/// The true lines of a frame.
#[derive(Debug, Clone)]
pub struct TrueFrame {
    /// The camera.
    pub camera: Camera,
    /// Positions of the vertices, where they are not those of the mesh.
    pub positions: Option<Vec<Vec3>>,
    /// The places, line after line.
    pub places: Vec<TruePlace>,
    /// Number of loops, seen or not.
    pub loops: u32,
    /// The visible lines.
    pub visible: Vec<VisibleLine>,
}

impl TrueFrame {
    /// The places of a frame's truth, whose mesh has these positions. O(length of lines + S α(S)).
    pub fn new(truth: Truth, outline: Option<&Outline>, topology: &Topology, positions: &[Vec3]) -> Self {
        let Truth { camera, edges, visible, .. } = truth;
        let (loop_of, loops) = loops(&edges, topology);
        let scale = reference_scale(camera.size()[1]);
        let mut places = Vec::new();
        for (number, line) in (0..).zip(&visible) {
            for (at, normal, length, edge, pixel) in spread(line, scale) {
                let ends = topology.end_points(edge).map(|vertex| positions[vertex.index()].as_dvec3());
                let share = share_at(&camera, pixel, ends);
                let loop_id = loop_of(edge);
                places.push(TruePlace {
                    at,
                    normal,
                    length,
                    line: number,
                    loop_id,
                    edge,
                    share,
                    is_clear: true,
                    is_outer: false,
                });
            }
        }
        mark_clear(&mut places);
        if let Some(outline) = outline {
            mark_outer(&mut places, outline, scale);
        }
        Self { camera, positions: None, places, loops, visible }
    }
}

/// Which loop each silhouette edge is of, and how many there are.
fn loops(edges: &SilhouetteEdges, topology: &Topology) -> (impl Fn(EdgeId) -> u32 + use<>, u32) {
    let sorted: Vec<EdgeId> = edges.iter().collect();
    let mut vertices: Vec<u32> = sorted.iter().flat_map(|&edge| topology.end_points(edge).map(VertexId::get)).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let index = |vertex: u32| vertices.binary_search(&vertex).unwrap_or(0) as u32;
    let mut sets = DisjointSets::new(vertices.len());
    for &edge in &sorted {
        let [a, b] = topology.end_points(edge).map(|vertex| index(vertex.get()));
        sets.unite(a, b);
    }
    let mut number = vec![u32::MAX; vertices.len()];
    let mut count = 0;
    let mut ids = Vec::with_capacity(sorted.len());
    for &edge in &sorted {
        let set = sets.find(index(topology.end_points(edge)[0].get())) as usize;
        if number[set] == u32::MAX {
            number[set] = count;
            count += 1;
        }
        ids.push(number[set]);
    }
    (move |edge| sorted.binary_search(&edge).map_or(0, |at| ids[at]), count)
}

/// Places along a line: where, normal, length, edge, and where in pixels.
fn spread(line: &VisibleLine, scale: f64) -> Vec<(DVec2, DVec2, f64, EdgeId, DVec2)> {
    let segments: Vec<(EdgeId, [DVec2; 2])> =
        line.segments().filter(|(_, [from, to])| from.distance_squared(*to) > 0.0).collect();
    let mut ends = Vec::with_capacity(segments.len());
    let mut total = 0.0;
    for (_, [from, to]) in &segments {
        total += from.distance(*to) * scale;
        ends.push(total);
    }
    if !(total > 0.0 && total.is_finite()) {
        return Vec::new();
    }
    let find = |length: f64| {
        let length = if line.closed { length.rem_euclid(total) } else { length.clamp(0.0, total) };
        let at = ends.partition_point(|&end| end < length).min(segments.len() - 1);
        let begin = if at == 0 { 0.0 } else { ends[at - 1] };
        let (edge, [from, to]) = segments[at];
        (edge, from.lerp(to, ((length - begin) / (ends[at] - begin)).clamp(0.0, 1.0)))
    };
    let count = (total / SPACING).ceil().max(1.0);
    let place = |part: u32| {
        let length = total * (f64::from(part) + 0.5) / count;
        let (edge, pixel) = find(length);
        let chord = find(length + CHORD_REACH).1 - find(length - CHORD_REACH).1;
        // With y pointing down the left of a direction is that turned by minus a quarter.
        let normal = chord.try_normalize().map_or(DVec2::Y, |tangent| DVec2::new(tangent.y, -tangent.x));
        (pixel * scale, normal, total / count, edge, pixel)
    };
    (0..count as u32).map(place).collect()
}

/// Where on an edge the point lies that appears at a pixel: the point nearest to the sight ray.
fn share_at(camera: &Camera, pixel: DVec2, [a, b]: [DVec3; 2]) -> f64 {
    let (origin, direction) = sight_ray(camera, pixel);
    let [from, along] = [a - origin, b - a].map(|v| v - direction * v.dot(direction));
    let square = along.length_squared();
    if square > 0.0 { (-from.dot(along) / square).clamp(0.0, 1.0) } else { 0.5 }
}

fn mark_clear(places: &mut [TruePlace]) {
    let reach = CORRIDOR[0].hypot(CORRIDOR[1]);
    let grid = PointGrid::new(places.iter().map(|place| place.at).collect(), reach);
    let is_clear = |place: &TruePlace| {
        let is_in_the_way = |at: usize| {
            let off = places[at].at - place.at;
            let (along, across) = (off.perp_dot(place.normal).abs(), off.dot(place.normal).abs());
            along <= CORRIDOR[0] && across <= CORRIDOR[1] && across > STRAIGHT_WITHIN
        };
        grid.nearest(place.at, is_in_the_way).is_none()
    };
    let clear: Vec<bool> = places.iter().map(is_clear).collect();
    places.iter_mut().zip(clear).for_each(|(place, is_clear)| place.is_clear = is_clear);
}

fn mark_outer(places: &mut [TruePlace], outline: &Outline, scale: f64) {
    let spacing = SPACING * 0.25;
    let mut points = Vec::new();
    for ring in &outline.rings {
        for (&from, &to) in ring.iter().zip(ring.iter().cycle().skip(1)) {
            let (from, to) = (from * scale, to * scale);
            let count = (from.distance(to) / spacing).ceil().clamp(1.0, 1e5);
            points.extend((0..count as u32).map(|part| from.lerp(to, (f64::from(part) + 0.5) / count)));
        }
    }
    let grid = PointGrid::new(points, spacing);
    places.iter_mut().for_each(|place| place.is_outer = grid.nearest(place.at, |_| true).is_some());
}

#[cfg(test)]
mod tests {
    use super::super::sample_sequence::SampleSequence;
    use super::*;

    #[test]
    fn places_keep_the_length_of_the_lines_and_lie_on_their_edges() {
        let sample = SampleSequence::of("torus", 512);
        for frame in &sample.sequence.frames {
            let scale = reference_scale(512);
            let segments = || frame.visible.iter().flat_map(VisibleLine::segments);
            let length: f64 = segments().map(|(_, [from, to])| from.distance(to) * scale).sum();
            let places: f64 = frame.places.iter().map(|place| place.length).sum();
            assert!((places / length - 1.0).abs() < 1e-9 && length > 1000.0, "{places} of {length}");
            for place in &frame.places {
                assert!(place.length <= SPACING + 1e-9 && (place.normal.length() - 1.0).abs() < 1e-9);
                let [a, b] =
                    sample.topology.end_points(place.edge).map(|vertex| sample.rest[vertex.index()].as_dvec3());
                let seen = frame.camera.project(a.lerp(b, place.share)).unwrap().pixel * scale;
                assert!(seen.distance(place.at) < 1e-2, "{seen} instead of {}", place.at);
            }
        }
    }

    /// Around a ball the front faces are within.
    #[test]
    fn normals_point_to_the_front_faces_and_a_ball_is_one_outer_loop() {
        let sample = SampleSequence::of("icosphere:4", 512);
        let frame = &sample.sequence.frames[0];
        assert_eq!(frame.loops, 1);
        for place in &frame.places {
            assert!((DVec2::splat(500.0) - place.at).normalize().dot(place.normal) > 0.9, "{place:?}");
            assert!(place.is_outer && place.is_clear, "{place:?}");
        }
    }

    #[test]
    fn lines_side_by_side_are_not_clear() {
        // The same line once more, five reference pixels inwards.
        let places = |shape: &str| SampleSequence::of(shape, 512).sequence.frames.remove(0).places;
        let clear =
            |places: &[TruePlace]| places.iter().filter(|place| place.is_clear).count() as f64 / places.len() as f64;
        let mut near = places("icosphere:4");
        let beside: Vec<TruePlace> =
            near.iter().map(|place| TruePlace { at: place.at + place.normal * 5.0, ..*place }).collect();
        near.extend(beside);
        mark_clear(&mut near);
        assert!(clear(&near) < 1e-9 && clear(&places("icosphere:4")) > 0.99);
    }
}
