//! Tracking the Silhouette (Hall 2003): from the edges of the old loops to the loops of now.

use crate::as_printed::WalkStart;
use crate::complete_silhouette::FoundLoops;
use crate::faces::Faces;
use crate::find_silhouette_edge::{Start, find_silhouette_edge};
use crate::stats::TrackingStats;
use silhouette_core::HalfEdgeId;
use std::ops::ControlFlow;

/// What an old silhouette half-edge leads to.
pub(crate) struct Lead {
    /// A silhouette half-edge of now.
    pub half_edge: HalfEdgeId,
    /// Number of old half-edges that this says are part of the loop, beyond what completing the loop counts; `None`
    /// where the loop has nothing to do with the old one.
    pub shared: Option<u32>,
}

/// Tests an old silhouette half-edge, with its front face on this side (Hall's three cases).
///
/// - The sides differ: the edge is still part of the silhouette.
/// - Both are visible: the silhouette has grown; walk on from the face across.
/// - Both are invisible (or there is no face across): it has shrunk; walk back from the face on this side.
pub(crate) fn follow(
    faces: &mut Faces,
    loops: &FoundLoops,
    half_edge: HalfEdgeId,
    walk_start: WalkStart,
    stats: &mut TrackingStats,
) -> Option<Lead> {
    stats.edges_tested += 1;
    let across = faces.twin(half_edge);
    let is_front = faces.is_front(half_edge.face());
    let is_front_across = across.is_some_and(|across| faces.is_front(across.face()));
    let start = match (is_front, across) {
        (true, _) if !is_front_across => return Some(Lead { half_edge, shared: Some(0) }),
        (false, Some(across)) if is_front_across => return Some(Lead { half_edge: across, shared: Some(1) }),
        (true, Some(across)) if walk_start == WalkStart::Corrected => Start::Visible(across),
        (true, _) => Start::Visible(half_edge),
        (false, _) => Start::Invisible(half_edge),
    };
    let walk = find_silhouette_edge(faces, loops, start);
    stats.walks += 1;
    stats.walk_steps += walk.steps;
    stats.fruitless_walks += u64::from(walk.found.is_none());
    stats.strayed_walks += u64::from(walk.found.is_some() && walk.strayed);
    walk.found.map(|half_edge| Lead { half_edge, shared: (!walk.strayed).then_some(0) })
}

/// Walks of a frame that together take more steps than there are faces, times this, are given up for brute force. One
/// fruitless walk may take as many; a mesh turned away from the eye could make each old edge's walk take them.
const MOST_STEPS_A_FACE: u64 = 6;

/// [`ControlFlow::Break`] once walks have become dearer than brute force.
pub(crate) fn check_walks(faces: &Faces, stats: &TrackingStats) -> ControlFlow<()> {
    if stats.walk_steps > MOST_STEPS_A_FACE * faces.surface.triangles.len() as u64 {
        ControlFlow::Break(())
    } else {
        ControlFlow::Continue(())
    }
}

/// Takes over the old loops that rest, one test each, and hands the others to `track_loop` unless walks become too long.
pub(crate) fn track_loops(
    faces: &mut Faces,
    loops: &mut FoundLoops,
    stats: &mut TrackingStats,
    mut track_loop: impl FnMut(&mut Faces, &mut FoundLoops, usize, &mut TrackingStats) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let mut old = 0;
    while old < loops.old.loops.len() {
        let moving = loops.take_over_resting(faces, old);
        stats.edges_tested += (moving - old) as u64;
        if moving < loops.old.loops.len() {
            track_loop(faces, loops, moving, stats)?;
        }
        old = moving + 1;
    }
    ControlFlow::Continue(())
}

/// Tests every edge of an old loop.
pub(crate) fn track_all_edges(
    faces: &mut Faces,
    loops: &mut FoundLoops,
    old: usize,
    walk_start: WalkStart,
    stats: &mut TrackingStats,
) -> ControlFlow<()> {
    for place in loops.old.loops.range(old) {
        let half_edge = loops.old.loops.half_edges()[place];
        // Found before: part of the silhouette, and completing it noted where it came from.
        if loops.is_taken(place) || loops.is_found(half_edge) {
            continue;
        }
        if let Some(lead) = follow(faces, loops, half_edge, walk_start, stats) {
            let new = loops.complete(faces, lead.half_edge);
            if let Some(shared) = lead.shared {
                loops.relate(old as u32, new, shared);
            }
        }
        check_walks(faces, stats)?;
    }
    ControlFlow::Continue(())
}
