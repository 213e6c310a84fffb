//! Directions to look from.

use silhouette_core::glam::DVec3;
use std::f64::consts::PI;

/// Along the axes, both ways, where edges cover edges and faces are seen edge-on.
pub const AXES: [DVec3; 6] = [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z];

/// `count` unit vectors spread evenly over the sphere (a Fibonacci lattice), from the north pole, +y, to the south pole.
///
/// The lattice is shifted so that no direction lies in a coordinate plane: views from them are generic.
pub fn spread(count: usize) -> impl Iterator<Item = DVec3> {
    let golden_angle = PI * (3.0 - 5.0_f64.sqrt());
    (0..count).map(move |index| {
        let height = 1.0 - 2.0 * (index as f64 + 0.37) / count as f64;
        let (sin, cos) = (golden_angle * index as f64 + 0.2).sin_cos();
        let radius = (1.0 - height * height).sqrt();
        DVec3::new(radius * cos, height, radius * sin)
    })
}

/// One direction inside each octant, not normalised: far enough from the coordinate planes that an eye 3 radii away sees
/// three sides of a cube.
pub fn octants() -> impl Iterator<Item = DVec3> {
    let sign = |octant: u32, axis: u32| if octant >> axis & 1 == 1 { 1.0 } else { -1.0 };
    (0..8).map(move |octant| DVec3::new(0.8 * sign(octant, 0), 0.55 * sign(octant, 1), sign(octant, 2)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_unit_vectors_in_no_coordinate_plane() {
        for count in 1..200 {
            for direction in spread(count) {
                assert!((direction.length() - 1.0).abs() < 1e-12, "{direction}");
                assert!(direction.abs().min_element() > 1e-4, "{direction} of {count}");
            }
        }
    }

    /// No cap of the sphere holds a share of the directions far from its area's.
    #[test]
    fn directions_are_spread_evenly() {
        let count = 1000;
        for axis in AXES.into_iter().chain(octants().map(DVec3::normalize)) {
            for height in [-0.5, 0.0, 0.7] {
                let inside = spread(count).filter(|direction| direction.dot(axis) > height).count();
                let expected = (1.0 - height) * 0.5 * count as f64;
                assert!((inside as f64 - expected).abs() < 10.0, "{inside} of {expected} above {height} along {axis}");
            }
        }
    }

    #[test]
    fn octants_differ_in_signs() {
        let signs: std::collections::BTreeSet<_> =
            octants().map(|direction| direction.signum().as_ivec3().to_array()).collect();
        assert_eq!(signs.len(), 8);
    }
}
