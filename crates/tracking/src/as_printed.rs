//! The pseudo-code of Hall (2003) as printed, where it differs from what is meant, so that the difference can be seen.
//!
//! | place | printed | effect | here |
//! |---|---|---|---|
//! | Complete Silhouette | `TestFace` is the face adjacent on edge `TestFace` | names itself, undefined | always `TestEdge` |
//! | Complete Silhouette | stops when *TestFace* is the first face | never: `TestFace` is invisible or absent | [`StopTest`] |
//! | Complete Silhouette | appends *(TestFace, TestEdge)* | names invisible faces | [`AppendedFace`] |
//! | Complete Silhouette | pivots about the start vertex | the list runs against its half-edges | [`LoopOrder`] |
//! | Find Silhouette Edge | starts at the old visible face | walks outwards run away from the silhouette | [`WalkStart`] |
//! | Find Silhouette Edge | `WHILE TRUE` | never ends where all faces are visible | [`find_silhouette_edge`] |
//!
//! What terminates is an option of the tracker ([`LoopOrder`], [`WalkStart`]) or of [`complete_silhouette`]; what does
//! not is run with a bound on its steps. Nothing here is fast, and the tracker uses none of the functions.

use silhouette_core::topology::Twin;
use silhouette_core::{FaceId, HalfEdgeId, SilhouetteLoops, Topology};

silhouette_core::option_choice! {
    /// Where the walk starts from an old edge on both sides of which faces are visible now.
    pub enum WalkStart {
        /// At the face that has become visible: the way the silhouette went.
        Corrected = "corrected",
        /// At the old visible face, as the parameters are named: away from it.
        AsPrinted = "as-printed",
    }
}

/// In which order the half-edges of a loop are listed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LoopOrder {
    /// Each half-edge begins where the one before it ends.
    #[default]
    Corrected,
    /// Each half-edge ends where the one before it begins.
    AsPrinted,
}

/// What the stop test of Complete Silhouette compares with the first face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum StopTest {
    /// The current face, as is meant.
    #[default]
    CurrentFace,
    /// The face across, as printed: the test never holds.
    TestFace,
}

/// Which face Complete Silhouette appends to its list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AppendedFace {
    /// The current, visible face, as is meant.
    #[default]
    CurrentFace,
    /// The face across, as printed.
    TestFace,
}

/// An entry of the printed list: a face, absent across a boundary edge, and an edge index.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PrintedEdge {
    /// The face that the entry names.
    pub face: Option<FaceId>,
    /// The edge index, 0 to 2, always that of the current face.
    pub slot: u32,
}

/// What the printed Complete Silhouette came to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PrintedLoop {
    /// The list so far.
    pub entries: Vec<PrintedEdge>,
    /// Whether it ended, or was cut off at the bound on its steps.
    pub ended: bool,
}

/// Complete Silhouette with the printed stop test, the printed entries, both or neither, for at most `max_steps` rounds
/// of its loop. The list runs against the half-edges, as printed.
///
/// # Panics
/// If `start` is no half-edge of the mesh.
pub fn complete_silhouette(
    topology: &Topology,
    mut is_front: impl FnMut(FaceId) -> bool,
    start: HalfEdgeId,
    slips: (StopTest, AppendedFace),
    max_steps: usize,
) -> PrintedLoop {
    let mut entries = vec![PrintedEdge { face: Some(start.face()), slot: start.slot() }];
    let mut back = start;
    for _ in 0..max_steps {
        let test_edge = back.next_in_face().next_in_face();
        let across = twin(topology, test_edge);
        match across.filter(|across| is_front(across.face())) {
            Some(across) => back = across,
            None => {
                let current = Some(test_edge.face());
                let test_face = across.map(HalfEdgeId::face);
                let compared = if slips.0 == StopTest::CurrentFace { current } else { test_face };
                if compared == Some(start.face()) && test_edge.slot() == start.slot() {
                    return PrintedLoop { entries, ended: true };
                }
                let face = if slips.1 == AppendedFace::CurrentFace { current } else { test_face };
                entries.push(PrintedEdge { face, slot: test_edge.slot() });
                back = test_edge;
            }
        }
    }
    PrintedLoop { entries, ended: false }
}

/// Find Silhouette Edge as printed, from a visible face entered through one of its sides, for at most `max_steps`
/// rounds of its loop; the half-edge and how many rounds it took.
///
/// # Panics
/// If `from` is no half-edge of the mesh.
pub fn find_silhouette_edge(
    topology: &Topology,
    mut is_front: impl FnMut(FaceId) -> bool,
    from: HalfEdgeId,
    max_steps: usize,
) -> Option<(HalfEdgeId, usize)> {
    let mut back = from;
    for step in 0..max_steps {
        let sides = [back.next_in_face(), back.next_in_face().next_in_face()];
        for side in sides {
            if twin(topology, side).is_none_or(|across| !is_front(across.face())) {
                return Some((side, step));
            }
        }
        back = twin(topology, sides[step % 2])?;
    }
    None
}

fn twin(topology: &Topology, half_edge: HalfEdgeId) -> Option<HalfEdgeId> {
    match topology.twin(half_edge) {
        Twin::HalfEdge(twin) => Some(twin),
        Twin::Boundary | Twin::NonManifold => None,
    }
}

/// Replaces `out` by the loops in printed order: from the same half-edge, the other way round.
pub(crate) fn list_in_printed_order(loops: &SilhouetteLoops, out: &mut SilhouetteLoops) {
    out.clear();
    for half_edges in loops.iter() {
        let (first, rest) = half_edges.split_at(1);
        first.iter().chain(rest.iter().rev()).for_each(|&half_edge| out.push(half_edge));
        out.end_loop();
    }
}
