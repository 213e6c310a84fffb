//! The open grid.

use super::builtin::{ArgumentSpec, Builtin, ShapeError};
use super::lattice::Lattice;
use crate::mesh::TriangleMesh;
use glam::DVec3;

/// A flat or wavy square sheet of side 2 about the origin, seen from +y from its front.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Height of the waves, 0 (flat) to 1. Default: 0.
    pub relief: f64,
}

pub(super) static GRID: Builtin = Builtin {
    name: "grid",
    summary: "An open sheet, flat unless relief is given: one boundary loop, every face in one plane.",
    arguments: &[
        ArgumentSpec::count("columns", "squares along x", [1, 8192], 16),
        ArgumentSpec::count("rows", "squares along z", [1, 8192], 16),
        ArgumentSpec::number("relief", "height of the waves", [0.0, 1.0], 0.0),
    ],
    genus: None,
    build: |values| Grid { relief: values[2] }.mesh(values[0] as u32, values[1] as u32),
    contour: None,
};

impl Default for Grid {
    fn default() -> Self {
        Self { relief: 0.0 }
    }
}

impl Grid {
    /// `columns` x `rows` squares (1 to 8192 each): 2 * columns * rows faces.
    ///
    /// # Errors
    /// [`ShapeError`] where an argument is out of range or there would be too many faces.
    pub fn mesh(&self, columns: u32, rows: u32) -> Result<TriangleMesh, ShapeError> {
        let faces = 2 * u64::from(columns) * u64::from(rows);
        GRID.check(&[f64::from(columns), f64::from(rows), self.relief], faces)?;
        Ok(Lattice::open(columns, rows).mesh(|column, row| {
            let x = 2.0 * f64::from(column) / f64::from(columns) - 1.0;
            let z = 1.0 - 2.0 * f64::from(row) / f64::from(rows);
            DVec3::new(x, self.relief * (3.0 * x + 0.5).sin() * (2.5 * z).cos(), z)
        }))
    }
}
