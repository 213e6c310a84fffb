//! The torus.

use super::builtin::{ArgumentSpec, Builtin, ShapeError};
use super::lattice::Lattice;
use crate::mesh::TriangleMesh;
use glam::DVec3;

/// A ring torus about the y axis, centred on the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Torus {
    /// Distance of the tube's centre line from the axis, 0.01 to 100. Default: 1.
    pub major_radius: f64,
    /// Radius of the tube, 0.01 of `major_radius` to less than `major_radius`. Default: 0.4.
    pub minor_radius: f64,
}

pub(super) static TORUS: Builtin = Builtin {
    name: "torus",
    summary: "A torus: genus 1, concave on the inside, two contour generators in a general view.",
    arguments: &[
        ArgumentSpec::count("around", "faces around the axis", [3, 8192], 64),
        ArgumentSpec::count("across", "faces around the tube", [3, 8192], 32),
        ArgumentSpec::length("major-radius", "radius of the tube's centre line", 1.0),
        ArgumentSpec::length("minor-radius", "radius of the tube", 0.4),
    ],
    genus: Some(1),
    build: |values| from(values).mesh(values[0] as u32, values[1] as u32),
    contour: Some(|values| {
        let torus = from(values);
        torus.check_radii()?;
        Ok(Box::new(torus))
    }),
};

fn from(values: &[f64]) -> Torus {
    Torus { major_radius: values[2], minor_radius: values[3] }
}

impl Default for Torus {
    fn default() -> Self {
        Self { major_radius: 1.0, minor_radius: 0.4 }
    }
}

impl Torus {
    /// `around` (3 to 8192) faces around the axis times `across` (3 to 8192) around the tube: 2 * around * across faces.
    /// Vertex `row * around + column` lies `row` steps around the tube from the outer equator, first upwards.
    ///
    /// # Errors
    /// [`ShapeError`] where an argument is out of range, the radii do not fit or there would be too many faces.
    pub fn mesh(&self, around: u32, across: u32) -> Result<TriangleMesh, ShapeError> {
        let Self { major_radius, minor_radius } = *self;
        let faces = 2 * u64::from(around) * u64::from(across);
        TORUS.check(&[f64::from(around), f64::from(across), major_radius, minor_radius], faces)?;
        self.check_radii()?;
        Ok(Lattice::closed(around, across).mesh(|column, row| {
            let (sin, cos) = super::turn(row, across).sin_cos();
            super::around_y(super::turn(column, around)) * (major_radius + minor_radius * cos)
                + DVec3::Y * (minor_radius * sin)
        }))
    }

    fn check_radii(&self) -> Result<(), ShapeError> {
        if (0.01 * self.major_radius..self.major_radius).contains(&self.minor_radius) {
            return Ok(());
        }
        let rule = "minor-radius must be below major-radius and at least a hundredth of it";
        Err(ShapeError::Combination { shape: TORUS.name, rule })
    }
}
