//! Whether parts of one mesh touch elsewhere than in what they share. Exact.

use crate::hull::touching::{touches, touches_beyond_corner};
use silhouette_core::glam::Vec3;

/// Whether an edge touches a face of the same mesh elsewhere than in shared corners.
pub(super) fn meets(edge: [u32; 2], ends: [Vec3; 2], triangle: [u32; 3], corners: [Vec3; 3]) -> bool {
    let slot_of = |vertex: u32| triangle.iter().position(|&corner| corner == vertex);
    match edge.map(slot_of) {
        [Some(_), Some(_)] => false,
        [None, None] => touches(ends, corners),
        [slot, other] => {
            let (slot, end) = if let Some(slot) = slot { (slot, ends[1]) } else { (other.unwrap_or(0), ends[0]) };
            touches_beyond_corner(end, [0, 1, 2].map(|step| corners[(slot + step) % 3]))
        }
    }
}
