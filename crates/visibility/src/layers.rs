//! [`Layers`]: how many surface layers lie somewhere.

use silhouette_core::Facing;

/// How many surface layers lie somewhere, or by how much that number changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub struct Layers {
    /// Front faces.
    pub front: i32,
    /// Back faces.
    pub back: i32,
}

impl Layers {
    /// No layer, or no change.
    pub const NONE: Self = Self { front: 0, back: 0 };

    /// Adds `times` times `other`.
    #[inline]
    pub fn add(&mut self, other: Self, times: i32) {
        self.front += other.front * times;
        self.back += other.back * times;
    }

    /// `times` times these.
    #[inline]
    pub fn times(self, times: i32) -> Self {
        Self { front: self.front * times, back: self.back * times }
    }

    /// How many solids or sheets there are at least: the larger of both numbers. A solid in front of something shows a
    /// front face and a back face, a wall seen from inside of its solid a back face, a sheet one of either.
    pub fn invisibility(self) -> u32 {
        self.front.max(self.back).max(0).unsigned_abs()
    }

    /// All layers together.
    pub fn total(self) -> i32 {
        self.front + self.back
    }

    /// One layer of a face.
    #[inline]
    pub fn of(facing: Facing) -> Self {
        match facing {
            Facing::Front => Self { front: 1, back: 0 },
            Facing::Back => Self { front: 0, back: 1 },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invisibility_counts_solids_walls_and_sheets() {
        for (front, back, expected) in [(0, 0, 0), (1, 1, 1), (0, 1, 1), (2, 1, 2), (1, 2, 2)] {
            assert_eq!(Layers { front, back }.invisibility(), expected);
        }
    }
}
