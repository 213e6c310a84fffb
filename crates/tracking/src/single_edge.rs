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
use std::ops::ControlFlow;

/// Tests edges of an old loop until one leads to a new loop.
pub(crate) fn track_single_edge(
    faces: &mut Faces,
    loops: &mut FoundLoops,
    old: usize,
    walk_start: WalkStart,
    stats: &mut TrackingStats,
) -> ControlFlow<()> {
    for is_still_visible in [true, false] {
        for place in loops.old.loops.range(old) {
            let half_edge = loops.old.loops.half_edges()[place];
            if loops.is_found(half_edge) || faces.is_front(half_edge.face()) != is_still_visible {
                continue;
            }
            let lead = follow(faces, loops, half_edge, walk_start, stats);
            check_walks(faces, stats)?;
            let Some(lead) = lead else { continue };
            let is_new = !loops.is_found(lead.half_edge);
            let new = loops.complete(faces, lead.half_edge);
            if let Some(shared) = lead.shared {
                loops.relate(old as u32, new, shared);
            }
            if is_new {
                return ControlFlow::Continue(());
            }
        }
    }
    ControlFlow::Continue(())
}
