//! [`Candidate`]: what a search by place yields, to be tested exactly.

use silhouette_core::FaceId;

/// A face that may lie along a line.
#[derive(Debug, Clone, Copy)]
pub struct Candidate {
    /// The face.
    pub face: FaceId,
    /// Its vertices.
    pub vertices: [u32; 3],
    /// Whether it may hold the segment's ends.
    pub may_hold: [bool; 2],
}
