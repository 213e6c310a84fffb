//! The lattice that points of the outline are snapped to, and a grid of cells between its lines.

use silhouette_core::glam::DVec2;

/// Lattice lines per pixel: `2^36`, so that rounding is lost in that of projecting, and a picture of 16384 pixels with its
/// surroundings still fits the 62 bits that `i_overlay` computes with.
pub const LINES_PER_PIXEL: f64 = (1_u64 << 36) as f64;

/// A point of the lattice; y points up.
pub type Point = [i64; 2];

/// The lattice point of a pixel. Its coordinates are even.
pub fn snap(pixel: DVec2) -> Point {
    let even = |value: f64| (value * (LINES_PER_PIXEL * 0.5)).round() as i64 * 2;
    [even(pixel.x), even(-pixel.y)]
}

/// The pixel of a lattice point.
pub fn pixel([x, y]: Point) -> DVec2 {
    DVec2::new(x as f64, -(y as f64)) / LINES_PER_PIXEL
}

/// Square pixels as an area of the lattice.
pub fn area(square_pixels: f64) -> f64 {
    square_pixels * LINES_PER_PIXEL * LINES_PER_PIXEL
}

/// A directed edge between lattice points, with the scene on its left.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct DirectedEdge {
    /// Where it begins.
    pub from: Point,
    /// Where it ends.
    pub to: Point,
    /// How many layers more there are on its left.
    pub layers: u32,
}

/// A grid of cells over the lattice. Its lines have odd coordinates, so that no point that was [snapped](snap) lies on one.
#[derive(Debug, Clone, Copy)]
pub struct Cells {
    /// The lowest line of each axis.
    origin: Point,
    /// Distance of lines, even.
    step: i64,
    /// Number of cells along each axis.
    pub count: [usize; 2],
}

impl Cells {
    /// About `wanted` square cells around all points, at least one, none smaller than `least_side`.
    pub fn around<I: Iterator<Item = Point>>(points: &dyn Fn() -> I, wanted: usize, least_side: f64) -> Self {
        let bound = |fold: fn(i64, i64) -> i64, start: i64, axis: usize| {
            points().fold(start, |bound, point| fold(bound, point[axis]))
        };
        let low = [0, 1].map(|axis| bound(i64::min, i64::MAX, axis));
        let high = [0, 1].map(|axis| bound(i64::max, i64::MIN, axis));
        if low[0] > high[0] {
            return Self { origin: [-1; 2], step: 2, count: [1; 2] };
        }
        let size = [0, 1].map(|axis| (high[axis] - low[axis] + 2) as f64);
        let step = (size[0] * size[1] / wanted as f64).sqrt().max(size[0].max(size[1]) / wanted as f64);
        let step = step.max(least_side);
        let step = (step * 0.5).ceil().max(1.0) as i64 * 2;
        let count = [0, 1].map(|axis| ((high[axis] - low[axis] + 2) as u64).div_ceil(step as u64) as usize);
        Self { origin: low.map(|low| low - 1), step, count }
    }

    /// The coordinate of a line; line `i` lies before cell `i`.
    pub fn line(&self, axis: usize, index: usize) -> i64 {
        self.origin[axis] + self.step * index as i64
    }

    /// The cell that a point lies in.
    pub fn cell_of(&self, point: Point) -> [usize; 2] {
        [0, 1].map(|axis| ((point[axis] - self.origin[axis]) / self.step) as usize)
    }

    /// The cell that a point lies in or is next to.
    pub fn nearest(&self, point: Point) -> [usize; 2] {
        let clamped = |axis: usize| point[axis].clamp(self.line(axis, 0), self.line(axis, self.count[axis]) - 1);
        self.cell_of([clamped(0), clamped(1)])
    }

    /// A cell's place among all.
    pub fn index(&self, [column, row]: [usize; 2]) -> usize {
        row * self.count[0] + column
    }

    /// Number of all cells.
    pub fn len(&self) -> usize {
        self.count[0] * self.count[1]
    }

    /// Walks along an edge from cell to cell: calls with each cell and the points at which the edge enters and leaves it.
    /// Points between cells lie on the line between them and on no other line.
    pub fn walk(&self, from: Point, to: Point, mut visit: impl FnMut([usize; 2], Point, Point)) {
        let (mut cell, last) = (self.cell_of(from), self.cell_of(to));
        let along = [0, 1].map(|axis| (to[axis] - from[axis]) as f64);
        let mut enter = from;
        while cell != last {
            // The next line along each axis, and how much of the edge lies before it.
            let forward = [0, 1].map(|axis| last[axis] > cell[axis]);
            let line = [0, 1].map(|axis| self.line(axis, cell[axis] + usize::from(forward[axis])));
            let share = [0, 1].map(|axis| {
                if last[axis] == cell[axis] { f64::INFINITY } else { (line[axis] - from[axis]) as f64 / along[axis] }
            });
            let axis = usize::from(share[1] < share[0]);
            let other = 1 - axis;
            let place = from[other] as f64 + along[other] * share[axis];
            // Even, and inside of the cell, whatever rounding does.
            let [low, high] = [0, 1].map(|end| self.line(other, cell[other] + end));
            let mut leave = [0; 2];
            leave[axis] = line[axis];
            leave[other] = ((place * 0.5).round() as i64 * 2).clamp(low + 1, high - 1);
            visit(cell, enter, leave);
            cell[axis] = if forward[axis] { cell[axis] + 1 } else { cell[axis] - 1 };
            enter = leave;
        }
        visit(cell, enter, to);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_walk_leads_from_cell_to_cell_along_the_edge(
            ends in prop::array::uniform2(prop::array::uniform2(-500.0_f64..500.0)), wanted in 1_usize..300,
        ) {
            let [from, to] = ends.map(|[x, y]| snap(DVec2::new(x, y)));
            let cells = Cells::around(&|| [from, to].into_iter(), wanted, 0.0);
            let (mut at, mut visited) = (from, Vec::new());
            cells.walk(from, to, |cell, enter, leave| {
                assert_eq!(enter, at);
                at = leave;
                visited.push(cell);
                for point in [enter, leave] {
                    for axis in 0..2 {
                        let [low, high] = [0, 1].map(|end| cells.line(axis, cell[axis] + end));
                        assert!(point[axis] >= low && point[axis] <= high);
                    }
                }
            });
            prop_assert_eq!(at, to);
            let is_beside = |pair: &[[usize; 2]]| (0..2).map(|axis| pair[0][axis].abs_diff(pair[1][axis])).sum::<usize>() == 1;
            prop_assert!(visited.windows(2).all(is_beside));
            prop_assert!(cells.len() <= 4 * wanted + 4, "{} cells", cells.len());
        }
    }
}
