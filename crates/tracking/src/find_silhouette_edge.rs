//! Find Silhouette Edge (Hall 2003): a left-right walk over faces from an old silhouette edge to the silhouette of now.
//!
//! The walk enters a face through one of its sides and looks across the other two. Seeking the first *invisible* face,
//! it stands on visible ones and ends at a side across which there is a back face or none; seeking the first *visible*
//! face, it stands on invisible ones and ends at the front face across. Otherwise it crosses left and right by turns.
//!
//! Departures:
//!
//! 1. It starts into the side that the silhouette moved to ([`Start`]). Called as Hall's parameters suggest, from the
//!    old visible face, a walk outwards runs away from the silhouette ([`WalkStart`](crate::as_printed::WalkStart)).
//! 2. No cap on iterations: a fruitless walk ends when it returns to its first state. Crossing left or right by turns
//!    is injective on the states (side entered through, turn), so a walk that does not end comes back to the first
//!    state in which it entered through a side with a face behind it: at the very start, or after one step if it starts
//!    at a boundary edge. There are six states a face, so no walk takes more than 6 F steps.
//! 3. Seeking a visible face, a boundary edge is no silhouette: the walk turns to the other side, and gives up between two
//!    boundary edges. (It never enters through a boundary edge, so turning keeps the steps injective.)
//! 4. It notices whether it crossed a silhouette edge of the last frame. Such a walk has *strayed* from the ground that
//!    its silhouette moved over: what it finds is a silhouette, but not what became of the loop it came from.

use crate::complete_silhouette::FoundLoops;
use crate::connectivity_table::Side;
use crate::faces::Faces;
use silhouette_core::HalfEdgeId;

/// Where a walk starts and what it seeks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Start {
    /// On a visible face, entered through this side of it; seeks an invisible one.
    Visible(HalfEdgeId),
    /// On an invisible face, entered through this side of it; seeks a visible one.
    Invisible(HalfEdgeId),
}

/// What a walk came to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Walk {
    /// A silhouette half-edge; `None` where there is none to be reached.
    pub found: Option<HalfEdgeId>,
    /// Faces walked to beyond the first.
    pub steps: u64,
    /// Whether it crossed a silhouette edge of the last frame.
    pub strayed: bool,
}

/// Walks to a silhouette half-edge.
pub(crate) fn find_silhouette_edge(faces: &mut Faces, loops: &FoundLoops, start: Start) -> Walk {
    let (mut entered, seeks_visible) = match start {
        Start::Visible(entered) => (Side::of(entered), false),
        Start::Invisible(entered) => (Side::of(entered), true),
    };
    let mut walk = Walk { found: None, steps: 0, strayed: false };
    let mut turns_left = true;
    let mut first = None;
    loop {
        let sides = [entered.next_in_face(), entered.next_in_face().next_in_face()];
        let across = sides.map(|side| faces.across(side));
        for (side, across) in sides.into_iter().zip(across) {
            let is_front = across.is_some_and(|across| faces.is_front(across.face));
            if is_front == seeks_visible {
                walk.found = if seeks_visible { across } else { Some(side) }.map(Side::half_edge);
                return walk;
            }
        }
        if first.is_none() && faces.across(entered).is_some() {
            first = Some((entered, turns_left));
        }
        let turn = if turns_left { [0, 1] } else { [1, 0] };
        let Some((side, next)) = turn.into_iter().find_map(|turn| across[turn].map(|next| (sides[turn], next))) else {
            return walk;
        };
        // The side of the crossed edge that was front in the last frame, if it was a silhouette then.
        walk.strayed |= loops.is_old(if seeks_visible { side } else { next }.half_edge());
        walk.steps += 1;
        turns_left = !turns_left;
        entered = next;
        if first == Some((entered, turns_left)) {
            return walk;
        }
    }
}
