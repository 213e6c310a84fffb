//! Section III-E: a silhouette segment is *concave* where the surface on both its ends rises towards the chord between them, so
//! that neighbouring triangles of the original mesh would hide it.

use crate::eye::Eye;
use crate::silhouette_points::SilhouettePoint;
use crate::silhouette_segments::SilhouetteSegment;
use silhouette_core::glam::DVec3;

/// The plane that vertices near a concave segment have to stay below: it touches the surface at the segment's middle and holds
/// the direction of view.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BlockingPlane {
    /// The middle of the segment (M).
    pub middle: DVec3,
    /// The unit normal there (N).
    pub normal: DVec3,
    /// How far the segment's ends lie above its middle along the normal.
    pub height: f64,
}

/// Whether a segment is concave: with F from its first point to its second, N1 . F > 0 and N2 . F < 0.
#[inline]
pub fn is_concave(ends: [&SilhouettePoint; 2]) -> bool {
    let chord = ends[1].position - ends[0].position;
    ends[0].normal.dot(chord) > 0.0 && ends[1].normal.dot(chord) < 0.0
}

/// The plane of a concave segment. Departure: in a perspective the interpolated normal is not perpendicular to the view, and the
/// plane would not hold the eye; its part along the view is removed. `None` where nothing is left.
#[inline]
pub fn blocking_plane(segment: &SilhouetteSegment, ends: [&SilhouettePoint; 2], eye: Eye) -> Option<BlockingPlane> {
    let middle = segment.curve.point(0.5);
    let toward = eye.toward(middle).normalize_or_zero();
    let normal = ends[0].normal + ends[1].normal;
    let normal = (normal - normal.dot(toward) * toward).try_normalize()?;
    let [a, b] = segment.curve.ends;
    let (a, b) = ((a - middle).dot(normal), (b - middle).dot(normal));
    Some(BlockingPlane { middle, normal, height: 0.5 * (a + b) })
}
