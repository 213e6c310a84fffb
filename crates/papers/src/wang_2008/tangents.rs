//! Eq. 1, the tangent of a feature polyline: as printed it is the bisector of two edges, not the tangent of the circle through
//! their ends.

use crate::error::Cause;
use silhouette_core::feature_edges::feature_edges;
use silhouette_core::glam::{DVec2, DVec3, Vec3};
use silhouette_core::{PreparedMesh, Progress, Topology, TriangleMesh, VertexId};
use silhouette_smoothing::feature_polylines::feature_polylines;
use silhouette_smoothing::feature_segments::{FeatureSegments, Tangents};

/// Half of the central angle of the shorter edge, in degrees: the inscribed angle that it is seen under.
pub const HALF_ANGLE_DEG: f64 = 4.0;

/// The longer edge over the shorter one.
pub const RATIOS: [f64; 5] = [1.0, 1.5, 2.0, 5.0, 10.0];

/// Degrees between the tangent at the middle of three points on a circle and the circle's own, for the corrected and the
/// printed law.
///
/// # Errors
/// [`Cause`]: cancelled.
pub fn errors_deg(ratio: f64, progress: &dyn Progress) -> Result<[f64; 2], Cause> {
    let first = 2.0 * HALF_ANGLE_DEG.to_radians();
    let second = 2.0 * (ratio * HALF_ANGLE_DEG.to_radians().sin()).asin();
    let at = |angle: f64| DVec2::from_angle(angle).extend(0.0);
    // A sheet whose boundary has these points as its outer side.
    let points = [at(-first), at(0.0), at(second), DVec3::ZERO].map(DVec3::as_vec3);
    let mesh = TriangleMesh::new(points.to_vec(), vec![[3, 0, 1], [3, 1, 2]]);
    let mesh = PreparedMesh::new(mesh.expect("four finite points and two triangles of them"));
    let topology = mesh.artefact::<Topology>("tangents", progress)?;
    let features = feature_edges(mesh.mesh(), &topology, &[], 180.0);
    let polylines = feature_polylines(mesh.mesh(), &topology, &features, 85.0);
    let edge = topology.find_edge(VertexId::new(0), VertexId::new(1));
    Ok([Tangents::Circle, Tangents::AsPrinted].map(|law| {
        let segments = FeatureSegments::new(mesh.mesh(), &topology, &features, &polylines, law);
        let index = edge.and_then(|edge| segments.index_of(edge));
        let tangent = index.map(|index| segments.segments()[index].derivative(1.0));
        tangent.map_or(f64::NAN, |tangent| tangent.angle_between(Vec3::Y.as_dvec3()).to_degrees())
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::NoProgress;

    /// Off by half the difference of the inscribed angles.
    #[test]
    fn the_printed_tangent_is_off_by_what_the_bisector_is() {
        for ratio in RATIOS {
            let [corrected, printed] = errors_deg(ratio, &NoProgress).unwrap();
            let inscribed = (ratio * HALF_ANGLE_DEG.to_radians().sin()).asin().to_degrees();
            assert!(corrected < 1e-3, "{ratio}: {corrected}");
            assert!((printed - 0.5 * (inscribed - HALF_ANGLE_DEG)).abs() < 1e-3, "{ratio}: {printed}");
        }
    }
}
