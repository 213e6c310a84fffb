//! Exact facings that are found one by one, each at most once a view.

use crate::facing::{Facing, Judgement, judge};
use crate::id::FaceId;
use crate::method::ExtractionStats;
use crate::view::Viewpoint;
use glam::Vec3;

/// Views after which a stamp's number comes again: seven bits, without 0, which no view has.
const EPOCHS: u8 = 127;

/// Remembers which faces were asked for in this view and which of them are front, in a byte a face.
///
/// A byte holds the number of the view that wrote it, so that forgetting costs nothing. The number comes again after 127
/// views; until then each byte has been zeroed once, a 126th of them in each view, so that no view is slower than others.
#[derive(Debug, Clone, Default)]
pub struct FacingMemo {
    stamps: Vec<u8>,
    epoch: u8,
    /// Where the zeroing of old stamps goes on.
    swept: usize,
}

impl FacingMemo {
    /// Forgets all facings. Zeroes F / 126 bytes; the first call, and one with another number of faces, F bytes.
    pub fn begin_view(&mut self, faces: usize) {
        if self.stamps.len() != faces {
            self.stamps.clear();
            self.stamps.resize(faces, 0);
            self.swept = 0;
        }
        self.epoch = self.epoch % EPOCHS + 1;
        let begin = if self.swept < faces { self.swept } else { 0 };
        self.swept = faces.min(begin + faces.div_ceil(usize::from(EPOCHS) - 1));
        self.stamps[begin..self.swept].fill(0);
    }

    /// Whether a face is front, from memory if it was asked for before in this view.
    ///
    /// # Panics
    /// If there is no such face.
    #[inline]
    pub fn is_front(
        &mut self,
        face: FaceId,
        corners: impl FnOnce(FaceId) -> [Vec3; 3],
        viewpoint: &Viewpoint,
        stats: &mut ExtractionStats,
    ) -> bool {
        self.is_front_by(face, |face| judge(corners(face), viewpoint), stats)
    }

    /// [`is_front`](Self::is_front) with another evaluation, which has to be exact as well.
    ///
    /// # Panics
    /// If there is no such face.
    #[inline]
    pub fn is_front_by(
        &mut self,
        face: FaceId,
        evaluate: impl FnOnce(FaceId) -> Judgement,
        stats: &mut ExtractionStats,
    ) -> bool {
        let stamp = &mut self.stamps[face.index()];
        if *stamp >> 1 != self.epoch {
            let judgement = evaluate(face);
            stats.faces_tested += 1;
            stats.exact_fallbacks += u64::from(judgement.exact_fallback);
            *stamp = self.epoch << 1 | u8::from(judgement.facing == Facing::Front);
        }
        *stamp & 1 == 1
    }

    /// Remembers whether a face is front that somebody found in this view; yields whether nothing was known of it.
    ///
    /// # Panics
    /// If there is no such face.
    #[inline]
    pub fn record(&mut self, face: FaceId, is_front: bool) -> bool {
        let stamp = &mut self.stamps[face.index()];
        let was_unknown = *stamp >> 1 != self.epoch;
        *stamp = self.epoch << 1 | u8::from(is_front);
        was_unknown
    }

    /// [`record`](Self::record) of four faces, bit `i` of `fronts` that of the `i`-th; yields of how many nothing was known. A
    /// face may be named twice, with the same facing.
    ///
    /// # Panics
    /// If there is no such face.
    #[inline]
    pub fn record_four(&mut self, faces: [FaceId; 4], fronts: u32) -> u64 {
        let mut unknown = 0;
        for (index, face) in faces.into_iter().enumerate() {
            unknown += u64::from(self.record(face, fronts >> index & 1 == 1));
        }
        unknown
    }

    /// Whether a face is front that was asked for, or [recorded](Self::record), in this view.
    ///
    /// # Panics
    /// If there is no such face. In builds with debug assertions also if nothing is known of it.
    #[inline]
    pub fn recall(&self, face: FaceId) -> bool {
        let stamp = self.stamps[face.index()];
        debug_assert_eq!(stamp >> 1, self.epoch, "face {face} is unknown in this view");
        stamp & 1 == 1
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        size_of_val(self.stamps.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A face that is asked for in some views only is evaluated in each of them, whatever number of views lies between.
    #[test]
    fn no_stamp_outlives_its_view() {
        for faces in [1_u32, 5, 126, 127, 1000] {
            let mut memo = FacingMemo::default();
            for view in 0..1000_u32 {
                memo.begin_view(faces as usize);
                for face in (0..faces).filter(|face| view % (1 + face % 256) == 0).map(FaceId::new) {
                    let facing = if (view + face.get()) % 3 == 0 { Facing::Front } else { Facing::Back };
                    let mut stats = ExtractionStats::default();
                    let judgement = Judgement { facing, exact_fallback: true };
                    for expected_tests in [1, 1] {
                        let is_front = memo.is_front_by(face, |_| judgement, &mut stats);
                        assert_eq!(is_front, facing == Facing::Front, "face {face} in view {view}");
                        assert_eq!((stats.faces_tested, stats.exact_fallbacks), (expected_tests, expected_tests));
                    }
                    assert_eq!(memo.recall(face), facing == Facing::Front);
                    assert!(!memo.record(face, facing == Facing::Front), "known by now");
                }
            }
        }
    }
}
