//! Edge ids in ascending order without duplicates, in linear time and in little memory.
//!
//! 1. The ids of a view are scattered into buckets of 65536 neighbouring ids (a counting sort by the upper bits).
//! 2. Each bucket marks bits, a bit an id, and sweeps those words that were touched, as a second level of bits says.
//!
//! The bits of one bucket are 8 KiB and stay in the first-level cache, which is why there are buckets at all: marking
//! straight into a bit for each of 15 million edges misses the cache twice an edge. Against sorting S ids this saves the
//! factor log S, and duplicates cost nothing.

use silhouette_core::{EdgeId, SilhouetteEdges};

const BUCKET_BITS: u32 = 16;
const WORDS: usize = 1 << (BUCKET_BITS - 6);

/// Memory for the two steps. See the [module](self).
#[derive(Debug, Clone)]
pub(crate) struct EdgeOrder {
    /// Where the next id of each bucket goes; one bucket more than there are.
    places: Vec<u32>,
    scattered: Vec<u32>,
    /// Bits of one bucket; zero between uses, like the level above.
    words: Box<[u64; WORDS]>,
    touched: [u64; WORDS / 64],
}

impl EdgeOrder {
    /// Memory for ids below `edges`.
    pub(crate) fn new(edges: usize) -> Self {
        Self {
            places: vec![0; (edges >> BUCKET_BITS) + 2],
            scattered: Vec::new(),
            words: Box::new([0; WORDS]),
            touched: [0; WORDS / 64],
        }
    }

    /// Replaces `out` by all ids of `lists`. O(S + E / 65536), no allocation once memory has grown.
    pub(crate) fn sort<'a>(&mut self, lists: impl Iterator<Item = &'a [u32]> + Clone, out: &mut SilhouetteEdges) {
        let count = self.scatter(lists);
        out.refill_ascending(Ascending { order: self, count, next: 0, bucket: 0, group: WORDS / 64, word: 0, bits: 0 });
    }

    /// Step 1. Yields the number of ids; `places` then holds where each bucket ends.
    fn scatter<'a>(&mut self, lists: impl Iterator<Item = &'a [u32]> + Clone) -> usize {
        self.places.fill(0);
        let mut count = 0;
        for list in lists.clone() {
            count += list.len();
            for &edge in list {
                self.places[(edge >> BUCKET_BITS) as usize + 1] += 1;
            }
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
        count
    }

    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self.places.as_slice()) + size_of_val(self.scattered.as_slice()) + size_of_val(&*self.words)
    }
}

/// Step 2, as an iterator.
struct Ascending<'a> {
    order: &'a mut EdgeOrder,
    count: usize,
    /// The first scattered id that is not marked yet.
    next: usize,
    /// The bucket whose bits are swept.
    bucket: u32,
    /// Where the sweep is: group of 64 words, word, and the bits that are left of it.
    group: usize,
    word: usize,
    bits: u64,
}

impl Ascending<'_> {
    /// Marks the ids of the next bucket that has any.
    fn mark(&mut self) -> Option<()> {
        let EdgeOrder { places, scattered, words, touched } = &mut *self.order;
        let rest = &scattered[self.next..self.count];
        self.bucket = rest.first()? >> BUCKET_BITS;
        // After the scatter a bucket's place is its end.
        let end = places[self.bucket as usize] as usize;
        for &edge in &rest[..end - self.next] {
            let word = (edge >> 6) as usize % WORDS;
            words[word] |= 1 << (edge % 64);
            touched[word / 64] |= 1 << (word % 64);
        }
        (self.next, self.group) = (end, 0);
        Some(())
    }
}

impl Iterator for Ascending<'_> {
    type Item = EdgeId;

    #[inline]
    fn next(&mut self) -> Option<EdgeId> {
        while self.bits == 0 {
            if self.group == WORDS / 64 {
                self.mark()?;
            }
            let touched = &mut self.order.touched[self.group];
            if *touched == 0 {
                self.group += 1;
                continue;
            }
            self.word = 64 * self.group + touched.trailing_zeros() as usize;
            *touched &= *touched - 1;
            self.bits = std::mem::take(&mut self.order.words[self.word]);
        }
        let bit = self.bits.trailing_zeros();
        self.bits &= self.bits - 1;
        Some(EdgeId::new((self.bucket << BUCKET_BITS) + 64 * self.word as u32 + bit))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (0, Some(self.count))
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
            rounds in prop::collection::vec(prop::collection::vec(0_u32..300_000, 0..400), 1..4), clustered in 1_u32..5000,
        ) {
            let mut order = EdgeOrder::new(300_000);
            let mut out = SilhouetteEdges::default();
            for mut edges in rounds {
                edges.iter_mut().step_by(2).for_each(|edge| *edge = 200_000 + *edge % clustered);
                let (some, others) = edges.split_at(edges.len() / 3);
                order.sort([some, others].into_iter(), &mut out);
                let expected: BTreeSet<_> = edges.into_iter().map(EdgeId::new).collect();
                prop_assert!(out.iter().eq(expected));
            }
        }
    }
}
