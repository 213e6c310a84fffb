//! [`EndTree`]: which end of a path is nearest to a point, among those not yet taken.

use silhouette_core::glam::DVec2;

/// Ends in a leaf: few enough to look at one by one.
const LEAF: usize = 8;

/// A k-d tree over points, from which points can be taken. A grid would do for even drawings; the ends of silhouettes
/// lie in clusters, and late in a greedy search nearly all cells are empty.
///
/// The node at index `i` has its children at `2 i + 1` and `2 i + 2`; all leaves lie in the lowest level.
#[derive(Debug)]
pub(super) struct EndTree {
    points: Vec<DVec2>,
    nodes: Vec<Node>,
    /// Ids of points, leaf by leaf; those taken lie at each leaf's end.
    ids: Vec<u32>,
    /// The leaf that holds each point.
    leaf_of: Vec<u32>,
}

#[derive(Debug, Clone, Copy)]
struct Node {
    min: DVec2,
    max: DVec2,
    /// First of its ids.
    begin: u32,
    /// How many of its points are not taken.
    left: u32,
}

impl Node {
    /// Squared distance of a point from the node's box.
    fn distance_squared(&self, point: DVec2) -> f64 {
        point.distance_squared(point.clamp(self.min, self.max))
    }
}

/// A point and its squared distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Near {
    pub id: u32,
    pub distance_squared: f64,
}

impl EndTree {
    /// A tree over finite points. O(n log n).
    pub fn new(points: Vec<DVec2>) -> Self {
        let count = u32::try_from(points.len()).expect("a drawing has fewer than 2^32 ends");
        let mut tree = Self { nodes: Vec::new(), ids: (0..count).collect(), leaf_of: vec![0; points.len()], points };
        let leaves = tree.points.len().div_ceil(LEAF).next_power_of_two();
        let empty = Node { min: DVec2::INFINITY, max: DVec2::NEG_INFINITY, begin: 0, left: 0 };
        tree.nodes = vec![empty; 2 * leaves - 1];
        let mut ids = std::mem::take(&mut tree.ids);
        tree.build(0, 0, &mut ids);
        tree.ids = ids;
        tree
    }

    fn build(&mut self, node: usize, begin: usize, ids: &mut [u32]) {
        let points = || ids.iter().map(|&id| self.points[id as usize]);
        let (min, max) = (points().fold(DVec2::INFINITY, DVec2::min), points().fold(DVec2::NEG_INFINITY, DVec2::max));
        self.nodes[node] = Node { min, max, begin: begin as u32, left: ids.len() as u32 };
        if 2 * node + 2 >= self.nodes.len() {
            ids.iter().for_each(|&id| self.leaf_of[id as usize] = node as u32);
            return;
        }
        let axis = usize::from(max.y - min.y > max.x - min.x);
        let middle = ids.len() / 2;
        if middle < ids.len() {
            let points = &self.points;
            ids.select_nth_unstable_by(middle, |&a, &b| {
                points[a as usize][axis].total_cmp(&points[b as usize][axis]).then(a.cmp(&b))
            });
        }
        let (low, high) = ids.split_at_mut(middle);
        self.build(2 * node + 1, begin, low);
        self.build(2 * node + 2, begin + middle, high);
    }

    /// Takes a point out of all later searches. O(log n).
    pub fn take(&mut self, id: u32) {
        let mut node = self.leaf_of[id as usize] as usize;
        let leaf = self.nodes[node];
        let ids = &mut self.ids[leaf.begin as usize..(leaf.begin + leaf.left) as usize];
        let Some(place) = ids.iter().position(|&other| other == id) else { return };
        let last = ids.len() - 1;
        ids.swap(place, last);
        self.nodes[node].left -= 1;
        while node > 0 {
            node = (node - 1) / 2;
            self.nodes[node].left -= 1;
        }
    }

    /// Replaces `found` by the `count` nearest points that are not taken, nearest first; among equally near ones by
    /// the tree's order, which depends on the points alone.
    pub fn nearest(&self, point: DVec2, count: usize, found: &mut Vec<Near>) {
        found.clear();
        self.search(0, point, count, found);
    }

    fn search(&self, node: usize, point: DVec2, count: usize, found: &mut Vec<Near>) {
        let limit = if found.len() < count { f64::INFINITY } else { found[count - 1].distance_squared };
        let at = &self.nodes[node];
        if at.left == 0 || at.distance_squared(point) >= limit {
            return;
        }
        let child = 2 * node + 1;
        if child < self.nodes.len() {
            let second_is_nearer =
                self.nodes[child + 1].distance_squared(point) < self.nodes[child].distance_squared(point);
            let [near, far] = if second_is_nearer { [child + 1, child] } else { [child, child + 1] };
            self.search(near, point, count, found);
            self.search(far, point, count, found);
            return;
        }
        for &id in &self.ids[at.begin as usize..(at.begin + at.left) as usize] {
            let near = Near { id, distance_squared: self.points[id as usize].distance_squared(point) };
            let place = found.partition_point(|other| other.distance_squared <= near.distance_squared);
            if place < count {
                found.truncate(count - 1);
                found.insert(place, near);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// What is found is as near as what a search of all points finds, whatever has been taken before.
        #[test]
        fn nearest_is_nearest(
            points in prop::collection::vec((0..20_i32, 0..20_i32), 1..200),
            taken in prop::collection::vec(0..200_u32, 0..150),
            from in (-5..25_i32, -5..25_i32),
            count in 1..9_usize,
        ) {
            let vector = |(x, y): (i32, i32)| DVec2::new(f64::from(x), f64::from(y));
            let points: Vec<_> = points.into_iter().map(vector).collect();
            let mut tree = EndTree::new(points.clone());
            let mut left: Vec<_> = (0..points.len() as u32).collect();
            for id in taken.into_iter().filter(|&id| (id as usize) < points.len()) {
                tree.take(id);
                left.retain(|&other| other != id);
            }
            let distance = |id: u32| points[id as usize].distance_squared(vector(from));
            let mut expected: Vec<_> = left.iter().map(|&id| distance(id)).collect();
            expected.sort_by(f64::total_cmp);
            expected.truncate(count);
            let mut found = Vec::new();
            tree.nearest(vector(from), count, &mut found);
            prop_assert_eq!(found.iter().map(|near| near.distance_squared).collect::<Vec<_>>(), expected);
            prop_assert!(found.iter().all(|near| left.contains(&near.id) && distance(near.id).to_bits() == near.distance_squared.to_bits()));
        }
    }

    #[test]
    fn no_point_is_no_obstacle() {
        let mut found = vec![Near { id: 0, distance_squared: 0.0 }];
        EndTree::new(Vec::new()).nearest(DVec2::ZERO, 3, &mut found);
        assert!(found.is_empty());
    }
}
