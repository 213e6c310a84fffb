//! Seeded random numbers: the same in every run and on every machine.

use silhouette_core::glam::DVec3;
use std::ops::Range;

/// A generator of random numbers, `SplitMix64` (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators",
/// OOPSLA 2014).
#[derive(Debug, Clone)]
pub struct Random(u64);

impl Random {
    /// The generator of a seed. Seeds that differ by 1 give unrelated numbers.
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x2545_f491_4f6c_dd1d) ^ 0x9e37_79b9_7f4a_7c15)
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// A number from 0 to `bound - 1`.
    pub fn below(&mut self, bound: usize) -> usize {
        (self.bits() % bound as u64) as usize
    }

    /// True once in `times` on average.
    pub fn one_in(&mut self, times: usize) -> bool {
        self.below(times) == 0
    }

    /// A whole number of a range.
    pub fn whole(&mut self, range: Range<i32>) -> i32 {
        range.start + self.below((range.end - range.start) as usize) as i32
    }

    /// A point whose coordinates are whole numbers of a range.
    pub fn lattice_point(&mut self, range: Range<i32>) -> [i32; 3] {
        [range.clone(), range.clone(), range].map(|range| self.whole(range))
    }

    /// A number from 0 to below 1, a multiple of `2^-53`.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number from -1 to below 1.
    pub fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// A point in the cube from -1 to 1.
    pub fn vector(&mut self) -> DVec3 {
        DVec3::new(self.signed(), self.signed(), self.signed())
    }

    /// Puts items into a random order (Fisher and Yates).
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            items.swap(last, self.below(last + 1));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first numbers of the published generator, whose state begins at 0.
    #[test]
    fn numbers_are_those_of_the_published_generator() {
        let mut random = Random(0);
        let expected = [0xe220_a839_7b1d_cdaf, 0x6e78_9e6a_a1b9_65f4, 0x06c4_5d18_8009_454f];
        assert_eq!([0; 3].map(|_| random.bits()), expected);
    }

    #[test]
    fn numbers_fill_their_ranges_evenly() {
        let mut random = Random::new(3);
        let mut counts = [0_u32; 8];
        let (mut sum, mut least, mut most) = (0.0, 1.0_f64, -1.0_f64);
        for _ in 0..8000 {
            counts[random.below(8)] += 1;
            assert!((-3..5).contains(&random.whole(-3..5)));
            let signed = random.signed();
            (sum, least, most) = (sum + signed, least.min(signed), most.max(signed));
        }
        // Five standard deviations of a count are 150, of the mean 0.033.
        assert!(counts.iter().all(|count| (850..1150).contains(count)), "{counts:?}");
        assert!(f64::abs(sum) / 8000.0 < 0.033 && least < -0.99 && most > 0.99, "{sum} {least} {most}");
    }

    #[test]
    fn shuffling_keeps_every_item() {
        let mut items: Vec<u32> = (0..50).collect();
        Random::new(1).shuffle(&mut items);
        assert!(!items.is_sorted());
        items.sort_unstable();
        assert!(items.into_iter().eq(0..50));
    }
}
