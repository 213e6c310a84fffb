//! [`MeshHierarchy`]: a hierarchy over the faces of a mesh, in which `distance.rs`, `segment.rs` and `triangle.rs` search.

use crate::hierarchy::{Boxed, build_with_progress};
use obvhs::aabb::Aabb;
use obvhs::bvh2::{Bvh2, node::Bvh2Node};
use silhouette_core::glam::Vec3;
use silhouette_core::{Cancelled, FaceId, NoProgress, Progress, TriangleMesh};
use std::ops::Range;

/// A hierarchy of boxes over the faces of a mesh, with copies of their corners.
///
/// Boxes are those of the 32-bit corners, to the last bit. 60 bytes per face and 48 per node, of which there are up to 2 per
/// face.
pub struct MeshHierarchy {
    pub(crate) bvh: Bvh2,
    /// In the order of leaves.
    pub(crate) faces: Vec<FaceId>,
    pub(crate) corners: Vec<[Vec3; 3]>,
}

impl MeshHierarchy {
    /// The hierarchy of a mesh. Expected O(F log F), parallel.
    #[expect(clippy::missing_panics_doc, reason = "nobody cancels")]
    pub fn new(mesh: &TriangleMesh) -> Self {
        Self::with_progress(mesh, &NoProgress).expect("nobody cancels")
    }

    /// Like [`new`](Self::new), but stops between its steps when `progress` asks to.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn with_progress(mesh: &TriangleMesh, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let boxed = |triangle: &[u32; 3]| {
            let [a, b, c] = triangle.map(|vertex| mesh.positions()[vertex as usize]);
            Boxed(Aabb::new(a.min(b).min(c).into(), a.max(b).max(c).into()))
        };
        let bvh = build_with_progress(&mesh.triangles().iter().map(boxed).collect::<Vec<_>>(), progress)?;
        let faces: Vec<FaceId> = bvh.primitive_indices.iter().map(|&index| FaceId::new(index)).collect();
        let corners = faces.iter().map(|&face| mesh.corners(face)).collect();
        Ok(Self { bvh, faces, corners })
    }

    /// Visits the places of the faces in leaves whose boxes, and those of all nodes above them, may meet something, until `visit` yields
    /// `true`.
    pub(crate) fn walk(&self, may_meet: impl Fn(&Aabb) -> bool, mut visit: impl FnMut(usize) -> bool) {
        let mut waiting = Vec::with_capacity(64);
        waiting.extend((!self.bvh.nodes.is_empty()).then_some(0_u32));
        while let Some(index) = waiting.pop() {
            let node = &self.bvh.nodes[index as usize];
            if !may_meet(&node.aabb) {
                continue;
            }
            if let Some(mut places) = Self::places(node) {
                if places.any(&mut visit) {
                    return;
                }
            } else {
                waiting.extend([node.first_index, node.first_index + 1]);
            }
        }
    }

    /// Where a leaf's faces lie; `None` for an inner node, whose children are `first_index` and the next.
    pub(crate) fn places(node: &Bvh2Node) -> Option<Range<usize>> {
        (node.prim_count > 0).then(|| node.first_index as usize..(node.first_index + node.prim_count) as usize)
    }
}
