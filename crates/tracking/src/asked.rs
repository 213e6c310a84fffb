//! [`Asked`]: one entry of the trail that walks along the silhouette leave.

use silhouette_core::FaceId;

/// A face that a walk asked about, times two, plus whether it was front.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Asked(u32);

impl Asked {
    pub fn new(face: FaceId, is_front: bool) -> Self {
        Self(face.get() << 1 | u32::from(is_front))
    }

    pub fn face(self) -> FaceId {
        FaceId::new(self.0 >> 1)
    }

    pub fn was_front(self) -> bool {
        self.0 & 1 == 1
    }
}
