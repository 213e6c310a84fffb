//! Where the parts of edges in one cell have something on their left and nothing on their right.
//!
//! Two edges that coincide in space may have been rounded to the wrong sides of each other. The layer count between them is
//! then negative, and counts as 0.

use super::chain_map::{ChainMap, Part};
use super::lattice::{DirectedEdge, Point};
use silhouette_core::glam::DVec2;

/// Where a part is crossed by another one of its cell.
#[derive(Debug, Clone, Copy)]
struct Crossing {
    /// The part that is crossed, by its index in the cell.
    part: usize,
    /// How much of it lies before.
    share: f64,
    /// How many layers more there are beyond.
    change: i32,
    /// The place, the same for both parts.
    place: Point,
}

/// Crossings of one part that are closer together than this share of it may come in either order.
const LEAST_DISTANCE: f64 = 1e-9;

/// Memory that is reused from cell to cell.
#[derive(Default)]
pub struct Arrangement {
    segments: Vec<[DVec2; 2]>,
    crossings: Vec<Crossing>,
}

impl Arrangement {
    /// Appends the stretches of the parts in a cell that have nothing on their right alone, each with its part's index in the cell
    /// and in order along it. `None` where rounding leaves a doubt: where parts lie on each other, or three cross in one
    /// place; what was appended then is to be dropped. O(square of the parts).
    pub fn push_bare_stretches(
        &mut self,
        map: &ChainMap,
        cell: [usize; 2],
        parts: &[Part],
        out: &mut Vec<(usize, DirectedEdge)>,
    ) -> Option<()> {
        let corner = [0, 1].map(|axis| map.cells.line(axis, cell[axis]));
        let place = |point: Point| DVec2::new((point[0] - corner[0]) as f64, (point[1] - corner[1]) as f64);
        self.segments.clear();
        self.segments.extend(parts.iter().map(|part| part.ends.map(place)));
        self.cross(corner, parts)?;
        let is_inside = |point: Point| map.layers_on_right(cell, point).is_none();
        // A closed loop has three edges that begin and end inside.
        let may_have_loops =
            || parts.iter().filter(|part| part.ends.iter().all(|&end| is_inside(end))).nth(2).is_some();
        if self.crossings.is_empty() && map.least_on_sides(cell) > 0 && !may_have_loops() {
            // Each region that the parts bound reaches the sides, where something is.
            return Some(());
        }
        let mut rest = &self.crossings[..];
        for (index, part) in parts.iter().enumerate() {
            let (of_part, others) = rest.split_at(rest.iter().take_while(|crossing| crossing.part == index).count());
            rest = others;
            if of_part.windows(2).any(|pair| pair[1].share - pair[0].share < LEAST_DISTANCE) {
                return None;
            }
            let change: i32 = of_part.iter().map(|crossing| crossing.change).sum();
            let [at_begin, at_end] = part.ends.map(|end| map.layers_on_right(cell, end));
            let mut on_right = match at_begin.or_else(|| at_end.map(|layers| layers - change)) {
                Some(layers) => layers,
                None => self.layers_at_begin(index, map.corner(cell), of_part, parts)?,
            };
            let mut from = part.ends[0];
            let ends = of_part.iter().map(|crossing| (crossing.place, crossing.change)).chain([(part.ends[1], 0)]);
            for (to, change) in ends {
                if on_right <= 0 && on_right + part.layers > 0 {
                    out.push((index, DirectedEdge { from, to, layers: 1 }));
                }
                on_right += change;
                from = to;
            }
        }
        Some(())
    }

    /// Finds all crossings, those of each part in order along it.
    fn cross(&mut self, corner: Point, parts: &[Part]) -> Option<()> {
        self.crossings.clear();
        for (index, &[a, b]) in self.segments.iter().enumerate() {
            let (low, high) = (a.min(b), a.max(b));
            for (other, &[p, q]) in self.segments.iter().enumerate().skip(index + 1) {
                let is_apart = p.min(q).cmpgt(high).any() || p.max(q).cmplt(low).any();
                if is_apart || a == p || a == q || b == p || b == q {
                    continue;
                }
                let (of_p, of_q) = (side(a, b, p), side(a, b, q));
                if of_p.sign? == of_q.sign? {
                    continue;
                }
                let (of_a, of_b) = (side(p, q, a), side(p, q, b));
                if of_a.sign? == of_b.sign? {
                    continue;
                }
                let share = of_a.value / (of_a.value - of_b.value);
                let at = a.lerp(b, share);
                let even = |value: f64| (value * 0.5).round() as i64 * 2;
                // The corner's coordinates are odd.
                let place = [corner[0] + 1 + even(at.x - 1.0), corner[1] + 1 + even(at.y - 1.0)];
                // On the way to the left of the other there are more layers.
                let toward_left = |of_end: Side| if of_end.value > 0.0 { 1 } else { -1 };
                let change = parts[other].layers * toward_left(of_b);
                self.crossings.push(Crossing { part: index, share, change, place });
                let share = of_p.value / (of_p.value - of_q.value);
                let change = parts[index].layers * toward_left(of_q);
                self.crossings.push(Crossing { part: other, share, change, place });
            }
        }
        self.crossings.sort_unstable_by(|one, other| one.part.cmp(&other.part).then(one.share.total_cmp(&other.share)));
        Some(())
    }

    /// Layers to the right of a part where it begins, by counting what a straight line from the corner to the middle of its
    /// longest stretch crosses.
    fn layers_at_begin(&self, index: usize, layers: i32, crossings: &[Crossing], parts: &[Part]) -> Option<i32> {
        let ends = || std::iter::once(0.0).chain(crossings.iter().map(|crossing| crossing.share)).chain([1.0]);
        let stretches = ends().zip(ends().skip(1)).enumerate();
        let (stretch, (from, to)) =
            stretches.max_by(|(_, one), (_, other)| (one.1 - one.0).total_cmp(&(other.1 - other.0)))?;
        let [a, b] = self.segments[index];
        let middle = a.lerp(b, (from + to) * 0.5);
        let mut beside = layers;
        for (other, (&[p, q], crossed)) in self.segments.iter().zip(parts).enumerate() {
            // The line runs from the lowest corner.
            if other == index || p.min(q).cmpgt(middle).any() {
                continue;
            }
            let (of_corner, of_middle) = (side(p, q, DVec2::ZERO), side(p, q, middle));
            if of_corner.sign? == of_middle.sign? {
                continue;
            }
            if side(DVec2::ZERO, middle, p).sign? != side(DVec2::ZERO, middle, q).sign? {
                beside += crossed.layers * of_middle.sign?;
            }
        }
        if side(a, b, DVec2::ZERO).sign? > 0 {
            beside -= parts[index].layers;
        }
        Some(beside - crossings[..stretch].iter().map(|crossing| crossing.change).sum::<i32>())
    }
}

/// On which side of a line a point lies, by how much, and whether that is certain.
#[derive(Clone, Copy)]
struct Side {
    value: f64,
    sign: Option<i32>,
}

#[inline]
fn side(from: DVec2, to: DVec2, point: DVec2) -> Side {
    // Coordinates within a cell are exact, or rounded by `2^-52`; so are the products of their differences.
    const ROUNDING: f64 = 16.0 * f64::EPSILON;
    let (u, v) = (to - from, point - from);
    let (left, right) = (u.x * v.y, u.y * v.x);
    let (value, error) = (left - right, (left.abs() + right.abs()) * ROUNDING);
    let sign = i32::from(value > error) - i32::from(value < -error);
    Side { value, sign: (sign != 0).then_some(sign) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edge(from: Point, to: Point) -> DirectedEdge {
        DirectedEdge { from, to, layers: 1 }
    }

    /// The bare stretches of a chain that lies in one cell.
    fn bare(chain: &[DirectedEdge]) -> Option<Vec<(usize, Point, Point)>> {
        let map = ChainMap::in_one_cell(chain);
        let mut found = Vec::new();
        Arrangement::default().push_bare_stretches(&map, [0, 0], &map.parts, &mut found)?;
        Some(found.into_iter().map(|(index, edge)| (index, edge.from, edge.to)).collect())
    }

    #[test]
    fn of_two_squares_that_overlap_the_inner_stretches_are_left_out() {
        let rectangle = |[left, low]: Point, [right, high]: Point| {
            let corners = [[left, low], [right, low], [right, high], [left, high]];
            (0..4).map(move |at| edge(corners[at], corners[(at + 1) % 4]))
        };
        let chain: Vec<DirectedEdge> =
            rectangle([100, 110], [500, 540]).chain(rectangle([330, 300], [780, 720])).collect();
        let found = bare(&chain).unwrap();
        assert_eq!(found.len(), 8, "{found:?}");
        assert!(found.contains(&(1, [500, 110], [500, 300])) && found.contains(&(4, [500, 300], [780, 300])));
        assert!(!found.contains(&(4, [330, 300], [500, 300])));
    }

    #[test]
    fn parts_that_lie_on_each_other_or_cross_in_one_place_are_a_doubt() {
        assert_eq!(bare(&[edge([0, 100], [200, 100]), edge([100, 100], [300, 100])]), None);
        assert_eq!(bare(&[edge([0, 0], [200, 200]), edge([200, 0], [0, 200]), edge([100, 0], [100, 200])]), None);
    }
}
