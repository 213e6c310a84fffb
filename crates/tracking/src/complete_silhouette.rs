//! Complete Silhouette (Hall 2003): from one silhouette half-edge all of its loop; and the set of loops found so far.
//!
//! The walk hugs the front faces along the silhouette until it is back: from a half-edge it turns about the end vertex,
//! inside the fan of front faces. Each turn is undone by one the other way, so the walk is a permutation of the silhouette
//! half-edges and always comes back. Departures, all of which concern the printed text
//! ([`as_printed`](crate::as_printed)): it runs forward, so that front faces are on the left; it stops where it began; it
//! lists half-edges of front faces. (It is what `silhouette_core::loops` does for any mesh, on the table of this one.)
//!
//! The set that keeps double silhouettes out is a mark a half-edge, which says in which loop it lies and whether that loop
//! is of this frame or of the last. So completing a loop also learns, at no further cost, from which old loops its
//! half-edges came.

use crate::connectivity_table::Side;
use crate::faces::Faces;
use crate::identity::Relation;
use silhouette_core::{HalfEdgeId, SilhouetteLoops};

/// The loops of this frame, those of the last, and what relates them.
#[derive(Debug, Clone, Default)]
pub(crate) struct FoundLoops {
    pub loops: SilhouetteLoops,
    /// Those of the last frame.
    pub old: SilhouetteLoops,
    /// Old loops with the new loops they became, in runs: a pair may occur several times.
    pub relations: Vec<Relation>,
    /// For each half-edge 0, or one above its loop's index, times two, plus the parity of the loop's frame.
    marks: Vec<u32>,
    parity: u32,
}

impl FoundLoops {
    /// Makes this frame's loops the old ones.
    pub fn begin_frame(&mut self, half_edges: usize) {
        if self.marks.len() != half_edges {
            self.marks.clear();
            self.marks.resize(half_edges, 0);
        }
        std::mem::swap(&mut self.loops, &mut self.old);
        self.loops.clear();
        self.relations.clear();
        self.parity ^= 1;
    }

    /// Removes the marks of old half-edges that are no silhouette any more. O(old silhouette).
    pub fn end_frame(&mut self) {
        for half_edge in self.old.half_edges() {
            let mark = &mut self.marks[half_edge.index()];
            if *mark & 1 != self.parity {
                *mark = 0;
            }
        }
    }

    /// Forgets all loops, old and new. O(silhouette).
    pub fn forget(&mut self) {
        for half_edge in self.loops.half_edges() {
            self.marks[half_edge.index()] = 0;
        }
        self.loops.clear();
        self.old.clear();
        self.relations.clear();
    }

    /// The loop of this frame that a half-edge was found in.
    #[inline]
    pub fn loop_of(&self, half_edge: HalfEdgeId) -> Option<u32> {
        let mark = self.marks[half_edge.index()];
        (mark & 1 == self.parity && mark != 0).then(|| (mark >> 1) - 1)
    }

    /// Whether a half-edge was silhouette in the last frame and has not been found in this one.
    #[inline]
    pub fn is_old(&self, half_edge: HalfEdgeId) -> bool {
        let mark = self.marks[half_edge.index()];
        mark & 1 != self.parity && mark != 0
    }

    /// Notes that an old loop became a new one, by `shared` half-edges.
    pub fn relate(&mut self, old: u32, new: u32, shared: u32) {
        match self.relations.last_mut() {
            Some(last) if (last.old, last.new) == (old, new) => last.shared += shared,
            _ => self.relations.push(Relation { old, new, shared }),
        }
    }

    /// The loop through a silhouette half-edge, walked now unless it was found before. O(faces in the fans along it).
    pub fn complete(&mut self, faces: &mut Faces, start: HalfEdgeId) -> u32 {
        self.loop_of(start).unwrap_or_else(|| self.walk(faces, start))
    }

    fn walk(&mut self, faces: &mut Faces, start: HalfEdgeId) -> u32 {
        let index = self.loops.len() as u32;
        let mark = (index + 1) << 1 | self.parity;
        // The old loop that the walk runs along, as a mark, and for how long it has.
        let (mut along, mut shared) = (0, 0);
        let mut side = Side::of(start);
        loop {
            let half_edge = side.half_edge();
            let before = std::mem::replace(&mut self.marks[half_edge.index()], mark);
            if before == along {
                shared += 1;
            } else if before != 0 {
                if along != 0 {
                    self.relations.push(Relation { old: (along >> 1) - 1, new: index, shared });
                }
                (along, shared) = (before, 1);
            }
            self.loops.push(half_edge);
            side = next_silhouette_side(faces, side);
            if side.half_edge() == start {
                break;
            }
        }
        if along != 0 {
            self.relations.push(Relation { old: (along >> 1) - 1, new: index, shared });
        }
        self.loops.end_loop();
        index
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        let relations = size_of_val(self.relations.as_slice());
        size_of_val(self.marks.as_slice()) + self.loops.bytes() + self.old.bytes() + relations
    }
}

/// The silhouette half-edge that follows another in its loop. O(faces in the fan).
#[inline]
fn next_silhouette_side(faces: &mut Faces, side: Side) -> Side {
    let mut candidate = side.next_in_face();
    while let Some(across) = faces.across(candidate)
        && faces.is_front(across.face)
    {
        candidate = across.next_in_face();
    }
    candidate
}
