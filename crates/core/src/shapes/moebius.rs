//! The Möbius strip.

use super::builtin::{ArgumentSpec, Builtin, ShapeError};
use super::{around_y, finish, turn};
use crate::mesh::TriangleMesh;
use glam::DVec3;

/// A strip with half a twist around a circle of radius 1 about the y axis: it has one side and one boundary loop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MoebiusStrip {
    /// Width across, 0.01 to 1. Default: 0.6.
    pub width: f64,
}

pub(super) static MOEBIUS: Builtin = Builtin {
    name: "moebius",
    summary: "A strip with half a twist: it cannot be oriented, so facing flips along one seam.",
    arguments: &[
        ArgumentSpec::count("around", "faces around the axis", [8, 65_536], 64),
        ArgumentSpec::count("across", "faces across the strip", [1, 4096], 8),
        ArgumentSpec::number("width", "width across", [0.01, 1.0], 0.6),
    ],
    genus: None,
    build: |values| MoebiusStrip { width: values[2] }.mesh(values[0] as u32, values[1] as u32),
    contour: None,
};

impl Default for MoebiusStrip {
    fn default() -> Self {
        Self { width: 0.6 }
    }
}

impl MoebiusStrip {
    /// `around` (8 to 65536) x `across` (1 to 4096) squares: 2 * around * across faces. Winding is consistent but for the
    /// `across` edges between the last and the first column, as it must be somewhere.
    ///
    /// # Errors
    /// [`ShapeError`] where an argument is out of range or there would be too many faces.
    pub fn mesh(&self, around: u32, across: u32) -> Result<TriangleMesh, ShapeError> {
        let faces = 2 * u64::from(around) * u64::from(across);
        MOEBIUS.check(&[f64::from(around), f64::from(across), self.width], faces)?;
        let position = |column: u32, row: u32| {
            let angle = turn(column, around);
            let outward = around_y(angle);
            let (sin, cos) = (0.5 * angle).sin_cos();
            let offset = self.width * (f64::from(row) / f64::from(across) - 0.5);
            (outward + (outward * cos + DVec3::Y * sin) * offset).as_vec3()
        };
        let positions = (0..around).flat_map(|column| (0..=across).map(move |row| position(column, row))).collect();
        // The strip meets itself upside down.
        let vertex = |column: u32, row: u32| match column == around {
            true => across - row,
            false => column * (across + 1) + row,
        };
        let quad = |column: u32, row: u32| {
            let [a, b] = [vertex(column, row), vertex(column + 1, row)];
            let [d, c] = [vertex(column, row + 1), vertex(column + 1, row + 1)];
            [[a, b, c], [a, c, d]]
        };
        let triangles = (0..around).flat_map(|column| (0..across).flat_map(move |row| quad(column, row))).collect();
        Ok(finish(positions, triangles))
    }
}
