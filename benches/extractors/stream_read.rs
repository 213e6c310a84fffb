//! A plain read of memory: what the bandwidth of a method is held against.

use rayon::prelude::*;

/// Words that a task reads: large beside the cost of a task, small beside the second-level cache.
const WORDS_PER_TASK: usize = 1 << 15;

/// Sums that run side by side, so that additions wait for memory and not for each other.
const LANES: usize = 32;

/// Memory to read.
pub struct StreamRead(Vec<u64>);

impl StreamRead {
    /// `bytes` bytes, rounded down to whole words. Written once, so that every page has memory of its own behind it.
    pub fn new(bytes: usize) -> Self {
        Self((0..(bytes / size_of::<u64>()) as u64).collect())
    }

    /// Bytes that a [`read`](Self::read) reads.
    pub fn bytes(&self) -> usize {
        size_of_val(self.0.as_slice())
    }

    /// Reads everything once, on all threads of the current pool; yields a sum that depends on all of it.
    pub fn read(&self) -> u64 {
        if rayon::current_num_threads() == 1 {
            return sum(&self.0);
        }
        self.0.par_chunks(WORDS_PER_TASK).map(sum).reduce(|| 0, u64::wrapping_add)
    }
}

fn sum(words: &[u64]) -> u64 {
    let mut sums = [0_u64; LANES];
    let blocks = words.chunks_exact(LANES);
    let rest = blocks.remainder().iter().copied().fold(0, u64::wrapping_add);
    for block in blocks {
        for (sum, word) in sums.iter_mut().zip(block) {
            *sum = sum.wrapping_add(*word);
        }
    }
    sums.into_iter().fold(rest, u64::wrapping_add)
}
