//! Directions spread evenly over the sphere, the same ones every time.

use glam::{DVec3, Vec3};
use silhouette_core::glam;
use std::f64::consts::PI;

/// `count` unit vectors of a Fibonacci lattice, turned about z by `turn` radians. Each stands for an equal share of the sphere.
pub fn spread(count: u32, turn: f64) -> impl Iterator<Item = Vec3> {
    let golden_angle = PI * (3.0 - 5.0_f64.sqrt());
    (0..count).map(move |index| {
        let z = 1.0 - (2.0 * f64::from(index) + 1.0) / f64::from(count);
        let (sin, cos) = (golden_angle * f64::from(index) + turn).sin_cos();
        let radius = (1.0 - z * z).sqrt();
        DVec3::new(radius * cos, radius * sin, z).as_vec3()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_unit_and_balanced() {
        for count in [1, 2, 100, 1024] {
            assert!(spread(count, 0.3).all(Vec3::is_normalized));
        }
        let mean = spread(1024, 0.0).sum::<Vec3>() / 1024.0;
        assert!(mean.length() < 2e-3, "{mean}");
        // A cap of 60 degrees holds a quarter of the sphere.
        let cap = spread(4096, 0.0).filter(|direction| direction.dot(Vec3::new(0.6, 0.0, 0.8)) > 0.5).count();
        assert!((cap as f64 / 4096.0 - 0.25).abs() < 0.005, "{cap}");
    }
}
