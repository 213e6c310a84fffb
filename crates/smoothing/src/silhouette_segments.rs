//! Section III-D, second half: the silhouette points of a view, and in each silhouette triangle the Hermite curve between its
//! two points, the *silhouette segment*, by the recipe of bridges.
//!
//! Departure: the recipe takes the segment for an arc of a geodesic. What is drawn is its image, and seen from a near eye even a
//! sphere's contour is no great circle. By default ([`SegmentLaw::AcrossView`]) the chord is divided into a part along the view
//! and one across it; the latter is interpolated along the directions that are perpendicular to both the normal and the view,
//! which are those of the contour in the image, and the depth linearly. On a sphere this follows the contour from every eye. Where
//! the curve turns sharply within one face, as it does at a cusp, the printed recipe takes over little by little.
//!
//! A side that two faces of one group share has one bridge and one point, found once. On a feature edge the bridge is the
//! feature segment, and each face finds a point of its own with its own group's normals.

use crate::bridges::bridge;
use crate::eye::Eye;
use crate::feature_segments::FeatureSegments;
use crate::hermite::Hermite;
use crate::shading_mesh::ShadingMesh;
use crate::silhouette_points::{SilhouettePoint, silhouette_point};
use crate::silhouette_triangles::SilhouetteTriangle;
use silhouette_core::glam::DVec3;
use silhouette_core::id::HalfEdgeId;
use silhouette_core::topology::Twin;

silhouette_core::option_choice! {
    /// How a silhouette segment is interpolated between its two points.
    pub enum SegmentLaw {
        /// In the image, its depth linearly.
        AcrossView = "across-view",
        /// In space by the recipe of bridges, as the paper does.
        AsPrinted = "as-printed",
    }
}

/// The curve between two silhouette points of a view.
#[inline]
pub fn segment_curve(ends: [&SilhouettePoint; 2], eye: Eye, law: SegmentLaw) -> Hermite {
    let positions = [ends[0].position, ends[1].position];
    let in_space = || bridge(positions, [ends[0].normal, ends[1].normal]);
    if law == SegmentLaw::AsPrinted {
        return in_space();
    }
    let chord = positions[1] - positions[0];
    let views = [eye.toward(positions[0]), eye.toward(positions[1])];
    // For an eye, the sum of the unit vectors towards it, times both their lengths.
    let along =
        if eye.position().is_some() { views[0] * views[1].length() + views[1] * views[0].length() } else { views[0] };
    // An eye on one of the points sees no depth.
    let depth = chord.dot(along) / along.length_squared().max(f64::MIN_POSITIVE) * along;
    let across = chord - depth;
    let direction = |end: usize| {
        let direction = ends[end].normal.cross(views[end]);
        if direction.dot(across) < 0.0 { -direction } else { direction }
    };
    let directions = [direction(0), direction(1)];
    let flat = Hermite::along([DVec3::ZERO, across], directions);
    let tangents = [flat.tangents[0] + depth, flat.tangents[1] + depth];
    // Squared cosines over the squares of both lengths: most are of small angles, and need no division.
    let squared = |direction: DVec3| [direction.dot(across).powi(2), direction.length_squared()];
    let squares = [squared(directions[0]), squared(directions[1])];
    let most = ALL_IN_IMAGE * across.length_squared();
    if squares.iter().all(|[dot, length]| *dot >= most * length) {
        return Hermite { ends: positions, tangents };
    }
    let squares = squares.map(|[dot, length]| dot / length);
    // The minimum of two numbers leaves out one that is none: an end without a direction has no cosine.
    let least = if squares.iter().any(|square| square.is_nan()) { f64::NAN } else { squares[0].min(squares[1]) };
    let share = share_in_image((least / across.length_squared()).sqrt());
    let in_space = in_space();
    let between = |end: usize| in_space.tangents[end].lerp(tangents[end], share);
    Hermite { ends: positions, tangents: [between(0), between(1)] }
}

/// The squared cosine of 30 degrees, from which on the interpolation in the image counts for all.
const ALL_IN_IMAGE: f64 = 0.75;

/// How much the interpolation in the image counts, given the least cosine between a tangent and the chord there: all of it up to
/// 30 degrees, nothing of it from 60 degrees on, where the curve may have a cusp and its direction no certain sign.
fn share_in_image(cosine: f64) -> f64 {
    let [least, most] = [0.5, ALL_IN_IMAGE.sqrt()];
    // No direction at all has no cosine.
    let t = if cosine.is_nan() { 0.0 } else { ((cosine - least) / (most - least)).clamp(0.0, 1.0) };
    t * t * (3.0 - 2.0 * t)
}

/// The silhouette's curve through a face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SilhouetteSegment {
    /// The face, and its lone corner.
    pub triangle: SilhouetteTriangle,
    /// Indices of its silhouette points: on the side that leaves the lone corner, and on the one that returns to it.
    pub points: [u32; 2],
    /// From the first point to the second: the lone corner lies on the left, seen from outside.
    pub curve: Hermite,
}

/// The silhouette points and segments of one view.
#[derive(Debug, Clone, Default)]
pub struct SilhouetteSegments {
    points: Vec<SilhouettePoint>,
    /// The point on each half-edge; valid for those that join a visible and an invisible vertex in this view.
    of_half_edge: Vec<u32>,
    segments: Vec<SilhouetteSegment>,
}

impl SilhouetteSegments {
    /// Finds points and segments of the silhouette triangles of a view, which are ascending. O(silhouette triangles).
    pub fn find(
        &mut self,
        mesh: &ShadingMesh,
        features: &FeatureSegments,
        triangles: &[SilhouetteTriangle],
        eye: Eye,
        newton_steps: u32,
        law: SegmentLaw,
    ) {
        self.points.clear();
        self.segments.clear();
        self.of_half_edge.resize(mesh.topology().half_edge_count(), 0);
        for &triangle in triangles {
            let mut on_side = |slot: u32| {
                let half_edge = HalfEdgeId::of(triangle.face, slot);
                self.point_on(mesh, features, half_edge, eye, newton_steps)
            };
            let points = [on_side(triangle.lone), on_side((triangle.lone + 2) % 3)];
            let ends = [&self.points[points[0] as usize], &self.points[points[1] as usize]];
            let curve = segment_curve(ends, eye, law);
            self.segments.push(SilhouetteSegment { triangle, points, curve });
        }
    }

    fn point_on(
        &mut self,
        mesh: &ShadingMesh,
        features: &FeatureSegments,
        half_edge: HalfEdgeId,
        eye: Eye,
        newton_steps: u32,
    ) -> u32 {
        let edge = mesh.topology().edge_of(half_edge);
        let feature = features.index_of(edge);
        if let (None, Twin::HalfEdge(twin)) = (feature, mesh.topology().twin(half_edge))
            && twin.face() < half_edge.face()
        {
            // The neighbour, whose corners on this side are the same shading vertices, came first.
            let point = self.of_half_edge[twin.index()];
            self.of_half_edge[half_edge.index()] = point;
            return point;
        }
        let corners = mesh.triangles()[half_edge.face().index()];
        let (mut from, mut to) =
            (corners[half_edge.slot() as usize], corners[half_edge.next_in_face().slot() as usize]);
        if mesh.vertices()[from as usize] > mesh.vertices()[to as usize] {
            (from, to) = (to, from);
        }
        let position = |vertex: u32| mesh.positions()[vertex as usize].as_dvec3();
        let normal = |vertex: u32| mesh.normals()[vertex as usize].as_dvec3();
        let (positions, normals) = ([position(from), position(to)], [normal(from), normal(to)]);
        let found = match feature {
            Some(index) => {
                let segment = &features.segments()[index];
                silhouette_point(positions, normals, segment, eye, newton_steps)
            }
            None => silhouette_point(positions, normals, &bridge(positions, normals), eye, newton_steps),
        };
        let point = self.points.len() as u32;
        self.points.push(found);
        self.of_half_edge[half_edge.index()] = point;
        point
    }

    /// The silhouette points. Parameters run from the lower vertex of an edge to the higher.
    pub fn points(&self) -> &[SilhouettePoint] {
        &self.points
    }

    /// The segments, one for each silhouette triangle, in their order.
    pub fn segments(&self) -> &[SilhouetteSegment] {
        &self.segments
    }

    /// Index of the point on a half-edge that joins a visible and an invisible vertex in this view; any other yields a number
    /// without meaning.
    pub fn point_index(&self, half_edge: HalfEdgeId) -> u32 {
        self.of_half_edge[half_edge.index()]
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        size_of_val(self.points.as_slice())
            + size_of_val(self.of_half_edge.as_slice())
            + size_of_val(self.segments.as_slice())
    }
}
