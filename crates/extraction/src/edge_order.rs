//! Edge ids in ascending order without duplicates, in linear time and in little memory.
//!
//! 1. The ids of a view are scattered into buckets of 262144 neighbouring ids (a counting sort by the upper bits).
//! 2. Each bucket marks bits, a bit an id, and sweeps those words that were touched, as a second level of bits says.
//!
//! The bits of one bucket are 32 KiB and stay in the first-level cache, which is why there are buckets at all: marking
//! straight into a bit for each of 15 million edges misses the cache twice an edge. Against sorting S ids this saves the
//! factor log S, and duplicates cost nothing. Small meshes have one bucket and skip step 1.

use silhouette_core::{EdgeId, SilhouetteEdges};

const BUCKET_BITS: u32 = 18;
const WORDS: usize = 1 << (BUCKET_BITS - 6);

/// Memory for the two steps. See the [module](self).
#[derive(Debug, Clone)]
pub(crate) struct EdgeOrder {
    /// Where the next id of each bucket goes; one more than there are buckets.
    places: Vec<u32>,
    scattered: Vec<u32>,
    /// Bits of one bucket; all zero between uses.
    bits: BucketBits,
    ascending: Vec<EdgeId>,
}

impl EdgeOrder {
    /// Memory for ids below `edges`.
    pub(crate) fn new(edges: usize) -> Self {
        Self {
            places: vec![0; (edges >> BUCKET_BITS) + 2],
            scattered: Vec::new(),
            bits: BucketBits { words: vec![0; WORDS.min(edges / 64 + 1)], touched: [0; WORDS / 64] },
            ascending: Vec::new(),
        }
    }

    /// Replaces `out` by all ids of `lists`. O(S + E / 262144), no allocation once memory has grown.
    pub(crate) fn sort<'a>(&mut self, lists: impl Iterator<Item = &'a [u32]> + Clone, out: &mut SilhouetteEdges) {
        let count: usize = lists.clone().map(<[u32]>::len).sum();
        if self.ascending.len() < count + SLACK {
            self.ascending.resize(2 * count + SLACK, EdgeId::new(0));
        }
        let mut found = 0;
        if self.places.len() == 2 {
            lists.for_each(|list| self.bits.mark(list));
            self.bits.sweep(0, &mut self.ascending, &mut found);
        } else {
            self.scatter(lists, count);
            let mut begin = 0;
            for (bucket, &end) in self.places.iter().enumerate() {
                if end > begin {
                    self.bits.mark(&self.scattered[begin as usize..end as usize]);
                    self.bits.sweep((bucket as u32) << BUCKET_BITS, &mut self.ascending, &mut found);
                    begin = end;
                }
            }
        }
        out.refill_ascending(self.ascending[..found].iter().copied());
    }

    /// Step 1. Afterwards `places` holds where each bucket ends.
    fn scatter<'a>(&mut self, lists: impl Iterator<Item = &'a [u32]> + Clone, count: usize) {
        self.places.fill(0);
        for &edge in lists.clone().flatten() {
            self.places[(edge >> BUCKET_BITS) as usize + 1] += 1;
        }
        for bucket in 1..self.places.len() {
            self.places[bucket] += self.places[bucket - 1];
        }
        if self.scattered.len() < count {
            self.scattered.resize(2 * count, 0);
        }
        for &edge in lists.flatten() {
            let place = &mut self.places[(edge >> BUCKET_BITS) as usize];
            self.scattered[*place as usize] = edge;
            *place += 1;
        }
    }

    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self.places.as_slice())
            + size_of_val(self.scattered.as_slice())
            + size_of_val(self.bits.words.as_slice())
            + size_of_val(self.ascending.as_slice())
    }
}

/// Ids that a sweep may write beyond those that count.
const SLACK: usize = 4;

/// A set of ids of one bucket.
#[derive(Debug, Clone)]
struct BucketBits {
    words: Vec<u64>,
    /// A bit for each word that is not zero.
    touched: [u64; WORDS / 64],
}

impl BucketBits {
    /// Adds ids, all of one bucket.
    fn mark(&mut self, edges: &[u32]) {
        for &edge in edges {
            let word = (edge >> 6) as usize % WORDS;
            self.words[word] |= 1 << (edge % 64);
            self.touched[word / 64] |= 1 << (word % 64);
        }
    }

    /// Writes the set, whose lowest possible id is `base`, to `out` from `found` on, and empties it.
    fn sweep(&mut self, base: u32, out: &mut [EdgeId], found: &mut usize) {
        let mut end = *found;
        for (group, touched) in self.touched.iter_mut().enumerate() {
            let mut group_bits = std::mem::take(touched);
            while group_bits != 0 {
                let word = 64 * group + group_bits.trailing_zeros() as usize;
                group_bits &= group_bits - 1;
                let mut bits = std::mem::take(&mut self.words[word]);
                let first = base + 64 * word as u32;
                // Ids in fours, as in the sweep of a patch: their number in a word is beyond prediction.
                let count = bits.count_ones() as usize;
                let mut place = end;
                while bits != 0 {
                    for id in &mut out[place..place + SLACK] {
                        *id = EdgeId::new(first + bits.trailing_zeros());
                        bits &= bits.wrapping_sub(1);
                    }
                    place += SLACK;
                }
                end += count;
            }
        }
        *found = end;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    proptest! {
        #[test]
        fn yields_the_sorted_set_every_time(
            size in prop::sample::select(vec![1_u32, 1000, 262_143, 262_144, 1_200_000]),
            rounds in prop::collection::vec(prop::collection::vec(any::<u32>(), 0..400), 1..4),
            clustered in 1_u32..900,
        ) {
            let mut order = EdgeOrder::new(size as usize);
            let mut out = SilhouetteEdges::default();
            for mut edges in rounds {
                edges.iter_mut().for_each(|edge| *edge %= size);
                edges.iter_mut().step_by(2).for_each(|edge| *edge = (size / 2 + *edge % clustered) % size);
                let (some, others) = edges.split_at(edges.len() / 3);
                order.sort([some, others].into_iter(), &mut out);
                let expected: BTreeSet<_> = edges.into_iter().map(EdgeId::new).collect();
                prop_assert!(out.iter().eq(expected));
            }
        }
    }
}
