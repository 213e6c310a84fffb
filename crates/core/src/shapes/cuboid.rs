//! The cuboid: twelve faces, all creases.

use super::builtin::{ArgumentSpec, Builtin, ShapeError};
use crate::mesh::TriangleMesh;
use glam::Vec3;

/// An axis-aligned box about the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cuboid {
    /// Edge lengths along x, y and z, each 0.01 to 100. Default: 2.
    pub size: [f64; 3],
}

pub(super) static CUBE: Builtin = Builtin {
    name: "cube",
    summary: "A box of 12 faces: coplanar pairs, sharp edges, faces edge-on in the axis views.",
    arguments: &[
        ArgumentSpec::length("size-x", "edge length along x", 2.0),
        ArgumentSpec::length("size-y", "edge length along y", 2.0),
        ArgumentSpec::length("size-z", "edge length along z", 2.0),
    ],
    genus: Some(0),
    build: |values| Cuboid { size: [values[0], values[1], values[2]] }.mesh(),
    contour: None,
};

impl Default for Cuboid {
    fn default() -> Self {
        Self { size: [2.0; 3] }
    }
}

/// Corners of each side, counter-clockwise from outside. Bit 0 of a corner's index is x, bit 1 is y, bit 2 is z.
const SIDES: [[u32; 4]; 6] = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

impl Cuboid {
    /// Eight vertices, twelve faces; two consecutive faces make a side, in the order -x, +x, -y, +y, -z, +z.
    ///
    /// # Errors
    /// [`ShapeError`] where an edge length is out of range.
    pub fn mesh(&self) -> Result<TriangleMesh, ShapeError> {
        CUBE.check(&self.size, 12)?;
        let half = Vec3::from_array(self.size.map(|length| (length * 0.5) as f32));
        let sign = |corner: u32, axis: u32| if corner >> axis & 1 == 1 { 1.0 } else { -1.0 };
        let corner = |c: u32| half * Vec3::new(sign(c, 0), sign(c, 1), sign(c, 2));
        let triangles = SIDES.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        Ok(super::finish((0..8).map(corner).collect(), triangles))
    }
}
