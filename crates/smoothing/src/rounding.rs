//! From 64 bits to 32.

use silhouette_core::glam::{DVec3, Vec3};

/// A point rounded to 32 bits. What bulges beyond the largest 32-bit number, as curves between the largest coordinates do, ends there.
#[inline]
pub(crate) fn rounded(point: DVec3) -> Vec3 {
    point.clamp(Vec3::MIN.as_dvec3(), Vec3::MAX.as_dvec3()).as_vec3()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bridges::bridge;
    use silhouette_core::curves::{CurveKind, CurveSource};

    #[test]
    fn curves_between_the_largest_coordinates_are_finite() {
        let ends = [DVec3::new(1.0, 0.0, 0.0), DVec3::new(0.0, 1.0, 0.0)].map(|end| f64::from(f32::MAX) * end);
        let curve = bridge(ends, [DVec3::new(1.0, -0.1, 0.0), DVec3::new(-0.1, 1.0, 0.0)].map(DVec3::normalize));
        assert!(curve.control().iter().any(|point| !point.as_vec3().is_finite()), "it bulges");
        let source = CurveSource::Edge(silhouette_core::EdgeId::new(0));
        assert!(curve.piece(CurveKind::Silhouette, source).control.iter().all(|point| point.is_finite()));
        assert_eq!(rounded(DVec3::new(0.1, -1e300, 1e38)), Vec3::new(0.1, f32::MIN, 1e38));
    }
}
