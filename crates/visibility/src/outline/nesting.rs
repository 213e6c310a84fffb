//! Step 5: which region each hole lies in.
//!
//! A line sweeps over all rings from the left. Where it comes to a hole, what lies next below the hole bounds the same region
//! as the hole does: it is a ring around the region, or another of its holes (Shamos and Hoey, "Geometric intersection
//! problems", FOCS 1976, for the sweep). `i_overlay` assigns holes to regions as well, but sometimes wrongly where
//! rings touch.

use super::lattice::Point;
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// Sorts rings into regions: of each its outer ring, which runs counter-clockwise, then its holes, which run clockwise. Rings
/// may have points in common, but must neither cross nor overlap. O(points log points).
pub fn regions(rings: Vec<Vec<Point>>) -> Vec<Vec<Vec<Point>>> {
    let beneath = rings_beneath_holes(&rings);
    let mut region_of: Vec<Option<usize>> = vec![None; rings.len()];
    let mut count = 0;
    for (ring, beneath) in beneath.iter().enumerate() {
        if beneath.is_none() {
            region_of[ring] = Some(count);
            count += 1;
        }
    }
    let mut regions = vec![Vec::new(); count];
    for start in 0..rings.len() {
        // From hole to hole until one has a region, which is that of all on the way.
        let mut way = Vec::new();
        let mut at = start;
        let region = loop {
            match (region_of[at], beneath[at]) {
                (Some(region), _) => break region,
                (None, Some(next)) => {
                    way.push(at);
                    at = next;
                }
                (None, None) => unreachable!("such a ring has a region of its own"),
            }
        };
        way.into_iter().for_each(|ring| region_of[ring] = Some(region));
    }
    let (outer, holes): (Vec<_>, Vec<_>) =
        rings.into_iter().zip(&beneath).zip(&region_of).partition(|((_, beneath), _)| beneath.is_none());
    for ((ring, _), region) in outer.into_iter().chain(holes) {
        if let Some(region) = region {
            regions[*region].push(ring);
        }
    }
    regions
}

/// For each hole the ring next below its leftmost point.
fn rings_beneath_holes(rings: &[Vec<Point>]) -> Vec<Option<usize>> {
    let mut edges: Vec<Edge> = (0..).zip(rings).flat_map(|(ring, points)| edges_of(ring, points)).collect();
    edges.sort_unstable_by_key(|edge| edge.left);
    let mut ends = edges.clone();
    ends.sort_unstable_by_key(|edge| edge.right);
    let holes = (0..).zip(rings).filter(|(_, points)| !is_outer(points));
    let mut anchors: Vec<Edge> = holes.filter_map(|(ring, points)| lowest_at_the_left(ring, points)).collect();
    anchors.sort_unstable_by_key(|edge| edge.left[0]);

    let mut beneath = vec![None; rings.len()];
    let mut crossed: BTreeSet<Edge> = BTreeSet::new();
    let (mut begun, mut ended) = (0, 0);
    for anchor in anchors {
        let x = anchor.left[0];
        // What ends before the line goes before what begins on it comes, so that edges are only compared side by side.
        while begun < edges.len() && edges[begun].left[0] <= x {
            while ends[ended].right[0] <= edges[begun].left[0] {
                crossed.remove(&ends[ended]);
                ended += 1;
            }
            crossed.insert(edges[begun]);
            begun += 1;
        }
        while ended < ends.len() && ends[ended].right[0] <= x {
            crossed.remove(&ends[ended]);
            ended += 1;
        }
        beneath[anchor.ring] = crossed.range(..anchor).next_back().map(|below| below.ring);
    }
    beneath
}

/// Whether a ring runs counter-clockwise.
fn is_outer(points: &[Point]) -> bool {
    let Some(origin) = points.first() else { return true };
    let twice_area = |(one, other): (&Point, &Point)| orientation(*origin, *one, *other);
    points.iter().zip(&points[1..]).map(twice_area).sum::<i128>() > 0
}

/// An edge that is not vertical. Edges that a vertical line crosses are ordered from below.
#[derive(Debug, Clone, Copy)]
struct Edge {
    left: Point,
    right: Point,
    ring: usize,
}

fn edges_of(ring: usize, points: &[Point]) -> impl Iterator<Item = Edge> {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).filter(|(one, other)| one[0] != other[0]).map(move |(&one, &other)| Edge {
        left: one.min(other),
        right: one.max(other),
        ring,
    })
}

/// The lower of the edges at the leftmost point of a ring.
fn lowest_at_the_left(ring: usize, points: &[Point]) -> Option<Edge> {
    let left = *points.iter().min()?;
    edges_of(ring, points).filter(|edge| edge.left == left).min()
}

impl Ord for Edge {
    fn cmp(&self, other: &Self) -> Ordering {
        let below = |edge: &Self, point: Point| 0.cmp(&orientation(edge.left, edge.right, point));
        if self.left <= other.left {
            below(self, other.left).then_with(|| below(self, other.right))
        } else {
            below(other, self.left).then_with(|| below(other, self.right)).reverse()
        }
    }
}

impl PartialOrd for Edge {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Edge {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Edge {}

/// Twice the area of a triangle, above 0 where it runs counter-clockwise.
fn orientation(a: Point, b: Point, c: Point) -> i128 {
    let [u, v] = [b, c].map(|point| [0, 1].map(|axis| i128::from(point[axis] - a[axis])));
    u[0] * v[1] - u[1] * v[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rectangle([left, low]: Point, [right, high]: Point) -> Vec<Point> {
        vec![[left, low], [right, low], [right, high], [left, high]]
    }

    fn hole(low: Point, high: Point) -> Vec<Point> {
        rectangle(low, high).into_iter().rev().collect()
    }

    /// A square with two holes one above the other, in the upper of which lies a square with a hole; and one apart.
    #[test]
    fn holes_go_to_the_region_around_them() {
        let rings = vec![
            hole([20, 60], [80, 90]),
            rectangle([30, 65], [50, 85]),
            hole([35, 70], [45, 80]),
            rectangle([0, 0], [100, 100]),
            hole([10, 10], [90, 50]),
            rectangle([120, 0], [140, 20]),
        ];
        let found = regions(rings.clone());
        let expected = [vec![1, 2], vec![3, 0, 4], vec![5]].map(|region| {
            let of_region = region.into_iter().map(|ring: usize| rings[ring].clone());
            of_region.collect::<Vec<_>>()
        });
        assert_eq!(found, expected);
    }

    /// A triangle in a hole, with two of whose corners it touches the hole's border, and another hole above.
    #[test]
    fn rings_that_touch_are_kept_apart() {
        let outer = rectangle([0, 0], [100, 100]);
        let around: Vec<Point> = vec![[30, 20], [20, 40], [40, 60], [70, 50], [60, 30]];
        let island: Vec<Point> = vec![[30, 20], [40, 60], [25, 40]];
        let above = hole([35, 70], [45, 80]);
        let found = regions(vec![outer.clone(), around.clone(), island.clone(), above.clone()]);
        assert_eq!(found, [vec![outer, around, above], vec![island]]);
    }
}
