//! What a frame misses: edges, loops, length.

use silhouette_core::{HalfEdgeId, SilhouetteLoops};

/// A sum and the part of it that was missed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Share {
    missed: f64,
    all: f64,
}

impl Share {
    /// Adds something that was found or missed.
    pub fn add(&mut self, amount: f64, found: bool) {
        self.all += amount;
        if !found {
            self.missed += amount;
        }
    }

    /// Share missed in per cent, 0 (best) to 100; 0 where there was nothing to find.
    pub fn percent(&self) -> f64 {
        if self.all > 0.0 { 100.0 * self.missed / self.all } else { 0.0 }
    }
}

/// What was missed over some frames. Frames add up: one with a longer silhouette weighs more.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Missed {
    /// Of the silhouette's edges.
    pub edges: Share,
    /// Of its loops; one is missed if none of its edges was found.
    pub loops: Share,
    /// Of its length in object space, hidden parts included.
    pub length: Share,
}

impl Missed {
    /// Counts a frame: its true loops, what was found of them, and the length of each half-edge. O(S).
    pub fn count(
        &mut self,
        truth: &SilhouetteLoops,
        is_found: impl Fn(HalfEdgeId) -> bool,
        length: impl Fn(HalfEdgeId) -> f64,
    ) {
        for half_edges in truth.iter() {
            let mut any = false;
            for &half_edge in half_edges {
                let found = is_found(half_edge);
                any |= found;
                self.edges.add(1.0, found);
                self.length.add(length(half_edge), found);
            }
            self.loops.add(1.0, any);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Loops of 3, 1 and 4 half-edges; the length of each is its id plus one.
    fn missed(is_found: impl Fn(usize) -> bool) -> Vec<f64> {
        let mut truth = SilhouetteLoops::default();
        for half_edges in [0..3, 3..4, 4..8] {
            half_edges.for_each(|index| truth.push(HalfEdgeId::from_usize(index)));
            truth.end_loop();
        }
        let mut missed = Missed::default();
        missed.count(&truth, |half_edge| is_found(half_edge.index()), |half_edge| (half_edge.index() + 1) as f64);
        [missed.edges, missed.loops, missed.length].iter().map(Share::percent).collect()
    }

    #[test]
    fn finding_all_misses_nothing_and_finding_nothing_misses_all() {
        assert_eq!(missed(|_| true), [0.0; 3]);
        assert_eq!(missed(|_| false), [100.0; 3]);
    }

    /// The negative control: each measure moves when the answer gets worse, and by what is lost.
    #[test]
    fn every_measure_moves_with_what_is_lost() {
        assert_eq!(missed(|index| index != 7), [12.5, 0.0, 100.0 * 8.0 / 36.0], "a part of a loop");
        assert_eq!(missed(|index| index != 3), [12.5, 100.0 / 3.0, 100.0 * 4.0 / 36.0], "a loop of one");
        assert_eq!(missed(|index| index < 4), [50.0, 100.0 / 3.0, 100.0 * 26.0 / 36.0], "a long loop");
    }

    #[test]
    fn nothing_to_find_is_nothing_missed() {
        assert!(Share::default().percent() <= 0.0);
    }
}
