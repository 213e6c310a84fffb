//! Single edge testing (Hall 2003): one edge of each old loop, more where it leads to nothing new.
//!
//! Preferred is an edge whose visible side is still visible: from inside the silhouette no walk can stray onto another
//! one. Where there is none, because the silhouette has shrunk or moved everywhere, its other edges are tested.
//!
//! An edge that leads to a loop which was found before, from another parent, yields nothing: the next edges of the loop
//! are tested until one yields a loop that is new, or none is left. A loop in rest costs one test, one that merged with
//! another as many as it has edges.

use crate::as_printed::WalkStart;
use crate::complete_silhouette::FoundLoops;
use crate::faces::Faces;
use crate::stats::TrackingStats;
use crate::track::{check_walks, follow};
use silhouette_core::HalfEdgeId;
use std::ops::ControlFlow;

/// Tests as few edges of each old loop as lead to a new one.
pub(crate) fn track_single_edges(
    faces: &mut Faces,
    loops: &mut FoundLoops,
    walk_start: WalkStart,
    stats: &mut TrackingStats,
) -> ControlFlow<()> {
    let old_loops = std::mem::take(&mut loops.old);
    let outcome = old_loops
        .iter()
        .enumerate()
        .try_for_each(|(old, half_edges)| track_loop(faces, loops, old as u32, half_edges, walk_start, stats));
    loops.old = old_loops;
    outcome
}

/// Tests edges of one old loop until one leads to a new loop.
fn track_loop(
    faces: &mut Faces,
    loops: &mut FoundLoops,
    old: u32,
    half_edges: &[HalfEdgeId],
    walk_start: WalkStart,
    stats: &mut TrackingStats,
) -> ControlFlow<()> {
    for is_still_visible in [true, false] {
        for &half_edge in half_edges {
            if loops.loop_of(half_edge).is_some() || faces.is_front(half_edge.face()) != is_still_visible {
                continue;
            }
            let lead = follow(faces, loops, half_edge, walk_start, stats);
            check_walks(faces, stats)?;
            let Some(lead) = lead else { continue };
            let is_new = loops.loop_of(lead.half_edge).is_none();
            let new = loops.complete(faces, lead.half_edge);
            if let Some(shared) = lead.shared {
                loops.relate(old, new, shared);
            }
            if is_new {
                return ControlFlow::Continue(());
            }
        }
    }
    ControlFlow::Continue(())
}
