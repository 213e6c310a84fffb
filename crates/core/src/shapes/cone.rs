//! The capped cone.

use super::builtin::{ArgumentSpec, Builtin, ShapeError};
use super::revolution::{face_count, revolve};
use crate::mesh::TriangleMesh;
use glam::DVec2;

/// A capped cone about the y axis, apex up, its middle height at the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    /// Radius of the base, 0.01 to 100. Default: 0.8.
    pub radius: f64,
    /// Height from base to apex, 0.01 to 100. Default: 1.6.
    pub height: f64,
}

pub(super) static CONE: Builtin = Builtin {
    name: "cone",
    summary: "A capped cone: one apex of high degree, where normals have no limit.",
    arguments: &[
        ArgumentSpec::count("segments", "faces around", [3, 65_536], 64),
        ArgumentSpec::length("radius", "radius of the base", 0.8),
        ArgumentSpec::length("height", "length along y", 1.6),
    ],
    genus: Some(0),
    build: |values| Cone { radius: values[1], height: values[2] }.mesh(values[0] as u32),
    contour: None,
};

impl Default for Cone {
    fn default() -> Self {
        Self { radius: 0.8, height: 1.6 }
    }
}

impl Cone {
    /// `segments` (3 to 65536) around: 2 * segments faces. The base is a fan about a vertex on the axis.
    ///
    /// # Errors
    /// [`ShapeError`] where an argument is out of range.
    pub fn mesh(&self, segments: u32) -> Result<TriangleMesh, ShapeError> {
        CONE.check(&[f64::from(segments), self.radius, self.height], face_count(segments, 1))?;
        let ends = [-0.5 * self.height, 0.5 * self.height];
        Ok(revolve(ends, &[DVec2::new(self.radius, ends[0])], segments))
    }
}
