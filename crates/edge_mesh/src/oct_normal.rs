//! Unit vectors in 32 bits. Twin: `shaders/edge_mesh/oct_normal.wgsl`
//!
//! Zina Cigolle, Sam Donow, Daniel Evangelakos, Michael Mara, Morgan McGuire and Quirin Meyer, "A survey of efficient
//! representations for independent unit vectors", Journal of Computer Graphics Techniques 3(2), 2014, section 3: the sphere is
//! projected onto an octahedron, whose lower half is folded over the upper one, and the square that this makes is stored as two
//! 16-bit numbers.
//!
//! # Error
//! Rounding moves either coordinate by at most h = 1 / 65534, so that the point on the octahedron moves by at most h along x and y and
//! by 2 h along z: by sqrt(6) h. The octahedron is at least 1 / sqrt(3) from its middle, so that the direction turns by at most
//! sqrt(18) h = 6.5e-5 rad. [`ERROR_RAD`] adds the rounding of 32-bit arithmetic.

use silhouette_core::glam::{Vec2, Vec3};

/// Most that a normal turns when it is stored, in radians: 0.004 degrees.
pub const ERROR_RAD: f64 = 6.6e-5;

/// Largest value of either coordinate as it is stored.
const SCALE: f32 = 32767.0;

/// What stands for a vector without direction; no direction is stored as this.
pub const NO_NORMAL: u32 = 0x8000_8000;

/// Stores the direction of a vector; [`NO_NORMAL`] for one whose length is 0 or beyond 32 bits.
pub fn encode(normal: Vec3) -> u32 {
    let sum = normal.abs().element_sum();
    let has_direction = sum > 0.0 && sum <= f32::MAX;
    if !has_direction {
        return NO_NORMAL;
    }
    let upper = Vec2::new(normal.x, normal.y) / sum;
    let square = if normal.z < 0.0 { fold(upper) } else { upper };
    let part = |value: f32| (0.5 + SCALE * value.clamp(-1.0, 1.0)).floor() as i16 as u16;
    u32::from(part(square.x)) | u32::from(part(square.y)) << 16
}

/// The unit vector that was stored; any for [`NO_NORMAL`].
pub fn decode(stored: u32) -> Vec3 {
    let part = |bits: u32| (f32::from(bits as u16 as i16) / SCALE).max(-1.0);
    let square = Vec2::new(part(stored), part(stored >> 16));
    let z = 1.0 - square.x.abs() - square.y.abs();
    let upper = if z < 0.0 { fold(square) } else { square };
    upper.extend(z).normalize()
}

/// Mirrors a point of one half of the square at the diagonal of its quadrant.
fn fold(point: Vec2) -> Vec2 {
    let sign = |value: f32| if value < 0.0 { -1.0 } else { 1.0 };
    Vec2::new((1.0 - point.y.abs()) * sign(point.x), (1.0 - point.x.abs()) * sign(point.y))
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_testing::Random;

    /// Angle between a vector and what is stored of it, in radians.
    fn error_rad(normal: Vec3) -> f64 {
        let (given, stored) = (normal.as_dvec3(), decode(encode(normal)).as_dvec3());
        given.cross(stored).length().atan2(given.dot(stored))
    }

    #[test]
    fn directions_turn_by_no_more_than_the_bound() {
        let mut random = Random::new(1);
        let mut worst = 0.0_f64;
        for _ in 0..200_000 {
            let normal = random.vector().as_vec3() * 10.0_f32.powi(random.whole(-12..12));
            if normal.length() > 0.0 {
                worst = worst.max(error_rad(normal));
            }
        }
        assert!(worst <= ERROR_RAD, "{worst}");
        // The bound is not far off: a smaller one would be broken.
        assert!(worst > 0.8 * ERROR_RAD, "{worst}");
    }

    #[test]
    fn axes_and_diagonals_are_as_exact_as_others_and_flat_input_is_harmless() {
        for x in [-1.0, 0.0, 1.0] {
            for y in [-1.0, 0.0, 1.0] {
                for z in [-1.0, 0.0, 1.0] {
                    let normal = Vec3::new(x, y, z);
                    if normal != Vec3::ZERO {
                        assert!(error_rad(normal) <= ERROR_RAD, "{normal}");
                    }
                }
            }
        }
        for normal in [Vec3::ZERO, Vec3::NAN, Vec3::INFINITY] {
            assert_eq!(encode(normal), NO_NORMAL);
        }
        assert!((0..=u32::MAX).step_by(65_521).all(|stored| (decode(stored).length() - 1.0).abs() < 1e-5));
    }
}
