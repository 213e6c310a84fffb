//! [`DisjointSets`]: what belongs together, found pair by pair.

/// A partition of the numbers from 0 to n - 1, at first into sets of one. The lowest number of a set represents it, whatever the
/// order of the unions (union and find with halved paths). Amortised O(log n) per call.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct DisjointSets {
    leader: Vec<u32>,
}

impl DisjointSets {
    /// `count` sets of one. O(count).
    pub fn new(count: usize) -> Self {
        Self { leader: (0..count as u32).collect() }
    }

    /// Makes this `count` sets of one again; keeps the memory. O(count).
    pub fn reset(&mut self, count: usize) {
        self.leader.clear();
        self.leader.extend(0..count as u32);
    }

    /// The lowest number in the set of a number.
    ///
    /// # Panics
    /// If there is no such number.
    pub fn find(&mut self, mut number: u32) -> u32 {
        while self.leader[number as usize] != number {
            let above = self.leader[self.leader[number as usize] as usize];
            self.leader[number as usize] = above;
            number = above;
        }
        number
    }

    /// Joins the sets of two numbers.
    ///
    /// # Panics
    /// If there is no such number.
    pub fn unite(&mut self, a: u32, b: u32) {
        let (a, b) = (self.find(a), self.find(b));
        self.leader[a.max(b) as usize] = a.min(b);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lowest_number_represents_a_set_in_any_order_of_unions() {
        let pairs = [(7, 3), (5, 7), (2, 4), (4, 5)];
        let represented = |pairs: &mut dyn Iterator<Item = (u32, u32)>| {
            let mut sets = DisjointSets::new(9);
            pairs.for_each(|(a, b)| sets.unite(a, b));
            (0..9).map(|number| sets.find(number)).collect::<Vec<_>>()
        };
        let forwards = represented(&mut pairs.into_iter());
        assert_eq!(forwards, [0, 1, 2, 2, 2, 2, 6, 2, 8]);
        let mut sets = DisjointSets::new(2);
        sets.unite(0, 1);
        sets.reset(3);
        assert_eq!([0, 1, 2].map(|number| sets.find(number)), [0, 1, 2]);
        assert_eq!(represented(&mut pairs.into_iter().rev().map(|(a, b)| (b, a))), forwards);
    }
}
