//! [`Frame`]: the tangent frame in which directions at a hull point are expressed. Twin: `shaders/texture/frame.wgsl`.
//!
//! Departures from the paper's pixel shader (appendix A):
//!
//! 1. The binormal is `cross(tangent, normal)` as printed. In a right-handed space azimuths then run clockwise seen against the
//!    normal, where the paper's text says counter-clockwise; baker and renderer share this file's convention.
//! 2. A tangent that vanishes or is parallel to the normal is replaced by a fixed perpendicular, and the azimuth of the normal
//!    itself is 0, so that no direction has an undefined place.

use glam::Vec3;
use silhouette_core::glam;
use std::f32::consts::TAU;

/// Below this length the component of a tangent across the normal has no certain direction.
const LEAST_TANGENT: f32 = 1e-4;

/// Right-angled axes at a hull point. Directions run from the eye into the object.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Unit: the middle of the lobe, which the paper calls C and its shader the normal. Points into the object.
    pub center: Vec3,
    /// Unit, across `center`: where azimuths begin.
    pub tangent: Vec3,
    /// Unit: `tangent` x `center`, at a quarter turn of azimuth.
    pub binormal: Vec3,
}

impl Frame {
    /// The frame of a centre and a tangent, both of any length; the tangent need not be perpendicular. A zero or non-finite
    /// centre counts as +z.
    pub fn new(center: Vec3, tangent: Vec3) -> Self {
        let center = center.try_normalize().unwrap_or(Vec3::Z);
        let across = tangent - tangent.dot(center) * center;
        let tangent = if across.length() > LEAST_TANGENT { across.normalize() } else { perpendicular(center) };
        Self { center, tangent, binormal: tangent.cross(center) }
    }

    /// The azimuth of a direction, in turns from 0 to below 1; 0 for the centre and its opposite.
    pub fn azimuth(&self, direction: Vec3) -> f32 {
        let (x, y) = (direction.dot(self.tangent), direction.dot(self.binormal));
        let turns = y.atan2(x) / TAU;
        let turns = if turns < 0.0 { turns + 1.0 } else { turns };
        if turns < 1.0 { turns } else { 0.0 }
    }

    /// The angle between the centre and a direction of any length, in radians from 0 to pi.
    pub fn angle(&self, direction: Vec3) -> f32 {
        self.center.cross(direction).length().atan2(self.center.dot(direction))
    }

    /// The unit direction at an azimuth in turns and an angle from the centre in radians.
    pub fn direction(&self, azimuth: f32, angle: f32) -> Vec3 {
        let (y, x) = (azimuth * TAU).sin_cos();
        let (sin, cos) = angle.sin_cos();
        sin * (x * self.tangent + y * self.binormal) + cos * self.center
    }
}

/// A unit vector across a unit vector: along the axis that it is least along.
fn perpendicular(unit: Vec3) -> Vec3 {
    let size = unit.abs();
    let axis = if size.x <= size.y && size.x <= size.z {
        Vec3::X
    } else if size.y <= size.z {
        Vec3::Y
    } else {
        Vec3::Z
    };
    (axis - axis.dot(unit) * unit).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// One asymmetric direction: a quarter turn from the tangent lies along `tangent` x `center`.
    #[test]
    fn azimuths_run_from_the_tangent_towards_the_binormal() {
        let frame = Frame::new(Vec3::Z, Vec3::X);
        assert_eq!(frame.binormal, -Vec3::Y);
        assert!((frame.azimuth(-Vec3::Y + Vec3::Z) - 0.25).abs() < 1e-6);
        assert!((frame.azimuth(Vec3::Y) - 0.75).abs() < 1e-6);
        assert_eq!(frame.azimuth(Vec3::Z).to_bits(), 0);
    }

    #[test]
    fn a_frame_without_a_tangent_is_still_one() {
        for center in [Vec3::X, Vec3::Y, Vec3::Z, Vec3::ZERO, Vec3::NAN] {
            for tangent in [center, Vec3::ZERO] {
                let frame = Frame::new(center, tangent);
                assert!(frame.tangent.is_normalized() && frame.center.is_normalized());
                assert!(frame.tangent.dot(frame.center).abs() < 1e-6);
            }
        }
    }

    proptest! {
        #[test]
        fn a_direction_is_found_again_by_its_azimuth_and_angle(
            center in prop::array::uniform3(-1.0_f32..1.0),
            tangent in prop::array::uniform3(-1.0_f32..1.0),
            azimuth in 0.0_f32..1.0,
            angle in 0.01_f32..3.1,
        ) {
            prop_assume!(Vec3::from(center).length() > 1e-3);
            let frame = Frame::new(center.into(), tangent.into());
            let direction = frame.direction(azimuth, angle);
            prop_assert!((frame.angle(direction) - angle).abs() < 1e-5);
            let turns = (frame.azimuth(direction) - azimuth).abs();
            prop_assert!(turns.min(1.0 - turns) * angle.sin() < 1e-5);
        }
    }
}
