//! Whether a pull survives the depth buffer: how large one depth step is, and what to choose where a pull is smaller.

use crate::depth_range;
use crate::settings::Variant;
use silhouette_core::mesh::Bounds;
use silhouette_core::view::DepthDirection;
use silhouette_gpu::{DepthLaw, FrameView};
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

/// One step of a depth buffer at a depth, in units of view space.
pub fn depth_step(law: &DepthLaw, bits: DepthBits, depth: f64) -> f64 {
    let value = law.value_at(depth).clamp(0.0, 1.0);
    let step = bits.step_at(value);
    let next = if value + step <= 1.0 { value + step } else { value - step };
    (law.depth_of_value(next) - law.depth_of_value(value)).abs()
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
pub fn check(variant: Variant, view: &FrameView, bounds: &Bounds, bits: DepthBits) -> Option<PullBelowDepthStep> {
    let law = view.depth_law();
    let (range, direction) = (law.range(), law.direction());
    let (middle, radius) = (view.depth(bounds.center), bounds.radius * view.largest_scale());
    let depth = (middle + radius).min(range.far);
    let pull = match variant {
        Variant::FixedPull { radii } => radii * radius,
        Variant::Scale { k } | Variant::Unoriented { k: Some(k) } => {
            (1.0 - k) * if view.is_perspective() { depth } else { middle }
        }
        // At the far plane itself a moved near plane pulls nothing; the mesh's middle says more.
        Variant::DepthRange { plane, factor } if view.is_perspective() => {
            depth_range::pull_at(range, plane, factor, middle.max(range.near)).max(0.0)
        }
        _ => return None,
    };
    let step = depth_step(law, bits, depth);
    let near_to_far = range.near / range.far;
    (pull > 0.0 && pull < step).then_some(PullBelowDepthStep { pull, step, depth, bits, direction, near_to_far })
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::{DVec3, Vec3};
    use silhouette_core::view::{Camera, ClipRange, Projection};

    fn scene(distance: f32, range: ClipRange, direction: DepthDirection) -> (FrameView, Bounds) {
        let projection = Projection::Perspective { fov_y_rad: 0.8 };
        let bounds = Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE, center: DVec3::ZERO, radius: 1.0 };
        let camera = Camera::new(Vec3::Z * distance, Vec3::ZERO, Vec3::Y, projection, [64, 64]).unwrap();
        (FrameView::from_camera(&camera, range, direction).unwrap(), bounds)
    }

    #[test]
    fn steps_are_as_large_as_the_formula_for_even_spacing_says() {
        let range = ClipRange { near: 0.01, far: 10.0 };
        let (standard, _) = scene(4.0, range, DepthDirection::Standard);
        for (bits, count) in [(DepthBits::Unorm16, 65_535.0), (DepthBits::Unorm24, 16_777_215.0)] {
            for depth in [1.0, 5.0] {
                let formula = depth * depth * (range.far - range.near) / (range.far * range.near * count);
                let step = depth_step(standard.depth_law(), bits, depth);
                assert!((step / formula - 1.0).abs() < 0.02, "{bits:?} at {depth}: {step} {formula}");
            }
        }
        let (reversed, _) = scene(4.0, range, DepthDirection::Reversed);
        let float = depth_step(reversed.depth_law(), DepthBits::Float32, 5.0);
        assert!(float < 1e-6, "{float}");
    }

    #[test]
    fn a_pull_below_a_step_is_reported_with_what_to_choose() {
        let check = |variant, near, bits, direction| {
            let (view, bounds) = scene(4.0, ClipRange { near, far: 5.0 }, direction);
            check(variant, &view, &bounds, bits)
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
        let (view, bounds) = scene(1e6, ClipRange { near: 1.0, far: 2e6 }, DepthDirection::Standard);
        assert!(check(Variant::FixedPull { radii: 0.03 }, &view, &bounds, DepthBits::Float32).is_some());
    }
}
