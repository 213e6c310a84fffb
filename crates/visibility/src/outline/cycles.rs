//! Directed edges as closed walks.

use super::lattice::{DirectedEdge, Point};

/// Closed walks along directed edges of which as many end in each place as begin there: of each edge its ends and what is
/// noted of its beginning; a walk is what is noted along it. O(edges log edges).
pub fn walks<K: Copy + Ord, N: Copy>(mut edges: Vec<(K, K, N)>) -> Vec<Vec<N>> {
    edges.sort_by_key(|&(from, to, _)| (from, to));
    // The first edge from each edge's end, and how many from there have been walked.
    let first_from: Vec<usize> = edges.iter().map(|(_, to, _)| edges.partition_point(|(from, ..)| from < to)).collect();
    let mut walked = vec![0_u32; edges.len()];
    let mut walks = Vec::new();
    let mut group = 0;
    while group < edges.len() {
        let start = edges[group].0;
        let end = group + edges[group..].iter().take_while(|(from, ..)| *from == start).count();
        while group + (walked[group] as usize) < end {
            let mut walk = Vec::new();
            let mut at = group;
            loop {
                let edge = at + walked[at] as usize;
                // A chain that does not close, which rounding excludes, ends where it breaks off.
                if edge >= edges.len() || edges[edge].0 != edges[at].0 {
                    break;
                }
                walked[at] += 1;
                walk.push(edges[edge].2);
                if edges[edge].1 == start || first_from[edge] == edges.len() {
                    break;
                }
                at = first_from[edge];
            }
            walks.push(walk);
        }
        group = end;
    }
    walks
}

/// The chain as closed polygons, an edge of several layers in as many of them.
pub fn cycles(chain: Vec<DirectedEdge>) -> Vec<Vec<Point>> {
    let edges = chain.into_iter().flat_map(|edge| (0..edge.layers).map(move |_| (edge.from, edge.to, edge.from)));
    walks(edges.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_loops_through_one_place_are_walked_once_each() {
        let edges = vec![(0, 1, 'a'), (1, 2, 'b'), (2, 0, 'c'), (1, 3, 'd'), (3, 1, 'e'), (7, 8, 'x'), (8, 7, 'y')];
        let mut walks = walks(edges);
        walks.sort();
        let sum: usize = walks.iter().map(Vec::len).sum();
        assert_eq!(sum, 7);
        assert!(walks.contains(&vec!['x', 'y']));
        assert!(walks.iter().any(|walk| walk.starts_with(&['a', 'b', 'c'])), "{walks:?}");
    }
}
