//! A set of edges that is filled in any order and emptied in ascending order, in linear time.
//!
//! Two levels of bits: one an edge, and one for each word of those. Emptying looks at the upper level, which is 4096 times
//! smaller than the set of all edges, and at the words that were touched; it leaves both levels zero for the next view.
//! Against sorting S ids this saves the factor log S, and duplicates cost nothing.

use silhouette_core::{EdgeId, SilhouetteEdges};

/// Bits of edges; all zero between calls.
#[derive(Debug, Clone, Default)]
pub(crate) struct EdgeMarks {
    words: Vec<u64>,
    touched: Vec<u64>,
}

impl EdgeMarks {
    /// The empty set, with room for the ids `0..edges`.
    pub(crate) fn new(edges: usize) -> Self {
        let words = edges.div_ceil(64);
        Self { words: vec![0; words], touched: vec![0; words.div_ceil(64)] }
    }

    /// Adds edges, in any order, duplicates allowed.
    pub(crate) fn insert(&mut self, edges: &[u32]) {
        for &edge in edges {
            let word = edge as usize / 64;
            self.words[word] |= 1 << (edge % 64);
            self.touched[word / 64] |= 1 << (word % 64);
        }
    }

    /// Moves the edges to `out`. O(S + E / 4096).
    pub(crate) fn drain_into(&mut self, out: &mut SilhouetteEdges) {
        out.refill_ascending(Drain { words: &mut self.words, groups: &mut self.touched, group: 0, word: 0, bits: 0 });
    }

    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self.words.as_slice()) + size_of_val(self.touched.as_slice())
    }
}

/// Takes the bits out in ascending order.
struct Drain<'a> {
    words: &'a mut [u64],
    groups: &'a mut [u64],
    group: usize,
    /// Which word `bits` are the rest of.
    word: usize,
    bits: u64,
}

impl Iterator for Drain<'_> {
    type Item = EdgeId;

    fn next(&mut self) -> Option<EdgeId> {
        while self.bits == 0 {
            let group = self.groups.get_mut(self.group)?;
            if *group == 0 {
                self.group += 1;
                continue;
            }
            self.word = 64 * self.group + group.trailing_zeros() as usize;
            *group &= *group - 1;
            self.bits = std::mem::take(&mut self.words[self.word]);
        }
        let bit = self.bits.trailing_zeros();
        self.bits &= self.bits - 1;
        Some(EdgeId::new(64 * self.word as u32 + bit))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    proptest! {
        #[test]
        fn empties_to_the_sorted_set(rounds in prop::collection::vec(prop::collection::vec(0_u32..20_000, 0..200), 1..4)) {
            let mut marks = EdgeMarks::new(20_000);
            let mut out = SilhouetteEdges::default();
            for edges in rounds {
                marks.insert(&edges);
                marks.drain_into(&mut out);
                let expected: BTreeSet<_> = edges.into_iter().map(EdgeId::new).collect();
                prop_assert!(out.iter().eq(expected));
            }
        }
    }
}
