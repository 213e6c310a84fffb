//! The extruded ring.

use super::builtin::{ArgumentSpec, Builtin, ShapeError};
use super::lattice::Lattice;
use crate::mesh::TriangleMesh;
use glam::DVec3;

/// A ring of rectangular section about the y axis, centred on the origin: an annulus, extruded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ring {
    /// Radius of the outer wall, 0.01 to 100. Default: 1.
    pub outer_radius: f64,
    /// Radius of the inner wall, 0.01 to less than `outer_radius`. Default: 0.6.
    pub inner_radius: f64,
    /// Height, 0.01 to 100. Default: 0.4.
    pub height: f64,
}

pub(super) static RING: Builtin = Builtin {
    name: "ring",
    summary: "An extruded ring: genus 1, four circular creases of a right angle, two of them around the hole.",
    arguments: &[
        ArgumentSpec::count("segments", "faces around", [3, 65_536], 64),
        ArgumentSpec::length("outer-radius", "radius of the outer wall", 1.0),
        ArgumentSpec::length("inner-radius", "radius of the inner wall", 0.6),
        ArgumentSpec::length("height", "length along y", 0.4),
    ],
    genus: Some(1),
    build: |values| Ring { outer_radius: values[1], inner_radius: values[2], height: values[3] }.mesh(values[0] as u32),
    contour: None,
};

impl Default for Ring {
    fn default() -> Self {
        Self { outer_radius: 1.0, inner_radius: 0.6, height: 0.4 }
    }
}

impl Ring {
    /// `segments` (3 to 65536) around: 8 * segments faces. Vertex `row * segments + column` lies on the lower outer, upper
    /// outer, upper inner and lower inner circle in turn.
    ///
    /// # Errors
    /// [`ShapeError`] where an argument is out of range or the inner wall is not inside of the outer one.
    pub fn mesh(&self, segments: u32) -> Result<TriangleMesh, ShapeError> {
        let Self { outer_radius, inner_radius, height } = *self;
        RING.check(&[f64::from(segments), outer_radius, inner_radius, height], 8 * u64::from(segments))?;
        if inner_radius >= outer_radius {
            let rule = "inner-radius must be below outer-radius";
            return Err(ShapeError::Combination { shape: RING.name, rule });
        }
        Ok(Lattice::closed(segments, 4).mesh(|column, row| {
            let radius = if row < 2 { outer_radius } else { inner_radius };
            let y = if row == 1 || row == 2 { 0.5 } else { -0.5 } * height;
            super::around_y(super::turn(column, segments)) * radius + DVec3::Y * y
        }))
    }
}
