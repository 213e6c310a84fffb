//! Loops from edges without a facing of every face: only the fans around silhouette vertices are looked at.

use silhouette_core::glam::Vec3;
use silhouette_core::loops::LoopWalker;
use silhouette_core::method::ExtractionStats;
use silhouette_core::{FaceId, FacingMemo, SilhouetteEdges, SilhouetteLoops, Topology, Viewpoint};

/// Memory for the loops of one method; empty until loops are asked for.
#[derive(Debug, Clone, Default)]
pub(crate) struct LoopScratch {
    pub(crate) edges: SilhouetteEdges,
    memo: FacingMemo,
    walker: LoopWalker,
}

impl LoopScratch {
    /// Replaces `out` by the loops that `self.edges`, all silhouette edges of this view, form. O(S + faces in the fans
    /// around silhouette vertices), no allocation once memory has grown.
    pub(crate) fn walk(
        &mut self,
        topology: &Topology,
        corners: impl Fn(FaceId) -> [Vec3; 3],
        viewpoint: &Viewpoint,
        stats: &mut ExtractionStats,
        out: &mut SilhouetteLoops,
    ) {
        let Self { edges, memo, walker } = self;
        memo.begin_view(topology.half_edge_count() / 3);
        walker.walk_complete(topology, |face| memo.is_front(face, &corners, viewpoint, stats), edges, out);
    }

    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self.edges.as_slice()) + self.memo.bytes() + self.walker.bytes()
    }
}
