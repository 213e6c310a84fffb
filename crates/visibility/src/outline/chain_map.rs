//! The chain over a grid: which part of which edge passes which cell, and how many layers there are along the sides of cells.

use super::lattice::{Cells, DirectedEdge, Point};

/// Cells per edge of the chain.
const CELLS_PER_EDGE: usize = 3;

/// Cells that an edge passes on average, at most: long edges get larger cells, so that the map stays linear.
const CELLS_PASSED: f64 = 64.0;

/// The part of an edge in one cell.
#[derive(Debug, Clone, Copy)]
pub struct Part {
    /// The cell.
    pub cell: u32,
    /// Where it begins and ends.
    pub ends: [Point; 2],
    /// How many layers more there are on its left.
    pub layers: i32,
}

/// Where an edge crosses a side of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct SideCrossing {
    /// How far along.
    at: i64,
    /// How many layers more there are beyond.
    change: i32,
    /// How many there are before.
    before: i32,
}

/// What crosses each of a set of sides, in order along it.
struct Sides {
    first: Vec<u32>,
    crossings: Vec<SideCrossing>,
}

impl Sides {
    fn new(sides: usize, found: &[(u32, SideCrossing)]) -> Self {
        let mut first = vec![0_u32; sides + 1];
        found.iter().for_each(|(side, _)| first[*side as usize + 1] += 1);
        for side in 0..sides {
            first[side + 1] += first[side];
        }
        let mut next = first.clone();
        let mut crossings = vec![SideCrossing { at: 0, change: 0, before: 0 }; found.len()];
        for &(side, crossing) in found {
            crossings[next[side as usize] as usize] = crossing;
            next[side as usize] += 1;
        }
        for ends in first.windows(2).filter(|ends| ends[1] - ends[0] > 1) {
            crossings[ends[0] as usize..ends[1] as usize].sort_unstable();
        }
        Self { first, crossings }
    }

    /// Notes how many layers there are before each crossing of a side, of which `layers` are at its beginning; yields how many
    /// there are at its end.
    fn count(&mut self, side: usize, mut layers: i32) -> i32 {
        for crossing in &mut self.crossings[self.first[side] as usize..self.first[side + 1] as usize] {
            crossing.before = layers;
            layers += crossing.change;
        }
        layers
    }

    fn of(&self, side: usize) -> &[SideCrossing] {
        &self.crossings[self.first[side] as usize..self.first[side + 1] as usize]
    }
}

/// The chain over a grid.
pub struct ChainMap {
    /// The grid.
    pub cells: Cells,
    /// Parts of edges, edge by edge and each from its beginning to its end.
    pub parts: Vec<Part>,
    /// Parts of edge `e` are `parts[first_part[e]..first_part[e + 1]]`.
    pub first_part: Vec<u32>,
    /// Sides along x, below each cell, and above the last row.
    along_x: Sides,
    /// Sides along y, left of each cell, and right of the last column.
    along_y: Sides,
    /// Layers at the corners of cells, row by row.
    corners: Vec<i32>,
}

impl ChainMap {
    /// Lays a chain over a grid. O(edges + cells that they pass).
    pub fn new(chain: &[DirectedEdge]) -> Self {
        Self::over(chain, (chain.len() * CELLS_PER_EDGE).max(1))
    }

    /// The same with a single cell.
    #[cfg(test)]
    pub fn in_one_cell(chain: &[DirectedEdge]) -> Self {
        Self::over(chain, 1)
    }

    fn over(chain: &[DirectedEdge], wanted: usize) -> Self {
        let length =
            |edge: &DirectedEdge| (0..2).map(|axis| edge.from[axis].abs_diff(edge.to[axis]) as f64).fold(0.0, f64::max);
        let least_side = chain.iter().map(length).sum::<f64>() / (chain.len().max(1) as f64 * CELLS_PASSED);
        let cells = Cells::around(&|| chain.iter().flat_map(|edge| [edge.from, edge.to]), wanted, least_side);
        let [columns, rows] = cells.count;
        let (mut parts, mut first_part) = (Vec::with_capacity(3 * chain.len()), vec![0]);
        let (mut along_x, mut along_y) = (Vec::with_capacity(2 * chain.len()), Vec::with_capacity(2 * chain.len()));
        for edge in chain {
            let (mut before, layers): (Option<[usize; 2]>, _) = (None, edge.layers as i32);
            cells.walk(edge.from, edge.to, |cell, enter, leave| {
                match before.replace(cell) {
                    // Going along x, what an edge that runs upwards has on its left is left.
                    Some([_, row]) if row != cell[1] => {
                        let side = row.max(cell[1]) * columns + cell[0];
                        let change = if cell[1] > row { -layers } else { layers };
                        along_x.push((side as u32, SideCrossing { at: enter[0], change, before: 0 }));
                    }
                    // Going up, what an edge that runs along x has on its left is entered.
                    Some([column, _]) => {
                        let side = cell[1] * (columns + 1) + column.max(cell[0]);
                        let change = if cell[0] > column { layers } else { -layers };
                        along_y.push((side as u32, SideCrossing { at: enter[1], change, before: 0 }));
                    }
                    None => {}
                }
                parts.push(Part { cell: cells.index(cell) as u32, ends: [enter, leave], layers });
            });
            first_part.push(parts.len() as u32);
        }
        let mut along_x = Sides::new(columns * (rows + 1), &along_x);
        let mut along_y = Sides::new((columns + 1) * rows, &along_y);
        let mut corners = Vec::with_capacity((columns + 1) * (rows + 1));
        for line in 0..=rows {
            let mut layers = 0;
            corners.push(layers);
            for column in 0..columns {
                layers = along_x.count(line * columns + column, layers);
                corners.push(layers);
            }
        }
        for (side, &layers) in corners[..(columns + 1) * rows].iter().enumerate() {
            along_y.count(side, layers);
        }
        Self { cells, parts, first_part, along_x, along_y, corners }
    }

    /// Layers where two lines of the grid cross.
    pub fn corner(&self, line: [usize; 2]) -> i32 {
        self.corners[line[1] * (self.cells.count[0] + 1) + line[0]]
    }

    /// Parts by cell: where those of each begin, and the parts.
    pub fn parts_by_cell(&self) -> (Vec<u32>, Vec<u32>) {
        let mut first = vec![0_u32; self.cells.len() + 1];
        self.parts.iter().for_each(|part| first[part.cell as usize + 1] += 1);
        for cell in 0..self.cells.len() {
            first[cell + 1] += first[cell];
        }
        let (mut next, mut order) = (first.clone(), vec![0; self.parts.len()]);
        for (index, part) in (0..).zip(&self.parts) {
            order[next[part.cell as usize] as usize] = index;
            next[part.cell as usize] += 1;
        }
        (first, order)
    }

    /// The least number of layers along the sides of a cell.
    pub fn least_on_sides(&self, [column, row]: [usize; 2]) -> i32 {
        let [x, y] = [self.cells.count[0], self.cells.count[0] + 1];
        let least = |start: [usize; 2], crossings: &[SideCrossing]| {
            let beyond = crossings.iter().map(|crossing| crossing.before + crossing.change);
            beyond.fold(self.corner(start), i32::min)
        };
        least([column, row], self.along_x.of(row * x + column))
            .min(least([column, row + 1], self.along_x.of((row + 1) * x + column)))
            .min(least([column, row], self.along_y.of(row * y + column)))
            .min(least([column + 1, row], self.along_y.of(row * y + column + 1)))
    }

    /// How many layers there are to the right of an edge where it crosses a side of a cell; `None` for a point inside of the
    /// cell, and where several edges cross the side in one place.
    pub fn layers_on_right(&self, [column, row]: [usize; 2], point: Point) -> Option<i32> {
        let (crossings, at) = if point[0] == self.cells.line(0, column) || point[0] == self.cells.line(0, column + 1) {
            let line = column + usize::from(point[0] != self.cells.line(0, column));
            (self.along_y.of(row * (self.cells.count[0] + 1) + line), point[1])
        } else if point[1] == self.cells.line(1, row) || point[1] == self.cells.line(1, row + 1) {
            let line = row + usize::from(point[1] != self.cells.line(1, row));
            (self.along_x.of(line * self.cells.count[0] + column), point[0])
        } else {
            return None;
        };
        let mut there = crossings.iter().filter(|crossing| crossing.at == at);
        // An edge has more layers on its left.
        let least = there.next().map(|crossing| crossing.before.min(crossing.before + crossing.change));
        if there.next().is_some() { None } else { least }
    }

    /// Appends the sides between resolved cells, in which no more than one layer is left, and others as edges with as many
    /// layers as there are more in the other cell.
    pub fn push_borders(&self, is_resolved: &[bool], out: &mut Vec<DirectedEdge>) {
        let [columns, rows] = self.cells.count;
        let resolved = |column: usize, row: usize| is_resolved[self.cells.index([column, row])];
        // On the outermost lines there is nothing on either side.
        for row in 0..rows {
            for column in 0..columns {
                if row > 0 && resolved(column, row) != resolved(column, row - 1) {
                    let line = self.cells.line(1, row);
                    let ends = [0, 1].map(|end| self.cells.line(0, column + end));
                    let crossings = self.along_x.of(row * columns + column);
                    // Along x, the upper cell is on the left.
                    let forward = resolved(column, row - 1);
                    push_side(ends, self.corner([column, row]), crossings, forward, |along| [along, line], out);
                }
                if column > 0 && resolved(column, row) != resolved(column - 1, row) {
                    let line = self.cells.line(0, column);
                    let ends = [0, 1].map(|end| self.cells.line(1, row + end));
                    let crossings = self.along_y.of(row * (columns + 1) + column);
                    // Going up, the left cell is on the left.
                    let forward = resolved(column, row);
                    push_side(ends, self.corner([column, row]), crossings, forward, |along| [line, along], out);
                }
            }
        }
    }
}

/// Appends the stretches of a side with more than one layer, or fewer than none, the cell with all of them being on the left
/// if it is walked `forward`.
fn push_side(
    [begin, end]: [i64; 2],
    mut layers: i32,
    crossings: &[SideCrossing],
    forward: bool,
    point: impl Fn(i64) -> Point,
    out: &mut Vec<DirectedEdge>,
) {
    let mut from = begin;
    let ends = crossings.iter().map(|crossing| (crossing.at, crossing.change)).chain([(end, 0)]);
    for (to, change) in ends {
        let more = layers - layers.clamp(0, 1);
        if more != 0 && from != to {
            let [from, to] = if forward == (more > 0) { [point(from), point(to)] } else { [point(to), point(from)] };
            out.push(DirectedEdge { from, to, layers: more.unsigned_abs() });
        }
        layers += change;
        from = to;
    }
}
