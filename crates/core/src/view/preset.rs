//! Named views, in worlds with y up or z up.

use glam::{DVec3, Vec3};

/// Which axis of a world points up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum UpAxis {
    /// y, and the front faces +z: modelling programs, glTF.
    #[default]
    Y,
    /// z, and the front faces -y: CAD, surveying, printing.
    Z,
}

impl UpAxis {
    /// Turns a direction of a world whose y is up into that of this one.
    pub fn from_y_up(self, direction: DVec3) -> DVec3 {
        match self {
            Self::Y => direction,
            Self::Z => DVec3::new(direction.x, -direction.z, direction.y),
        }
    }
}

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

    /// [`directions`](Self::directions) in a world with this axis up: a front view is from +z or from -y.
    pub fn directions_with(self, up_axis: UpAxis) -> (DVec3, Vec3) {
        let (direction, up) = self.directions();
        (up_axis.from_y_up(direction), up_axis.from_y_up(up.as_dvec3()).as_vec3())
    }

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
            for up_axis in [UpAxis::Y, UpAxis::Z] {
                let (direction, up) = preset.directions_with(up_axis);
                assert!(Camera::framing(&bounds, direction, up, Framing::Orthographic, [9, 9]).is_ok(), "{name}");
            }
        }
    }

    #[test]
    fn a_world_with_z_up_is_seen_from_minus_y() {
        let of = |preset: ViewPreset| preset.directions_with(UpAxis::Z);
        assert_eq!(of(ViewPreset::Front), (DVec3::NEG_Y, Vec3::Z));
        assert_eq!(of(ViewPreset::Right), (DVec3::X, Vec3::Z));
        assert_eq!(of(ViewPreset::Top), (DVec3::Z, Vec3::Y));
    }
}
