//! The loops of a frame, woven from those of the last.

use crate::complete_silhouette::next_silhouette_side;
use crate::connectivity_table::{ConnectivityTable, Side};
use crate::identity::Relation;
use silhouette_core::{FaceFacings, HalfEdgeId, SilhouetteLoops};
use std::ops::Range;

/// What has become of an old half-edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Fate {
    /// Silhouette still; whatever follows it, if that is still silhouette, follows it still.
    Same,
    /// Silhouette still, but what follows has to be found.
    Bent,
    /// No silhouette any more.
    Gone,
}

/// Loops of this frame and the last, with a place for each half-edge.
#[derive(Debug, Clone, Default)]
pub(super) struct LoopWeaver {
    pub loops: SilhouetteLoops,
    /// Old loops with the new loops they became, in runs: a pair may occur several times.
    pub relations: Vec<Relation>,
    old: SilhouetteLoops,
    /// One an old half-edge, in the order of the old loops.
    fates: Vec<Fate>,
    /// Half-edges that became silhouette.
    new: Vec<HalfEdgeId>,
    /// Where each half-edge stands in the list of this or of the last frame, if it does stand there: so that nothing has
    /// to be cleared.
    places: Vec<u32>,
}

impl LoopWeaver {
    /// Makes this frame's loops the old ones, of which nothing is known to have changed.
    pub fn begin_frame(&mut self, half_edges: usize) {
        self.places.resize(half_edges, 0);
        std::mem::swap(&mut self.loops, &mut self.old);
        self.loops.clear();
        self.relations.clear();
        self.new.clear();
        self.fates.clear();
        self.fates.resize(self.old.half_edges().len(), Fate::Same);
    }

    /// Forgets all loops.
    pub fn forget(&mut self) {
        self.loops.clear();
    }

    /// Place among the old half-edges. Of one that was found in this frame there may be no answer.
    #[inline]
    fn old_place(&self, half_edge: HalfEdgeId) -> Option<usize> {
        let place = self.places[half_edge.index()] as usize;
        (self.old.half_edges().get(place) == Some(&half_edge)).then_some(place)
    }

    #[inline]
    fn is_found(&self, half_edge: HalfEdgeId) -> bool {
        self.loops.half_edges().get(self.places[half_edge.index()] as usize) == Some(&half_edge)
    }

    /// Notes that a half-edge is silhouette, whether or not it was.
    pub fn note_new(&mut self, half_edge: HalfEdgeId) {
        if self.old_place(half_edge).is_none() {
            self.new.push(half_edge);
        }
    }

    /// Notes that a half-edge is no silhouette, whether or not it was.
    pub fn note_gone(&mut self, half_edge: HalfEdgeId) {
        if let Some(place) = self.old_place(half_edge) {
            self.fates[place] = Fate::Gone;
        }
    }

    /// Notes that something else follows a half-edge; false if it was no silhouette.
    pub fn note_bent(&mut self, half_edge: HalfEdgeId) -> bool {
        let Some(place) = self.old_place(half_edge) else { return false };
        if self.fates[place] == Fate::Same {
            self.fates[place] = Fate::Bent;
        }
        true
    }

    /// Puts the loops together that hold an old half-edge; yields their number. O(S), most of it copying.
    pub fn weave_from_old(&mut self, table: &ConnectivityTable, facings: &FaceFacings) -> usize {
        for place in 0..self.fates.len() {
            let half_edge = self.old.half_edges()[place];
            if self.fates[place] != Fate::Gone && !self.is_found(half_edge) {
                self.walk(table, facings, half_edge);
            }
        }
        self.loops.len()
    }

    /// Puts the other loops together. O(their length).
    pub fn weave_from_new(&mut self, table: &ConnectivityTable, facings: &FaceFacings) {
        for index in 0..self.new.len() {
            if !self.is_found(self.new[index]) {
                self.walk(table, facings, self.new[index]);
            }
        }
    }

    fn walk(&mut self, table: &ConnectivityTable, facings: &FaceFacings, start: HalfEdgeId) {
        let index = self.loops.len() as u32;
        let mut run = Relation { old: u32::MAX, new: index, shared: 0 };
        // Places of the old loop of the last old half-edge.
        let mut range = 0..0;
        let (mut half_edge, mut place) = (start, self.old_place(start));
        loop {
            // A new half-edge whose twin was silhouette lies on the same edge of the same old loop.
            let from = place.or_else(|| table.twin(half_edge).and_then(|twin| self.old_place(twin)));
            if let Some(from) = from {
                if !range.contains(&from) {
                    self.relations.extend((run.shared > 0).then_some(run));
                    let old = self.old.loop_at(from);
                    range = self.old.range(old);
                    run = Relation { old: old as u32, new: index, shared: 0 };
                }
                run.shared += 1;
            }
            self.places[half_edge.index()] = self.loops.half_edges().len() as u32;
            self.loops.push(half_edge);
            match place.and_then(|place| self.next_place(place, &range)) {
                // Not asked of the half-edge: in a run of copies nothing then waits for the one before.
                Some(next) => (half_edge, place) = (self.old.half_edges()[next], Some(next)),
                None => {
                    let is_front = |face| facings.is_front(face);
                    half_edge = next_silhouette_side(table, is_front, Side::of(half_edge)).half_edge();
                    place = self.old_place(half_edge);
                }
            }
            if half_edge == start {
                break;
            }
        }
        self.relations.extend((run.shared > 0).then_some(run));
        self.loops.end_loop();
    }

    /// Place of what followed the old half-edge at a place, in the loop with this range, if it still does.
    #[inline]
    fn next_place(&self, place: usize, range: &Range<usize>) -> Option<usize> {
        let next = if place + 1 == range.end { range.start } else { place + 1 };
        let still_follows = self.fates[place] == Fate::Same && self.fates[next] != Fate::Gone;
        still_follows.then_some(next)
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        let lists = size_of_val(self.relations.as_slice()) + size_of_val(self.new.as_slice()) + self.fates.len();
        size_of_val(self.places.as_slice()) + self.loops.bytes() + self.old.bytes() + lists
    }
}
