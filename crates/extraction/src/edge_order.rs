//! Edge ids in ascending order without duplicates, in linear time and in little memory.
//!
//! A radix sort of two passes: by the lower half of the bits that the mesh's ids have, then by the upper half. Duplicates,
//! which only non-manifold edges have, are then neighbours. At 12 bits a digit (15 million edges) the counters fill 32 KiB
//! and stay in the first-level cache; the work on an id does not depend on what the ids are, so that no branch is mispredicted.

use silhouette_core::{EdgeId, SilhouetteEdges};

/// Memory for the two passes. See the [module](self).
#[derive(Debug, Clone)]
pub(crate) struct EdgeOrder {
    /// Bits of a digit.
    bits: u32,
    /// How many ids have each lower digit, and then where the next of them goes.
    lower: Vec<u32>,
    /// Likewise for the upper digit.
    upper: Vec<u32>,
    /// Ids in the order of their lower digits.
    half_sorted: Vec<u32>,
    ascending: Vec<u32>,
}

impl EdgeOrder {
    /// Memory for ids below `edges`.
    pub(crate) fn new(edges: usize) -> Self {
        let bits = (usize::BITS - edges.saturating_sub(1).leading_zeros()).div_ceil(2);
        let counters = vec![0; 1 << bits];
        Self { bits, lower: counters.clone(), upper: counters, half_sorted: Vec::new(), ascending: Vec::new() }
    }

    /// Replaces `out` by all ids of `lists`. O(S + sqrt E), no allocation once memory has grown.
    pub(crate) fn sort<'a>(&mut self, lists: impl Iterator<Item = &'a [u32]> + Clone, out: &mut SilhouetteEdges) {
        let Self { bits, lower, upper, half_sorted, ascending } = self;
        let mask = (1_u32 << *bits) - 1;
        lower.fill(0);
        upper.fill(0);
        let mut count = 0;
        for &id in lists.clone().flatten() {
            lower[(id & mask) as usize] += 1;
            upper[(id >> *bits) as usize] += 1;
            count += 1;
        }
        starts_of(lower);
        starts_of(upper);
        if half_sorted.len() < count {
            half_sorted.resize(2 * count, 0);
            ascending.resize(2 * count, 0);
        }
        for &id in lists.flatten() {
            half_sorted[next_place(&mut lower[(id & mask) as usize])] = id;
        }
        for &id in &half_sorted[..count] {
            ascending[next_place(&mut upper[(id >> *bits) as usize])] = id;
        }
        let ascending = &ascending[..count];
        let repeats = ascending.windows(2).fold(false, |repeats, pair| repeats | (pair[0] == pair[1]));
        if repeats {
            let firsts = ascending.chunk_by(|a, b| a == b).map(|equal| EdgeId::new(equal[0]));
            out.refill_ascending(firsts);
        } else {
            out.refill_ascending(ascending.iter().map(|&id| EdgeId::new(id)));
        }
    }

    pub(crate) fn bytes(&self) -> usize {
        [&self.lower, &self.upper, &self.half_sorted, &self.ascending]
            .map(|words| size_of_val(words.as_slice()))
            .iter()
            .sum()
    }
}

/// Turns how many there are of each digit into where the first of them goes.
fn starts_of(counts: &mut [u32]) {
    let mut start = 0;
    for count in counts {
        start += std::mem::replace(count, start);
    }
}

#[inline(always)]
fn next_place(place: &mut u32) -> usize {
    *place += 1;
    *place as usize - 1
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
