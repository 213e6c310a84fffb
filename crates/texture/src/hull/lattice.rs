//! [`Lattice`]: the points at which distances are sampled, and which of them lie outside of the offset surface.
//!
//! The lattice is body-centred cubic: corners and middles of cubes. Compared with the corners alone, split into the same
//! number of tetrahedra, these are closer to regular, and so is what is cut from them.

use glam::{DVec3, UVec3};
use rayon::prelude::*;
use silhouette_core::glam;
use silhouette_core::mesh::Bounds;
use silhouette_core::{Cancelled, Progress};
use silhouette_rays::MeshHierarchy;

/// Side of the blocks in which nodes are classified together.
const BLOCK: u32 = 8;

/// A node: a corner of a cube, or the middle of the cube above that corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Node {
    pub(super) is_middle: bool,
    pub(super) cube: UVec3,
}

/// A body-centred cubic lattice of points.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lattice {
    origin: DVec3,
    /// Side of a cube.
    cell: f64,
    /// Cubes along each axis.
    size: UVec3,
}

impl Lattice {
    /// Around everything within `offset` of a box: nodes of the outermost cubes are farther away. `None` if it would have
    /// more than `most` nodes.
    pub(super) fn around(bounds: &Bounds, offset: f64, cell: f64, most: u64) -> Option<Self> {
        // Two cubes beyond the offset on either side: one is the outermost, the other takes up rounding.
        let margin = offset + 2.0 * cell;
        let cubes = ((bounds.max - bounds.min + 2.0 * margin) / cell).ceil() + 1.0;
        let size = cubes.as_uvec3();
        (2.0 * cubes.element_product() <= most as f64).then_some(Self { origin: bounds.min - margin, cell, size })
    }

    /// Where a node lies.
    pub(super) fn place(&self, node: Node) -> DVec3 {
        self.origin + (node.cube.as_dvec3() + if node.is_middle { 0.5 } else { 0.0 }) * self.cell
    }

    /// The number of a node, below twice the number of cubes.
    pub(super) fn number(&self, node: Node) -> u32 {
        let UVec3 { x, y, z } = node.cube;
        2 * ((z * self.size.y + y) * self.size.x + x) + u32::from(node.is_middle)
    }

    /// The node of a number.
    pub(super) fn node(&self, number: u32) -> Node {
        let (row, x) = (number / 2 / self.size.x, number / 2 % self.size.x);
        Node { is_middle: number % 2 == 1, cube: UVec3::new(x, row % self.size.y, row / self.size.y) }
    }

    /// Cubes along each axis.
    pub(super) fn size(&self) -> UVec3 {
        self.size
    }

    /// The nodes closer than `offset` to a mesh. Distances are only measured near the border of that set, in blocks of which
    /// one distance bounds all.
    pub(super) fn within(
        &self,
        mesh: &MeshHierarchy,
        offset: f64,
        progress: &dyn Progress,
    ) -> Result<Nodes, Cancelled> {
        let mut nodes = Nodes::none(self.size);
        let columns = self.size.map(|side| side.div_ceil(BLOCK));
        let of_column = |column: u32| {
            let mut rows = Nodes::none(UVec3::new(self.size.x, BLOCK, BLOCK));
            let start = UVec3::new(0, column % columns.y, column / columns.y) * BLOCK;
            for block in 0..columns.x {
                progress.check()?;
                let of = Classified { lattice: self, mesh, offset, start };
                of.mark(start + UVec3::X * (block * BLOCK), BLOCK, &mut rows);
            }
            Ok(rows)
        };
        let found: Vec<Nodes> =
            (0..columns.y * columns.z).into_par_iter().map(of_column).collect::<Result<_, Cancelled>>()?;
        for (column, rows) in (0..).zip(found) {
            let (y, z) = (column % columns.y * BLOCK, column / columns.y * BLOCK);
            for (dy, dz) in (0..BLOCK * BLOCK).map(|row| (row % BLOCK, row / BLOCK)) {
                if y + dy < self.size.y && z + dz < self.size.z {
                    for is_middle in [false, true] {
                        nodes.row_mut(is_middle, y + dy, z + dz).copy_from_slice(rows.row(is_middle, dy, dz));
                    }
                }
            }
        }
        Ok(nodes)
    }
}

/// A column of blocks, of which nodes are classified.
struct Classified<'a> {
    lattice: &'a Lattice,
    mesh: &'a MeshHierarchy,
    offset: f64,
    start: UVec3,
}

impl Classified<'_> {
    /// Marks those nodes of a block of `side`³ cubes from `cube` on that are within the offset.
    fn mark(&self, cube: UVec3, side: u32, rows: &mut Nodes) {
        if cube.cmpge(self.lattice.size).any() {
            return;
        }
        if side == 1 {
            for is_middle in [false, true] {
                if self.mesh.is_within(self.lattice.place(Node { is_middle, cube }), self.offset) {
                    rows.set(is_middle, cube - self.start);
                }
            }
            return;
        }
        // Nodes span the block but for half a cube. Distance changes by at most the way.
        let half = (f64::from(side) - 0.5) * 0.5 * self.lattice.cell;
        let center = self.lattice.place(Node { is_middle: false, cube }) + half;
        let radius = half * 3.0_f64.sqrt() * (1.0 + 1e-9);
        match self.mesh.nearest(center, self.offset + radius) {
            None => {}
            Some(nearest) if nearest.distance + radius < self.offset => {
                for step in (0..side.pow(3)).map(|index| UVec3::new(index, index / side, index / side / side) % side) {
                    rows.set(false, cube + step - self.start);
                    rows.set(true, cube + step - self.start);
                }
            }
            Some(_) => {
                let half = side / 2;
                for corner in (0..8).map(|index| UVec3::new(index & 1, index >> 1 & 1, index >> 2)) {
                    self.mark(cube + corner * half, half, rows);
                }
            }
        }
    }
}

/// A set of nodes, one bit for each: rows along x of 64-bit words, of corners and of middles. Rows are filled up with nodes
/// beyond the lattice.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Nodes {
    size: UVec3,
    /// Words in a row.
    words: usize,
    corners: Vec<u64>,
    middles: Vec<u64>,
}

impl Nodes {
    fn none(size: UVec3) -> Self {
        let words = size.x.div_ceil(64) as usize;
        let all = vec![0; words * size.y as usize * size.z as usize];
        Self { size, words, corners: all.clone(), middles: all }
    }

    fn start(&self, y: u32, z: u32) -> usize {
        (z as usize * self.size.y as usize + y as usize) * self.words
    }

    /// The words of a row.
    pub(super) fn row(&self, is_middle: bool, y: u32, z: u32) -> &[u64] {
        let start = self.start(y, z);
        &(if is_middle { &self.middles } else { &self.corners })[start..start + self.words]
    }

    pub(super) fn row_mut(&mut self, is_middle: bool, y: u32, z: u32) -> &mut [u64] {
        let (start, words) = (self.start(y, z), self.words);
        &mut (if is_middle { &mut self.middles } else { &mut self.corners })[start..start + words]
    }

    fn set(&mut self, is_middle: bool, UVec3 { x, y, z }: UVec3) {
        // Blocks at the end of a row reach beyond it.
        if x < self.size.x {
            self.row_mut(is_middle, y, z)[x as usize / 64] |= 1 << (x % 64);
        }
    }

    /// Whether a node is one of them.
    pub(super) fn has(&self, node: Node) -> bool {
        let UVec3 { x, y, z } = node.cube;
        self.row(node.is_middle, y, z)[x as usize / 64] >> (x % 64) & 1 == 1
    }

    /// Cubes along each axis.
    pub(super) fn size(&self) -> UVec3 {
        self.size
    }
}
