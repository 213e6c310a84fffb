//! Certificates: for each face, how far the eye may travel before its facing has to be looked at again.
//!
//! The signed distance of the eye from a face's plane changes by no more than the eye moves. So a face that is seen from
//! height `m` above its plane, or below it, keeps its facing while the eye travels less than `m`, whatever way it takes;
//! the length of its path is measured once per frame for all faces, and each face notes at what length it *expires*. A
//! face far from the silhouette is left alone for hundreds of frames; one near it is looked at ever more often as its
//! plane comes nearer. Over a path that moves by `t` a frame, F faces whose planes pass at evenly spread heights up to `h`
//! take about `F (t / h) ln(h / t)` looks a frame.
//!
//! Expiries are kept in a tree of least values (8 faces, then 64 of these blocks), so that a frame reads F / 512 numbers
//! and what lies below those that are due.
//!
//! # Rounding
//!
//! All sums are rounded towards an early end: the path up, expiries down.

use silhouette_core::FaceId;

/// Faces in a block: their expiries fill a cache line.
const BLOCK: usize = 8;

/// Blocks in a group.
const GROUP: usize = 64;

/// Until when the facing of each face is certain.
#[derive(Debug, Clone, Default)]
pub(crate) struct Certificates {
    /// Length of path at which each face expires.
    expiries: Vec<f64>,
    /// The least of each block, and the least of each group of blocks.
    blocks: Vec<f64>,
    groups: Vec<f64>,
    /// Scratch: blocks with a face that is due.
    due_blocks: Vec<u32>,
    /// Length of the path so far, or more.
    travelled: f64,
}

impl Certificates {
    /// Makes all of `faces` faces due. O(F).
    pub fn forget(&mut self, faces: usize) {
        for (values, count) in [
            (&mut self.expiries, faces),
            (&mut self.blocks, faces.div_ceil(BLOCK)),
            (&mut self.groups, faces.div_ceil(BLOCK * GROUP)),
        ] {
            values.clear();
            values.resize(count, f64::NEG_INFINITY);
        }
        self.travelled = 0.0;
    }

    /// Adds a step to the path.
    pub fn travel(&mut self, distance: f64) {
        if distance > 0.0 {
            self.travelled = (self.travelled + distance.next_up()).next_up();
        }
    }

    /// Replaces `due` by the faces that are due, ascending. O(F / 512 + 8 for each block and 64 for each group with a due
    /// face).
    pub fn collect_due(&mut self, due: &mut Vec<FaceId>) {
        let Self { expiries, blocks, groups, due_blocks, travelled } = self;
        let travelled = *travelled;
        due_blocks.clear();
        for (group, _) in groups.iter().enumerate().filter(|&(_, &expiry)| expiry <= travelled) {
            let first_block = group * GROUP;
            let blocks = &blocks[first_block..blocks.len().min(first_block + GROUP)];
            let is_due = blocks.iter().enumerate().filter(|&(_, &expiry)| expiry <= travelled);
            due_blocks.extend(is_due.map(|(block, _)| (first_block + block) as u32));
        }
        due.clear();
        // In a second pass, so that the misses of the cache, one a block, overlap.
        for &block in &*due_blocks {
            let first_face = block as usize * BLOCK;
            let expiries = &expiries[first_face..expiries.len().min(first_face + BLOCK)];
            let bit = |(face, &expiry): (usize, &f64)| u32::from(expiry <= travelled) << face;
            let mut bits = expiries.iter().enumerate().map(bit).fold(0, std::ops::BitOr::bitor);
            while bits != 0 {
                due.push(FaceId::from_usize(first_face + bits.trailing_zeros() as usize));
                bits &= bits - 1;
            }
        }
    }

    /// Gives new certificates to the faces that were due: each says how far the eye may travel from here. O(due faces and
    /// their blocks and groups).
    pub fn renew(&mut self, due: &[FaceId], heights: impl Iterator<Item = f64>) {
        if due.len() == self.expiries.len() {
            // No certificate of before is left: the path begins anew, so that one long step does not swallow short ones.
            self.travelled = 0.0;
        }
        for (face, height) in due.iter().zip(heights) {
            self.expiries[face.index()] = (self.travelled + height).next_down();
        }
        for faces in due.chunk_by(|a, b| a.index() / BLOCK == b.index() / BLOCK) {
            let block = faces[0].index() / BLOCK;
            let first_face = block * BLOCK;
            self.blocks[block] = least(&self.expiries[first_face..self.expiries.len().min(first_face + BLOCK)]);
        }
        for faces in due.chunk_by(|a, b| a.index() / (BLOCK * GROUP) == b.index() / (BLOCK * GROUP)) {
            let group = faces[0].index() / (BLOCK * GROUP);
            let first_block = group * GROUP;
            self.groups[group] = least(&self.blocks[first_block..self.blocks.len().min(first_block + GROUP)]);
        }
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        let values = [&self.expiries, &self.blocks, &self.groups].map(|values| size_of_val(values.as_slice()));
        values.iter().sum::<usize>() + size_of::<u32>() * self.due_blocks.capacity()
    }
}

fn least(values: &[f64]) -> f64 {
    // Eight at once, which the compiler turns into vectors: a minimum has to wait for the one before it.
    let (eights, rest) = values.as_chunks::<8>();
    let lower = |a: f64, b: f64| if b < a { b } else { a };
    let least =
        eights.iter().fold([f64::INFINITY; 8], |least, eight| std::array::from_fn(|i| lower(least[i], eight[i])));
    least.iter().chain(rest).fold(f64::INFINITY, |least, &value| lower(least, value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Faces as points on a line, seen from the side that the eye is on; certificates are heights, times a factor. Yields
    /// how many looks it took, and how many faces were misjudged.
    fn looks_and_misjudged(points: &[f64], steps: &[f64], factor: f64) -> [usize; 2] {
        let mut certificates = Certificates::default();
        certificates.forget(points.len());
        let (mut eye, mut looks, mut misjudged) = (0.3, 0, 0);
        let mut sides = vec![false; points.len()];
        let mut due = Vec::new();
        for step in std::iter::once(0.0).chain(steps.iter().copied()) {
            eye += step;
            certificates.travel(step.abs());
            certificates.collect_due(&mut due);
            assert!(due.is_sorted());
            looks += due.len();
            due.iter().for_each(|face| sides[face.index()] = eye > points[face.index()]);
            certificates.renew(&due, due.iter().map(|face| factor * (eye - points[face.index()]).abs()));
            misjudged += sides.iter().zip(points).filter(|&(&side, &point)| side != (eye > point)).count();
        }
        [looks, misjudged]
    }

    proptest! {
        #[test]
        fn whoever_is_passed_was_due(
            points in prop::collection::vec(-100.0_f64..100.0, 1..5000),
            steps in prop::collection::vec(-3.0_f64..3.0, 1..60),
        ) {
            prop_assert_eq!(looks_and_misjudged(&points, &steps, 1.0)[1], 0);
        }
    }

    /// A thousand evenly spaced planes, crossed in a thousand steps: naively a million looks.
    #[test]
    fn looks_grow_with_the_logarithm_of_the_step() {
        let points: Vec<f64> = (0..1000).map(f64::from).collect();
        let [looks, misjudged] = looks_and_misjudged(&points, &[1.0; 1000], 1.0);
        assert!((1000..30_000).contains(&looks) && misjudged == 0, "{looks} looks");
    }

    #[test]
    fn a_very_long_step_is_forgotten() {
        let mut certificates = Certificates::default();
        certificates.forget(100);
        let mut due = Vec::new();
        let mut look = |distance| {
            certificates.travel(distance);
            certificates.collect_due(&mut due);
            certificates.renew(&due, due.iter().map(|_| 1.0));
            due.len()
        };
        assert_eq!([0.0, 1e30, 0.1, 0.1, 1e30, 0.1].map(&mut look), [100, 100, 0, 0, 100, 0]);
    }

    /// The negative control: certificates that last too long let faces turn unseen.
    #[test]
    fn heights_that_are_too_great_are_noticed() {
        let points: Vec<f64> = (0..100).map(f64::from).collect();
        assert!(looks_and_misjudged(&points, &[0.31; 300], 1.2)[1] > 10);
    }
}
