//! The width of scaled back faces around a sphere, from the geometry: to set beside the measured one.
//!
//! A sphere of radius 1 is seen from [`DISTANCE`]. On a ray at an angle from its middle the front is at `t1`, the back at
//! `t2` along the ray. Back faces scaled about the eye by k show where `k t2 < t1`, which holds from some angle to the rim.

/// Distance of the eye from the sphere's middle, in radii.
pub const DISTANCE: f64 = 3.0;

/// Radius of the sphere's outline in pixels, for a focal length in pixels.
pub fn outline_radius_px(focal_px: f64) -> f64 {
    focal_px / (DISTANCE * DISTANCE - 1.0).sqrt()
}

/// Width of the ink at the rim for back faces scaled by `k`, in pixels, for a focal length in pixels.
///
/// With c the cosine of the ray's angle, `t = D c ± sqrt(1 - D² (1 - c²))`; `k t2 = t1` where the root is
/// `D c (1 - k) / (1 + k)`.
pub fn scaled_width_px(k: f64, focal_px: f64) -> f64 {
    let share = (1.0 - k) / (1.0 + k);
    let cosine_squared = (DISTANCE * DISTANCE - 1.0) / (DISTANCE * DISTANCE * (1.0 - share * share));
    let tangent = (1.0 / cosine_squared - 1.0).sqrt();
    outline_radius_px(focal_px) - focal_px * tangent
}

#[cfg(test)]
mod tests {
    use super::*;

    const FOCAL_PX: f64 = 600.0;

    #[test]
    fn the_law_of_smooth_rims_is_its_limit() {
        // pull² / (8 radius) across the ray for small pulls, which are along it.
        let k = 0.999;
        let along_ray = (DISTANCE * DISTANCE - 1.0).sqrt();
        let across = silhouette_image_precision::scale::rim_width((1.0 - k) * along_ray, 1.0);
        // Across the ray an angle of `across / along_ray`, which the picture stretches by 1 / cos².
        let cosine = along_ray / DISTANCE;
        let expected = across / along_ray * FOCAL_PX / (cosine * cosine);
        let width = scaled_width_px(k, FOCAL_PX);
        assert!((width / expected - 1.0).abs() < 0.01, "{width} {expected}");
        assert!(scaled_width_px(1.0, FOCAL_PX).abs() < 1e-9);
    }
}
