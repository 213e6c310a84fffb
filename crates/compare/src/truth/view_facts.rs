//! [`ViewFacts`]: what is known of each place of a view's lines that makes methods err there.

use super::mesh_facts::{Circumstance, EdgeKind, MeshFacts};
use super::samples::TrueLines;
use crate::metrics::point_grid::PointGrid;
use glam::DVec2;
use silhouette_core::{Camera, EdgeId, FaceId, Topology, TriangleMesh};
use silhouette_visibility::{Chains, Outline, SegmentSource};

/// Distance between points that stand for lines which ink may lie on, in pixels.
const NEAR_SPACING_PX: f64 = 0.5;

/// A true line no farther than this from the outline is part of it, in pixels: it holds half the distance between the points
/// that stand for the outline.
const ON_OUTLINE_PX: f64 = 0.35;

/// What is known of a place of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LineFacts {
    /// The kind of the edge.
    pub kind: EdgeKind,
    /// What may make methods err there.
    pub circumstance: Circumstance,
}

/// Facts of a view.
#[derive(Debug, Default)]
pub struct ViewFacts {
    /// Of each [sample](TrueLines::samples).
    pub samples: Vec<LineFacts>,
    /// Of each sample, whether it lies inside of the outline, where the mesh covers both sides of the line. `None` where the
    /// outline is not known.
    pub is_inner: Option<Vec<bool>>,
    near: PointGrid,
    near_facts: Vec<LineFacts>,
}

/// A mesh in a view, as far as facts of lines depend on it.
#[derive(Debug, Clone, Copy)]
pub struct SeenMesh<'a> {
    /// The mesh.
    pub mesh: &'a TriangleMesh,
    /// Its topology.
    pub topology: &'a Topology,
    /// Facts that do not depend on the view.
    pub facts: &'a MeshFacts,
    /// The view.
    pub camera: &'a Camera,
}

impl SeenMesh<'_> {
    /// The facts of an edge.
    pub fn of_edge(&self, edge: EdgeId) -> LineFacts {
        let has_small_faces = || self.topology.faces(edge).all(|face| self.is_small(face));
        LineFacts { kind: self.facts.kind(edge), circumstance: self.facts.of_edge(edge, has_small_faces) }
    }

    /// The circumstance of ink on a face.
    pub fn of_face(&self, face: FaceId, is_back: bool) -> Circumstance {
        match self.facts.of_face(face, is_back) {
            Circumstance::Unexplained if self.is_small(face) => Circumstance::SmallFaces,
            circumstance => circumstance,
        }
    }

    /// Whether a face covers less than a pixel. One that reaches behind the eye does not.
    fn is_small(&self, face: FaceId) -> bool {
        let [a, b, c] = self.mesh.corners(face).map(|corner| self.camera.project(corner.as_dvec3()));
        let (Some(a), Some(b), Some(c)) = (a, b, c) else { return false };
        (b.pixel - a.pixel).perp_dot(c.pixel - a.pixel).abs() * 0.5 < 1.0
    }
}

impl ViewFacts {
    /// The facts of true lines, and of the lines in `chains` as such that ink within `reach_px` may lie on.
    /// O(samples + length of chains in pixels).
    pub fn new(
        seen: &SeenMesh<'_>,
        lines: &TrueLines,
        outline: Option<&Outline>,
        chains: &[Chains],
        reach_px: f64,
    ) -> Self {
        let mut of_last: Option<(EdgeId, LineFacts)> = None;
        let mut of_edge = |edge: EdgeId| match of_last {
            Some((last, facts)) if last == edge => facts,
            _ => of_last.insert((edge, seen.of_edge(edge))).1,
        };
        let samples = lines.samples.iter().map(|sample| of_edge(sample.edge)).collect();
        let (mut points, mut near_facts) = (Vec::new(), Vec::new());
        for sample in &lines.samples {
            points.push(sample.pixel);
            near_facts.push(of_edge(sample.edge));
        }
        let size = seen.camera.size();
        for chain in chains.iter().flat_map(Chains::iter) {
            for (at, source) in chain.sources.iter().enumerate() {
                if let SegmentSource::Edge(edge) = source {
                    let before = points.len();
                    spread(chain.segment_pixels(at), size, reach_px, &mut points);
                    near_facts.resize(near_facts.len() + points.len() - before, of_edge(*edge));
                }
            }
        }
        let is_inner = outline.map(|outline| {
            let mut points = Vec::new();
            for ring in &outline.rings {
                for (&from, &to) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                    spread([from, to], size, 1.0, &mut points);
                }
            }
            let outline = PointGrid::new(points, ON_OUTLINE_PX);
            lines.samples.iter().map(|sample| outline.nearest(sample.pixel, |_| true).is_none()).collect()
        });
        Self { samples, is_inner, near: PointGrid::new(points, reach_px), near_facts }
    }

    /// The facts of the line that ink at a place lies on: the nearest within reach.
    pub fn near(&self, place: DVec2) -> Option<LineFacts> {
        self.near.nearest(place, |_| true).map(|at| self.near_facts[at])
    }
}

/// Points along a segment at most [`NEAR_SPACING_PX`] apart, as far as it lies within the picture and `margin_px` around it.
fn spread(ends: [DVec2; 2], size: [u32; 2], margin_px: f64, points: &mut Vec<DVec2>) {
    if let Some([begin, end]) = part_within(ends, size, margin_px) {
        let [from, to] = ends;
        let count = ((end - begin) * from.distance(to) / NEAR_SPACING_PX).ceil().max(1.0);
        let share = |part: u32| begin + (end - begin) * (f64::from(part) + 0.5) / count;
        points.extend((0..count as u32).map(|part| from.lerp(to, share(part))));
    }
}

/// Between which shares of its length a segment lies within the picture and `margin_px` around it, if anywhere.
pub(crate) fn part_within([from, to]: [DVec2; 2], size: [u32; 2], margin_px: f64) -> Option<[f64; 2]> {
    let (low, high) = (DVec2::splat(-margin_px), DVec2::from(size.map(f64::from)) + margin_px);
    // The common part of what each axis allows.
    let (mut begin, mut end) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let along = to[axis] - from[axis];
        let [one, other] = [low[axis], high[axis]].map(|bound| (bound - from[axis]) / along);
        if along == 0.0 {
            if !(low[axis]..=high[axis]).contains(&from[axis]) {
                return None;
            }
        } else {
            (begin, end) = (begin.max(one.min(other)), end.min(one.max(other)));
        }
    }
    (begin < end).then_some([begin, end])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_spread_within_the_frame_alone() {
        let spread_out = |from: [f64; 2], to: [f64; 2]| {
            let mut points = Vec::new();
            spread([from, to].map(DVec2::from), [100, 50], 1.0, &mut points);
            points
        };
        let across = spread_out([-1e6, 20.0], [1e6, 20.0]);
        assert_eq!(across.len(), 204);
        assert!(across.windows(2).all(|pair| pair[0].distance(pair[1]) <= NEAR_SPACING_PX + 1e-6));
        assert!(across.iter().all(|point| (-1.0..=101.0).contains(&point.x)));
        assert!(spread_out([-5.0, 0.0], [-5.0, 40.0]).is_empty() && spread_out([7.0, 7.0], [7.0, 7.0]).len() == 1);
        assert_eq!(spread_out([0.0, -40.0], [10.0, -30.0]), []);
    }
}
