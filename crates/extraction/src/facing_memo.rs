//! Exact facings that are found one by one, each at most once a view.

use silhouette_core::facing::{Facing, judge};
use silhouette_core::glam::Vec3;
use silhouette_core::method::ExtractionStats;
use silhouette_core::{FaceId, Viewpoint};

/// A stamp a face: the view in which it was last asked for, and whether it is front there. Stamps make forgetting free.
#[derive(Debug, Clone, Default)]
pub(crate) struct FacingMemo {
    stamps: Vec<u32>,
    view: u32,
}

impl FacingMemo {
    /// Forgets all facings. O(1), but for the first call and once in two thousand million.
    pub(crate) fn begin_view(&mut self, faces: usize) {
        self.view += 1;
        if self.stamps.len() != faces || self.view > u32::MAX / 2 {
            self.stamps.clear();
            self.stamps.resize(faces, 0);
            self.view = 1;
        }
    }

    /// Whether a face is front, from memory if it was asked for before.
    pub(crate) fn is_front(
        &mut self,
        face: FaceId,
        corners: impl FnOnce(FaceId) -> [Vec3; 3],
        viewpoint: &Viewpoint,
        stats: &mut ExtractionStats,
    ) -> bool {
        let stamp = &mut self.stamps[face.index()];
        if *stamp >> 1 != self.view {
            let judgement = judge(corners(face), viewpoint);
            stats.faces_tested += 1;
            stats.exact_fallbacks += u64::from(judgement.exact_fallback);
            *stamp = self.view << 1 | u32::from(judgement.facing == Facing::Front);
        }
        *stamp & 1 == 1
    }

    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self.stamps.as_slice())
    }
}
