//! [`EdgeRecord`]: what the edge mesh stores of an edge, in 16 bytes. Twin of the decoding: `shaders/edge_mesh/edge_record.wgsl`.
//!
//! The article's four vertices repeat the position of each end twice and either normal four times. A stage that fetches by index
//! needs only the ends and the faces; facing and normals are stored once per face.

use silhouette_core::{FaceId, VertexId};

/// Faces and vertices of a mesh that records can number: 2^29, over 500 million.
pub const MOST_ELEMENTS: usize = 1 << 29;

/// Bits of a face word that hold the face's number.
const FACE_MASK: u32 = MOST_ELEMENTS as u32 - 1;
/// In the word of the first face: a ridge or a valley, at rest.
const RIDGE: u32 = 1 << 29;
const VALLEY: u32 = 1 << 30;
/// In the word of the first face: drawn as a ridge or valley whatever its angle.
const GIVEN: u32 = 1 << 31;
/// In the word of the second face: both faces run along the edge the same way.
const SAME_WAY: u32 = 1 << 30;
/// In the word of the second face: there is no second face; its number is that of the first.
const BOUNDARY: u32 = 1 << 31;

/// Which way the surface bends at a feature.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bend {
    /// Convex.
    Ridge,
    /// Concave.
    Valley,
}

/// A feature: an edge that is drawn whether it is a silhouette edge or not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Feature {
    /// Which pen draws it.
    pub bend: Bend,
    /// Whether the mesh's file marks it as sharp, so that it stays one when the mesh moves.
    pub is_given: bool,
}

/// What is drawn of back faces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OfBackFaces {
    /// Boundary edges.
    pub boundaries: bool,
    /// Features between two of them, which a closed mesh seen from outside hides.
    pub features: bool,
}

/// An edge between two faces, or a boundary edge. An edge with k faces, 3 or more, has k - 1 records, one for each two faces that
/// follow each other in the topology's list: if not all of them face the same way, some two neighbours do not either.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "gpu", derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct EdgeRecord {
    faces: [u32; 2],
    ends: [u32; 2],
}

impl EdgeRecord {
    /// An edge between `first`, which runs along it from the first end to the second, and `second`, which runs the other way or
    /// the `same_way`. Numbers are below [`MOST_ELEMENTS`].
    pub(crate) fn between(ends: [u32; 2], first: FaceId, second: FaceId, same_way: bool) -> Self {
        let second = second.get() | if same_way { SAME_WAY } else { 0 };
        Self { faces: [first.get(), second], ends }
    }

    /// A boundary edge of a face that runs along it from the first end to the second.
    pub(crate) fn boundary(ends: [u32; 2], face: FaceId) -> Self {
        Self { faces: [face.get(), face.get() | BOUNDARY], ends }
    }

    /// The same edge as a feature.
    pub(crate) fn with_feature(mut self, feature: Option<Feature>) -> Self {
        if let Some(Feature { bend, is_given }) = feature {
            self.faces[0] |= if bend == Bend::Ridge { RIDGE } else { VALLEY } | if is_given { GIVEN } else { 0 };
        }
        self
    }

    /// The vertices at its ends, as the first face runs along it.
    pub fn ends(&self) -> [VertexId; 2] {
        self.ends.map(VertexId::new)
    }

    /// The first face.
    pub fn first_face(&self) -> FaceId {
        FaceId::new(self.faces[0] & FACE_MASK)
    }

    /// The second face; `None` for a boundary edge.
    pub fn second_face(&self) -> Option<FaceId> {
        (self.faces[1] & BOUNDARY == 0).then(|| FaceId::new(self.faces[1] & FACE_MASK))
    }

    /// Whether both faces run along the edge the same way: they are wound inconsistently.
    pub fn is_same_way(&self) -> bool {
        self.faces[1] & SAME_WAY != 0
    }

    /// What it is drawn as where it is not a silhouette edge, at rest.
    pub fn feature(&self) -> Option<Feature> {
        let is_given = self.faces[0] & GIVEN != 0;
        if self.faces[0] & RIDGE != 0 {
            Some(Feature { bend: Bend::Ridge, is_given })
        } else if self.faces[0] & VALLEY != 0 {
            Some(Feature { bend: Bend::Valley, is_given })
        } else {
            None
        }
    }

    /// Whether it is drawn as a silhouette: its faces face different ways, or there is only one, which is front, or
    /// `draws_back_boundaries`.
    pub fn is_silhouette(&self, is_front: impl Fn(FaceId) -> bool, draws_back_boundaries: bool) -> bool {
        let is_first_front = is_front(self.first_face());
        match self.second_face() {
            Some(second) => is_front(second) != is_first_front,
            None => is_first_front || draws_back_boundaries,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_bit_is_read_back() {
        let highest = MOST_ELEMENTS as u32 - 1;
        for (first, second) in [(0, 1), (highest, 0), (5, highest), (highest - 1, highest)] {
            for same_way in [false, true] {
                for bend in [Bend::Ridge, Bend::Valley] {
                    for is_given in [false, true] {
                        let [a, b] = [first, second].map(FaceId::new);
                        let plain = EdgeRecord::between([first, second], a, b, same_way);
                        assert_eq!(plain.feature(), None);
                        let feature = Some(Feature { bend, is_given });
                        let record = plain.with_feature(feature);
                        assert_eq!((record.first_face(), record.second_face()), (a, Some(b)));
                        assert_eq!((record.is_same_way(), record.feature()), (same_way, feature));
                        assert_eq!(record.ends(), [first, second].map(VertexId::new));
                    }
                }
            }
            let boundary = EdgeRecord::boundary([1, 2], FaceId::new(first));
            assert_eq!((boundary.first_face().get(), boundary.second_face()), (first, None));
        }
        assert_eq!(size_of::<EdgeRecord>(), 16);
    }

    #[test]
    fn silhouettes_differ_in_facing_and_boundaries_are_front_or_all() {
        let record = EdgeRecord::between([0, 1], FaceId::new(3), FaceId::new(4), false);
        let boundary = EdgeRecord::boundary([0, 1], FaceId::new(3));
        for all in [false, true] {
            assert!([3, 4].iter().all(|&front| record.is_silhouette(|face| face.get() == front, all)));
            assert!(!record.is_silhouette(|_| true, all) && !record.is_silhouette(|_| false, all));
            assert!(boundary.is_silhouette(|_| true, all));
            assert_eq!(boundary.is_silhouette(|_| false, all), all);
        }
    }
}
