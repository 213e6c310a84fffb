//! Section III-A, second half: every feature edge is replaced by a Hermite curve, tangential to the circles through three
//! consecutive vertices of its polyline. Independent of the view.
//!
//! Departures:
//!
//! 1. Eq. 1 as printed is the bisector of the two edges, off by half the difference of the angles under which they are seen.
//!    The tangent of the circle is W0 / |W0|² + W1 / |W1|² ([`Tangents::Circle`]); the printed one stays available.
//! 2. Eq. 4 grows without bound as an arc nears 360 degrees, and Hermite curves of arcs above 180 degrees leave the circle.
//!    Such an arc is split at its middle, and one of which an end alone speaks for more than 340 degrees, whose three vertices are nearly one, stays
//!    straight.

use crate::feature_polylines::FeaturePolyline;
use crate::hermite::Hermite;
use silhouette_core::glam::DVec3;
use silhouette_core::id::PerEdge;
use silhouette_core::{EdgeId, Topology, TriangleMesh, VertexId};
use std::f64::consts::PI;

silhouette_core::option_choice! {
    /// The tangent of a feature polyline at an inner vertex.
    pub enum Tangents {
        /// Of the circle through three consecutive vertices.
        Circle = "circle",
        /// The bisector that Eq. 1 prints.
        AsPrinted = "as-printed",
    }
}

/// The curve of a feature edge, from its lower vertex to its higher one: one cubic, or two of half the arc each.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FeatureSegment {
    first: Hermite,
    second: Option<Hermite>,
}

impl FeatureSegment {
    /// The point at a parameter from 0 at the lower vertex to 1 at the higher one.
    pub fn point(&self, u: f64) -> DVec3 {
        match &self.second {
            Some(second) if u > 0.5 => second.point(2.0 * u - 1.0),
            Some(_) => self.first.point(2.0 * u),
            None => self.first.point(u),
        }
    }

    /// The derivative by the parameter.
    pub fn derivative(&self, u: f64) -> DVec3 {
        match &self.second {
            Some(second) if u > 0.5 => 2.0 * second.derivative(2.0 * u - 1.0),
            Some(_) => 2.0 * self.first.derivative(2.0 * u),
            None => self.first.derivative(u),
        }
    }

    /// Its cubics in order.
    pub fn curves(&self) -> impl ExactSizeIterator<Item = &Hermite> {
        let both = [Some(&self.first), self.second.as_ref()];
        let count = 1 + usize::from(self.second.is_some());
        (0..count).map(move |i| both[i].unwrap_or(&self.first))
    }

    /// The straight segment.
    fn straight(ends: [DVec3; 2]) -> Self {
        Self { first: Hermite::along(ends, [DVec3::ZERO; 2]), second: None }
    }
}

/// The curves of all feature edges.
#[derive(Debug, Clone, Default)]
pub struct FeatureSegments {
    edges: Vec<EdgeId>,
    segments: Vec<FeatureSegment>,
    /// Index of an edge's segment, or [`NONE`].
    of_edge: Vec<u32>,
}

const NONE: u32 = u32::MAX;

/// Arcs above this are left straight, in degrees.
const LARGEST_ARC_DEG: f64 = 340.0;

impl FeatureSegments {
    /// Smooths the feature edges of a mesh. A polyline of one edge stays straight, as does a side from a vertex to itself.
    /// O(V + E).
    pub fn new(
        mesh: &TriangleMesh,
        topology: &Topology,
        features: &PerEdge<bool>,
        polylines: &[FeaturePolyline],
        tangents: Tangents,
    ) -> Self {
        let position = |vertex: VertexId| mesh.positions()[vertex.index()].as_dvec3();
        let edges: Vec<EdgeId> = features.ids().filter(|&edge| features[edge]).collect();
        let mut of_edge = vec![NONE; features.len()];
        for (index, edge) in edges.iter().enumerate() {
            of_edge[edge.index()] = index as u32;
        }
        let straight = |edge: &EdgeId| FeatureSegment::straight(topology.end_points(*edge).map(position));
        let mut segments: Vec<_> = edges.iter().map(straight).collect();
        for polyline in polylines.iter().filter(|polyline| polyline.edges.len() > 1) {
            let points: Vec<DVec3> = polyline.vertices.iter().map(|&vertex| position(vertex)).collect();
            let tangents = polyline_tangents(&points, polyline.closed, tangents);
            for (i, edge) in polyline.edges.iter().enumerate() {
                let next = (i + 1) % points.len();
                let is_forward = topology.end_points(*edge)[0] == polyline.vertices[i];
                let (ends, directions) = ([points[i], points[next]], [tangents[i], tangents[next]]);
                let segment = if is_forward {
                    arc(ends, directions)
                } else {
                    arc([ends[1], ends[0]], [-directions[1], -directions[0]])
                };
                segments[of_edge[edge.index()] as usize] = segment;
            }
        }
        Self { edges, segments, of_edge }
    }

    /// The feature edges, ascending.
    pub fn edges(&self) -> &[EdgeId] {
        &self.edges
    }

    /// The segments, in the order of [`edges`](Self::edges).
    pub fn segments(&self) -> &[FeatureSegment] {
        &self.segments
    }

    /// Where an edge stands among [`edges`](Self::edges), if it is a feature edge.
    ///
    /// # Panics
    /// If the mesh has no such edge.
    #[inline]
    pub fn index_of(&self, edge: EdgeId) -> Option<usize> {
        let index = self.of_edge[edge.index()];
        (index != NONE).then_some(index as usize)
    }

    /// How far control points are from where their segment begins, at most.
    pub fn reach(&self) -> f64 {
        let curves = self.segments.iter().flat_map(FeatureSegment::curves);
        curves.flat_map(|curve| curve.control().map(|point| point.distance(curve.ends[0]))).fold(0.0, f64::max)
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        size_of_val(self.edges.as_slice())
            + size_of_val(self.segments.as_slice())
            + size_of_val(self.of_edge.as_slice())
    }
}

/// A unit tangent for each point of a polyline of two or more edges.
fn polyline_tangents(points: &[DVec3], closed: bool, law: Tangents) -> Vec<DVec3> {
    let count = points.len();
    let tangent = |before: DVec3, at: DVec3, after: DVec3| {
        let (w0, w1) = (at - before, after - at);
        let (l0, l1) = (w0.length(), w1.length());
        let sum = match law {
            Tangents::Circle => w0 / (l0 * l0) + w1 / (l1 * l1),
            Tangents::AsPrinted => w0 / l0 + w1 / l1,
        };
        // Where the polyline turns back on itself, or two vertices coincide, an edge's own direction remains.
        sum.try_normalize().or_else(|| w0.try_normalize()).or_else(|| w1.try_normalize()).unwrap_or(DVec3::ZERO)
    };
    let inner = |i: usize| tangent(points[(i + count - 1) % count], points[i], points[(i + 1) % count]);
    // The tangent of the same circle at the other end of a chord is the reflection in the chord.
    let reflected = |tangent: DVec3, chord: DVec3| match chord.try_normalize() {
        Some(along) => 2.0 * tangent.dot(along) * along - tangent,
        None => tangent,
    };
    (0..count)
        .map(|i| match i {
            _ if closed => inner(i),
            0 => reflected(inner(1), points[1] - points[0]),
            _ if i == count - 1 => reflected(inner(i - 1), points[i] - points[i - 1]),
            _ => inner(i),
        })
        .collect()
}

/// The curve between two points along two unit tangents; see the second departure.
fn arc(ends: [DVec3; 2], tangents: [DVec3; 2]) -> FeatureSegment {
    let chord = ends[1] - ends[0];
    let angles = tangents.map(|tangent| chord.angle_between(tangent));
    let central = angles[0] + angles[1];
    if central.is_nan() || angles.iter().any(|angle| 2.0 * angle.to_degrees() > LARGEST_ARC_DEG) {
        return FeatureSegment::straight(ends);
    }
    let outward = (tangents[0] - tangents[1]).try_normalize();
    match outward {
        Some(outward) if central > PI => {
            let middle = ends[0] + 0.5 * chord + 0.5 * chord.length() * (central / 4.0).tan() * outward;
            FeatureSegment {
                first: Hermite::along([ends[0], middle], [tangents[0], chord]),
                second: Some(Hermite::along([middle, ends[1]], [chord, tangents[1]])),
            }
        }
        _ => FeatureSegment { first: Hermite::along(ends, tangents), second: None },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn on_circle(degrees: f64) -> DVec3 {
        let angle = degrees.to_radians();
        DVec3::new(angle.cos(), angle.sin(), 0.0)
    }

    fn tangent(degrees: f64) -> DVec3 {
        on_circle(degrees + 90.0)
    }

    #[test]
    fn tangents_are_those_of_the_circle_and_the_printed_ones_are_not() {
        let degrees = [0.0, 10.0, 50.0, 55.0, 130.0];
        let points = degrees.map(on_circle);
        for closed in [false, true] {
            let found = polyline_tangents(&points, closed, Tangents::Circle);
            for (found, at) in found.iter().zip(degrees) {
                assert!(found.distance(tangent(at)) < 1e-12, "{at} degrees, closed: {closed}");
            }
        }
        let printed = polyline_tangents(&points, false, Tangents::AsPrinted);
        // Half the difference of 5 and 20 degrees, half the angles under which the two edges are seen.
        assert!((printed[1].angle_between(tangent(10.0)).to_degrees() - 7.5).abs() < 1e-9);
    }

    #[test]
    fn arcs_of_every_size_stay_near_their_circle() {
        for (degrees, most) in [(90.0, 3e-4), (180.0, 2e-2), (181.0, 3e-4), (270.0, 4e-3), (339.0, 1.5e-2)] {
            let segment = arc([on_circle(0.0), on_circle(degrees)], [tangent(0.0), tangent(degrees)]);
            let error =
                (0..=100).map(|i| (segment.point(f64::from(i) / 100.0).length() - 1.0).abs()).fold(0.0, f64::max);
            assert!(error < most, "{degrees}: {error}");
            assert_eq!(segment.curves().len(), if degrees > 180.0 { 2 } else { 1 });
        }
        assert!(FeatureSegments::default().reach() < 1e-12);
        let wide = arc([on_circle(0.0), on_circle(300.0)], [tangent(0.0), tangent(300.0)]);
        let reach = FeatureSegments { segments: vec![wide], ..Default::default() }.reach();
        assert!(reach > 1.9, "the middle of the arc is nearly a diameter away: {reach}");
        let tiny = arc([on_circle(0.0), on_circle(355.0)], [tangent(0.0), tangent(355.0)]);
        assert!(tiny.point(0.5).distance(0.5 * (on_circle(0.0) + on_circle(355.0))) < 1e-12);
    }

    #[test]
    fn a_polyline_that_turns_back_or_stands_still_keeps_a_direction() {
        let back = polyline_tangents(&[DVec3::ZERO, DVec3::X, DVec3::ZERO], false, Tangents::Circle);
        assert!(back[1].distance(DVec3::X) < 1e-12);
        let still = polyline_tangents(&[DVec3::ZERO, DVec3::ZERO, DVec3::X], false, Tangents::Circle);
        assert!(still.iter().all(|tangent| tangent.is_finite()));
        let all_one = polyline_tangents(&[DVec3::ONE; 3], true, Tangents::AsPrinted);
        assert!(all_one.iter().all(|tangent| tangent.is_finite()));
    }
}
