//! Step 4: slivers as wide as rounding closed.
//!
//! A face that is seen edge-on, or two that lie on each other, are projected to a sliver as wide as rounding. The union keeps it
//! where it stands out of everything else as a spike, or bridges a hole and parts it in two. Its sides run along each other in
//! opposite directions: once both have the same corners, they cancel.

use super::chain::without_repeats;
use super::cycles::cycles;
use super::lattice::{Cells, DirectedEdge, LINES_PER_PIXEL, Point};
use super::union::union;
use silhouette_core::DisjointSets;

/// How wide a sliver may be: what the union takes for one place.
const MOST_WIDTH: f64 = LINES_PER_PIXEL / (1 << 20) as f64;

/// Rings that enclose the same without slivers. Rings without any are left as they are. O(points log points) where sides are
/// about as long as others.
pub fn sealed(rings: Vec<Vec<Point>>) -> Vec<Vec<Point>> {
    let corners = Corners::new(&rings);
    let mut edges: Vec<DirectedEdge> = Vec::new();
    for ring in &rings {
        for (at, &from) in ring.iter().enumerate() {
            corners.push_side([from, ring[(at + 1) % ring.len()]], &mut edges);
        }
    }
    let count = edges.len();
    let kept = without_repeats(edges);
    if kept.len() == count { rings } else { union(&cycles(kept)) }
}

/// The corners of all rings, by place.
struct Corners {
    /// Ascending.
    points: Vec<Point>,
    /// Of those closer together than a sliver is wide, the first: one for each corner.
    first: Vec<Point>,
    cells: Cells,
    /// Corners, by their index, in or next to each cell that has some, ascending by cell.
    by_cell: Vec<(usize, u32)>,
}

impl Corners {
    fn new(rings: &[Vec<Point>]) -> Self {
        let mut points: Vec<Point> = rings.iter().flatten().copied().collect();
        points.sort_unstable();
        points.dedup();
        let cells = Cells::around(&|| points.iter().copied(), points.len().max(1), 4.0 * MOST_WIDTH);
        let mut by_cell: Vec<(usize, u32)> = Vec::with_capacity(points.len());
        for (index, point) in (0..).zip(&points) {
            let reach = MOST_WIDTH as i64 + 2;
            let corner = |[x, y]: [i64; 2]| cells.index(cells.nearest([point[0] + x * reach, point[1] + y * reach]));
            let mut around = [[-1, -1], [1, -1], [-1, 1], [1, 1]].map(corner);
            around.sort_unstable();
            let mut last = None;
            by_cell
                .extend(around.into_iter().filter(|cell| last.replace(*cell) != Some(*cell)).map(|cell| (cell, index)));
        }
        by_cell.sort_unstable();
        let mut sets = DisjointSets::new(points.len());
        for same in by_cell.chunk_by(|one, other| one.0 == other.0) {
            for (at, &(_, one)) in same.iter().enumerate() {
                let is_near =
                    |other: &&(usize, u32)| distance(points[one as usize], points[other.1 as usize]) <= MOST_WIDTH;
                // Ascending along x.
                let reach = |other: &&(usize, u32)| {
                    (points[other.1 as usize][0] - points[one as usize][0]) as f64 <= MOST_WIDTH
                };
                same[at + 1..].iter().take_while(reach).filter(is_near).for_each(|other| {
                    sets.unite(one, other.1);
                });
            }
        }
        let first = (0..points.len() as u32).map(|index| points[sets.find(index) as usize]).collect();
        Self { points, first, cells, by_cell }
    }

    fn first_of(&self, point: Point) -> Point {
        self.points.binary_search(&point).map_or(point, |index| self.first[index])
    }

    /// Appends a side, divided at the corners that lie on it.
    fn push_side(&self, [from, to]: [Point; 2], edges: &mut Vec<DirectedEdge>) {
        let mut on_it: Vec<(f64, Point)> = Vec::new();
        let length = distance(from, to);
        let along = [0, 1].map(|axis| (to[axis] - from[axis]) as f64 / length);
        self.cells.walk(from, to, |cell, _, _| {
            let cell = self.cells.index(cell);
            let begin = self.by_cell.partition_point(|(of, _)| *of < cell);
            for &(_, corner) in self.by_cell[begin..].iter().take_while(|(of, _)| *of == cell) {
                let point = self.points[corner as usize];
                let away = [0, 1].map(|axis| (point[axis] - from[axis]) as f64);
                let (share, beside) =
                    (away[0] * along[0] + away[1] * along[1], along[0] * away[1] - along[1] * away[0]);
                if beside.abs() <= MOST_WIDTH && share > MOST_WIDTH && share < length - MOST_WIDTH {
                    on_it.push((share, self.first[corner as usize]));
                }
            }
        });
        on_it.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
        let mut before = self.first_of(from);
        for point in on_it.into_iter().map(|(_, point)| point).chain([self.first_of(to)]) {
            if point != before {
                edges.push(DirectedEdge { from: before, to: point, layers: 1 });
                before = point;
            }
        }
    }
}

fn distance(one: Point, other: Point) -> f64 {
    ((one[0] - other[0]) as f64).hypot((one[1] - other[1]) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: i64 = 1 << 36;

    fn ring(pixels: &[[i64; 2]]) -> Vec<Point> {
        pixels.iter().map(|[x, y]| [x * UNIT, y * UNIT]).collect()
    }

    fn areas(rings: &[Vec<Point>]) -> Vec<f64> {
        let pixel = |point: &Point| point.map(|c| c as f64 / UNIT as f64);
        let of_side = |(a, b): (&Point, &Point)| {
            let (a, b) = (pixel(a), pixel(b));
            (a[0] * b[1] - a[1] * b[0]) * 0.5
        };
        let mut areas: Vec<f64> =
            rings.iter().map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)).map(of_side).sum()).collect();
        areas.sort_by(f64::total_cmp);
        areas
    }

    #[test]
    fn a_spike_is_left_out_wherever_the_ring_begins() {
        // Out of the second corner, there and back in steps that differ, one of them off by rounding.
        let mut spiked = ring(&[[0, 0], [4, 0], [6, 1], [10, 3], [8, 2], [4, 0], [4, 4], [0, 4]]);
        spiked[4][1] += 100;
        spiked[5][0] += 10;
        for _ in 0..spiked.len() {
            spiked.rotate_left(1);
            let rings = sealed(vec![spiked.clone()]);
            assert_eq!((rings.len(), rings[0].len()), (1, 4), "{rings:?}");
            assert!((areas(&rings)[0] - 16.0).abs() < 1e-6);
        }
    }

    #[test]
    fn a_bridge_as_wide_as_rounding_parts_no_hole() {
        let outer = ring(&[[0, 0], [9, 0], [9, 9], [0, 9]]);
        let left = ring(&[[2, 2], [2, 6], [4, 5], [4, 3]]);
        let mut right = ring(&[[4, 3], [4, 5], [7, 5], [7, 3]]);
        right[0][0] += 300;
        let found = sealed(vec![outer.clone(), left, right]);
        assert_eq!(found.len(), 2, "{found:?}");
        assert!((areas(&found)[0] + 12.0).abs() < 1e-6, "{:?}", areas(&found));
        // One of a thousandth of a pixel does.
        let right: Vec<Point> =
            ring(&[[4, 3], [4, 5], [7, 5], [7, 3]]).iter().map(|[x, y]| [x + UNIT / 1000, *y]).collect();
        let apart = vec![outer, ring(&[[2, 2], [2, 6], [4, 5], [4, 3]]), right];
        assert_eq!(sealed(apart.clone()), apart);
    }

    #[test]
    fn narrow_corners_and_touching_rings_stay() {
        let mut needle = ring(&[[0, 0], [50, 0], [100, 0], [0, 0]]);
        needle[3][1] = UNIT / 1000;
        let touching = ring(&[[100, 0], [200, -10], [200, 10]]);
        let rings = vec![needle, touching];
        assert_eq!(sealed(rings.clone()), rings);
        assert_eq!(sealed(Vec::new()), Vec::<Vec<Point>>::new());
    }
}
