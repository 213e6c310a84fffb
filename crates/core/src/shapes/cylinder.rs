//! The capped cylinder.

use super::builtin::{ArgumentSpec, Builtin, ShapeError};
use super::revolution::{face_count, revolve};
use crate::mesh::TriangleMesh;
use glam::DVec2;

/// A capped cylinder about the y axis, centred on the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cylinder {
    /// Radius, 0.01 to 100. Default: 0.6.
    pub radius: f64,
    /// Height from cap to cap, 0.01 to 100. Default: 2.
    pub height: f64,
}

pub(super) static CYLINDER: Builtin = Builtin {
    name: "cylinder",
    summary: "A capped cylinder: smooth sides, two circular creases, long thin faces.",
    arguments: &[
        ArgumentSpec::count("segments", "faces around", [3, 65_536], 64),
        ArgumentSpec::length("radius", "radius", 0.6),
        ArgumentSpec::length("height", "length along y", 2.0),
    ],
    genus: Some(0),
    build: |values| Cylinder { radius: values[1], height: values[2] }.mesh(values[0] as u32),
    contour: Some(|values| Ok(Box::new(Cylinder { radius: values[1], height: values[2] }))),
};

impl Default for Cylinder {
    fn default() -> Self {
        Self { radius: 0.6, height: 2.0 }
    }
}

impl Cylinder {
    /// `segments` (3 to 65536) around: 4 * segments faces. Each cap is a fan about a vertex on the axis.
    ///
    /// # Errors
    /// [`ShapeError`] where an argument is out of range.
    pub fn mesh(&self, segments: u32) -> Result<TriangleMesh, ShapeError> {
        CYLINDER.check(&[f64::from(segments), self.radius, self.height], face_count(segments, 2))?;
        let ends = [-0.5 * self.height, 0.5 * self.height];
        Ok(revolve(ends, &ends.map(|y| DVec2::new(self.radius, y)), segments))
    }
}
