//! Whether a pull survives the depth buffer: how large one depth step is, and what to choose where a pull is smaller.

use crate::settings::Variant;
use crate::{depth_range, scale};
use silhouette_core::mesh::Bounds;
use silhouette_core::view::{Camera, ClipRange, DepthDirection, Projection};
use std::fmt;

/// How a depth buffer stores its values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DepthBits {
    /// 16 bits, evenly spaced.
    Unorm16,
    /// 24 bits, evenly spaced.
    Unorm24,
    /// 32-bit floats.
    Float32,
}

impl DepthBits {
    /// Distance from a value, 0 to 1, to the next that can be stored.
    pub fn step_at(self, value: f64) -> f64 {
        match self {
            Self::Unorm16 => 1.0 / 65_535.0,
            Self::Unorm24 => 1.0 / 16_777_215.0,
            Self::Float32 => {
                let value = value as f32;
                f64::from(f32::from_bits(value.to_bits() + 1) - value)
            }
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Unorm16 => "16-bit",
            Self::Unorm24 => "24-bit",
            Self::Float32 => "32-bit float",
        }
    }
}

/// One step of a depth buffer at a depth, in world units.
pub fn depth_step(camera: &Camera, range: ClipRange, direction: DepthDirection, bits: DepthBits, depth: f64) -> f64 {
    let clip = camera.clip_matrix(range, direction);
    let value = clip.project_point3(silhouette_core::glam::DVec3::Z * -depth).z.clamp(0.0, 1.0);
    let step = bits.step_at(value);
    let next = if value + step <= 1.0 { value + step } else { value - step };
    (camera.depth_of_buffer_value(next, range, direction) - camera.depth_of_buffer_value(value, range, direction)).abs()
}

/// A pull that is smaller than one depth step somewhere on the mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PullBelowDepthStep {
    /// The pull at that depth, in world units.
    pub pull: f64,
    /// One step of the depth buffer there, in world units.
    pub step: f64,
    /// The depth: that of the mesh's farthest point.
    pub depth: f64,
    /// The buffer.
    pub bits: DepthBits,
    /// Its direction.
    pub direction: DepthDirection,
    /// Near over far plane.
    pub near_to_far: f64,
}

impl fmt::Display for PullBelowDepthStep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { pull, step, depth, bits, direction, near_to_far } = self;
        write!(
            f,
            "at depth {depth:.3} back faces are pulled by {pull:.2e}, but one step of the {} depth buffer is {step:.2e}, so \
             lines are lost there; choose variant=screen, which pulls nothing, a larger pull",
            bits.name()
        )?;
        match (bits, direction) {
            (DepthBits::Float32, DepthDirection::Reversed) => {
                write!(f, ", or near and far planes closer to each other than {near_to_far:.0e}")
            }
            _ => write!(f, ", or a 32-bit float buffer with reversed depth"),
        }
    }
}

/// `Some` where the pull of `variant` is below one step at the mesh's farthest point, where steps of a perspective are
/// coarsest. `None` for variants that do not pull in space or that pull by depth steps, and for a pull of zero.
pub fn check(
    variant: Variant,
    camera: &Camera,
    bounds: &Bounds,
    range: ClipRange,
    direction: DepthDirection,
    bits: DepthBits,
) -> Option<PullBelowDepthStep> {
    let middle = -camera.view_matrix().transform_point3(bounds.center).z;
    let depth = (middle + bounds.radius).min(range.far);
    let is_orthographic = matches!(camera.projection(), Projection::Orthographic { .. });
    let pull = match variant {
        Variant::FixedPull { radii } => radii * bounds.radius,
        Variant::Scale { k } | Variant::Unoriented { k: Some(k) } => scale::pull_at(camera, depth, k),
        // At the far plane itself a moved near plane pulls nothing; the mesh's middle says more.
        Variant::DepthRange { plane, factor } if !is_orthographic => {
            depth_range::pull_at(range, plane, factor, middle.max(range.near)).max(0.0)
        }
        _ => return None,
    };
    let step = depth_step(camera, range, direction, bits, depth);
    let near_to_far = range.near / range.far;
    (pull > 0.0 && pull < step).then_some(PullBelowDepthStep { pull, step, depth, bits, direction, near_to_far })
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::{DVec3, Vec3};

    fn scene(distance: f32) -> (Camera, Bounds) {
        let projection = Projection::Perspective { fov_y_rad: 0.8 };
        let bounds = Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE, center: DVec3::ZERO, radius: 1.0 };
        (Camera::new(Vec3::Z * distance, Vec3::ZERO, Vec3::Y, projection, [64, 64]).unwrap(), bounds)
    }

    #[test]
    fn steps_are_worth_what_the_formula_for_even_spacing_says() {
        let (camera, _) = scene(4.0);
        let range = ClipRange { near: 0.01, far: 10.0 };
        for (bits, count) in [(DepthBits::Unorm16, 65_535.0), (DepthBits::Unorm24, 16_777_215.0)] {
            for depth in [1.0, 5.0] {
                let formula = depth * depth * (range.far - range.near) / (range.far * range.near * count);
                let step = depth_step(&camera, range, DepthDirection::Standard, bits, depth);
                assert!((step / formula - 1.0).abs() < 0.02, "{bits:?} at {depth}: {step} {formula}");
            }
        }
        let float = depth_step(&camera, range, DepthDirection::Reversed, DepthBits::Float32, 5.0);
        assert!(float < 1e-6, "{float}");
    }

    #[test]
    fn a_pull_below_a_step_is_reported_with_what_to_choose() {
        let (camera, bounds) = scene(4.0);
        let check = |variant, near, bits, direction| {
            check(variant, &camera, &bounds, ClipRange { near, far: 5.0 }, direction, bits)
        };
        let scale = Variant::Scale { k: 0.99 };
        let standard = DepthDirection::Standard;
        let warning = check(scale, 5e-4, DepthBits::Unorm16, standard).unwrap();
        assert!(warning.pull < warning.step);
        let text = warning.to_string();
        assert!(text.contains("16-bit") && text.contains("variant=screen") && text.contains("reversed"), "{text}");
        assert_eq!(check(scale, 5e-4, DepthBits::Float32, DepthDirection::Reversed), None);
        assert_eq!(check(scale, 2.9, DepthBits::Unorm16, standard), None);
        assert_eq!(check(Variant::Screen, 5e-4, DepthBits::Unorm16, standard), None);
        assert_eq!(check(Variant::Scale { k: 1.0 }, 5e-4, DepthBits::Unorm16, standard), None);
    }

    #[test]
    fn a_fixed_pull_from_afar_is_below_a_step() {
        let (camera, bounds) = scene(1e6);
        let range = ClipRange { near: 1.0, far: 2e6 };
        let variant = Variant::FixedPull { radii: 0.03 };
        let check = |variant| check(variant, &camera, &bounds, range, DepthDirection::Standard, DepthBits::Float32);
        assert!(check(variant).is_some());
    }
}
