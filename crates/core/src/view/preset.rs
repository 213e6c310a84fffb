//! Named views.

use glam::{DVec3, Vec3};

/// Named views, in a world whose y is up and whose front faces +z.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ViewPreset {
    /// From the right, above and in front, unevenly, so that axis-aligned faces are not edge-on.
    #[default]
    ThreeQuarter,
    /// From +z.
    Front,
    /// From -z.
    Back,
    /// From -x.
    Left,
    /// From +x.
    Right,
    /// From +y, -z at the top.
    Top,
    /// From -y, +z at the top.
    Bottom,
    /// From (1, 1, 1).
    Iso,
}

impl ViewPreset {
    /// Every preset with the name the command line uses.
    pub const NAMED: [(&'static str, Self); 8] = [
        ("three-quarter", Self::ThreeQuarter),
        ("front", Self::Front),
        ("back", Self::Back),
        ("left", Self::Left),
        ("right", Self::Right),
        ("top", Self::Top),
        ("bottom", Self::Bottom),
        ("iso", Self::Iso),
    ];

    /// Direction from the object towards the viewer (not normalised), and up.
    pub fn directions(self) -> (DVec3, Vec3) {
        match self {
            Self::ThreeQuarter => (DVec3::new(0.55, 0.35, 1.0), Vec3::Y),
            Self::Front => (DVec3::Z, Vec3::Y),
            Self::Back => (DVec3::NEG_Z, Vec3::Y),
            Self::Left => (DVec3::NEG_X, Vec3::Y),
            Self::Right => (DVec3::X, Vec3::Y),
            Self::Top => (DVec3::Y, Vec3::NEG_Z),
            Self::Bottom => (DVec3::NEG_Y, Vec3::Z),
            Self::Iso => (DVec3::ONE, Vec3::Y),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Bounds;
    use crate::view::{Camera, Framing};

    #[test]
    fn every_preset_makes_a_camera() {
        let bounds = Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE, center: DVec3::ZERO, radius: 1.8 };
        for (name, preset) in ViewPreset::NAMED {
            let (direction, up) = preset.directions();
            assert!(Camera::framing(&bounds, direction, up, Framing::Orthographic, [9, 9]).is_ok(), "{name}");
        }
    }
}
