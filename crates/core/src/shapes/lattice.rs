//! Quadrilateral lattices cut into triangles: the common frame of tori, knots, gears and grids.

use super::finish;
use crate::mesh::TriangleMesh;
use glam::DVec3;
use rayon::prelude::*;

/// `columns` x `rows` quadrilaterals; each direction is either closed (its last line of vertices is its first) or open.
///
/// The outward side is columns x rows: with columns to the right and rows upwards, the triangles face the reader.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lattice {
    pub columns: u32,
    pub rows: u32,
    pub columns_closed: bool,
    pub rows_closed: bool,
}

impl Lattice {
    /// Closed in both directions: a torus.
    pub fn closed(columns: u32, rows: u32) -> Self {
        Self { columns, rows, columns_closed: true, rows_closed: true }
    }

    /// Open in both directions: a sheet.
    pub fn open(columns: u32, rows: u32) -> Self {
        Self { columns, rows, columns_closed: false, rows_closed: false }
    }

    /// The mesh with `position(column, row)` at each vertex; vertices and faces are ordered by rows.
    pub fn mesh(self, position: impl Fn(u32, u32) -> DVec3 + Sync) -> TriangleMesh {
        let width = self.columns + u32::from(!self.columns_closed);
        let height = self.rows + u32::from(!self.rows_closed);
        let position = &position;
        let positions = (0..height)
            .into_par_iter()
            .flat_map_iter(|row| (0..width).map(move |column| position(column, row).as_vec3()))
            .collect();
        let vertex = |column: u32, row: u32| row % height * width + column % width;
        let triangles = (0..self.rows)
            .into_par_iter()
            .flat_map_iter(|row| {
                (0..self.columns).flat_map(move |column| {
                    let [a, b] = [vertex(column, row), vertex(column + 1, row)];
                    let [d, c] = [vertex(column, row + 1), vertex(column + 1, row + 1)];
                    [[a, b, c], [a, c, d]]
                })
            })
            .collect();
        finish(positions, triangles)
    }
}
