//! Complete Silhouette (Hall 2003): from one silhouette half-edge all of its loop; and the set of loops found so far.
//!
//! The walk hugs the front faces along the silhouette until it is back: from a half-edge it turns about the end vertex,
//! inside the fan of front faces. Each turn is undone by one the other way, so the walk is a permutation of the
//! silhouette half-edges and always comes back. Departures, all of which concern the printed text
//! ([`as_printed`](crate::as_printed)): it runs forward, so that front faces are on the left; it stops where it began;
//! it lists half-edges of front faces. (It is what `silhouette_core::loops` does for any mesh, on the table of this
//! one.)
//!
//! # Coherence
//!
//! Where the walk comes to a half-edge of the last frame, it asks the same faces in the same order as it did then,
//! until one has turned. So each frame keeps the *trail* of its walks, the faces asked about with their answers. The
//! next frame asks all of them again before it walks ([`FoundLoops::compare`]), in one loop without branches in which
//! no face waits for the one before, and notes the answers that are *new*. A walk then takes over what it took in the
//! last frame up to the next new answer, by copying. Only where a face has turned does it turn about vertices.
//!
//! Loops without a new answer are taken over together. The price: the faces about a vertex that the silhouette has left
//! are evaluated too (departure 7 of the [crate](crate) says how many).
//!
//! `places` stores, for each half-edge, its index in the list of this or of the last frame; it is valid only if the
//! half-edge does stand there, so nothing is ever cleared. It prevents listing a loop twice, and completing a loop also
//! yields the old loops from which its half-edges came.

use crate::asked::Asked;
use crate::connectivity_table::{ConnectivityTable, Side};
use crate::faces::Faces;
use crate::identity::Relation;
use silhouette_core::{FaceId, HalfEdgeId, SilhouetteLoops};
use std::ops::Range;

/// The silhouette half-edge that follows another in its loop: turns about its end vertex, inside the fan of front faces.
/// O(faces in the fan).
#[inline]
pub(crate) fn next_silhouette_side(
    table: &ConnectivityTable,
    mut is_front: impl FnMut(FaceId) -> bool,
    side: Side,
) -> Side {
    let mut candidate = side.next_in_face();
    while let Some(across) = table.across(candidate)
        && is_front(across.face)
    {
        candidate = across.next_in_face();
    }
    candidate
}

/// Loops, and what the walks along them asked.
#[derive(Debug, Clone, Default)]
pub(crate) struct WalkedLoops {
    pub loops: SilhouetteLoops,
    /// Faces asked about, each with its answer, half-edge after half-edge.
    trail: Vec<Asked>,
    /// Where in the trail the step to the next half-edge ends, for each half-edge in the order of the loops.
    trail_ends: Vec<u32>,
}

impl WalkedLoops {
    fn clear(&mut self) {
        self.loops.clear();
        self.trail.clear();
        self.trail_ends.clear();
    }

    /// Where the trail of the half-edge at a place begins.
    fn trail_begin(&self, place: usize) -> usize {
        if place == 0 { 0 } else { self.trail_ends[place - 1] as usize }
    }

    fn bytes(&self) -> usize {
        self.loops.bytes() + size_of_val(self.trail.as_slice()) + size_of_val(self.trail_ends.as_slice())
    }
}

/// The loops of this frame, those of the last, and what relates them.
#[derive(Debug, Clone, Default)]
pub(crate) struct FoundLoops {
    pub now: WalkedLoops,
    /// Those of the last frame.
    pub old: WalkedLoops,
    /// Old loops with the new loops they became, in runs: a pair may occur several times.
    pub relations: Vec<Relation>,
    /// For each half-edge a place in the list of this frame, or else of the last, or else of some frame before.
    places: Vec<u32>,
    /// Places in the old trail whose faces answer in another way now, ascending.
    news: Vec<u32>,
    /// Whether the half-edge at each old place was taken over in this frame; those that were found but not taken over.
    taken: Vec<bool>,
    stepped: Vec<HalfEdgeId>,
    /// A bit for each half-edge: whether it is old. So much smaller than `places` that the question where a half-edge
    /// is new seldom waits for memory.
    are_old: Vec<u64>,
}

impl FoundLoops {
    /// Makes this frame's loops the old ones. [`compare`](Self::compare) has to follow before loops are completed.
    pub fn begin_frame(&mut self, half_edges: usize) {
        self.places.resize(half_edges, 0);
        self.are_old.resize(half_edges.div_ceil(64), 0);
        for (half_edge, _) in self.old.loops.half_edges().iter().zip(&self.taken).filter(|(_, is_taken)| !**is_taken) {
            self.are_old[half_edge.index() / 64] &= !(1 << (half_edge.index() % 64));
        }
        for half_edge in self.stepped.drain(..) {
            self.are_old[half_edge.index() / 64] |= 1 << (half_edge.index() % 64);
        }
        std::mem::swap(&mut self.now, &mut self.old);
        self.now.clear();
        self.relations.clear();
        self.taken.clear();
        self.taken.resize(self.old.loops.half_edges().len(), false);
    }

    /// Asks the faces along the old loops how they answer in this view. O(their number).
    pub fn compare(&mut self, faces: &mut Faces) {
        self.news.clear();
        faces.compare(&self.old.trail, &mut self.news);
    }

    /// Forgets all loops, old and new.
    pub fn forget(&mut self) {
        self.now.clear();
        self.old.clear();
        self.relations.clear();
        self.taken.clear();
        self.stepped.clear();
        self.are_old.fill(0);
    }

    /// Whether a half-edge was found in this frame.
    #[inline]
    pub fn is_found(&self, half_edge: HalfEdgeId) -> bool {
        let place = self.places[half_edge.index()] as usize;
        self.now.loops.half_edges().get(place) == Some(&half_edge)
    }

    /// Whether the half-edge at an old place is known to have been found in this frame: [`is_found`](Self::is_found) asked
    /// in the order of memory. Where the answer is no it may have been found nonetheless.
    #[inline]
    pub fn is_taken(&self, place: usize) -> bool {
        self.taken[place]
    }

    /// Whether a half-edge was silhouette in the last frame.
    #[inline]
    pub fn is_old(&self, half_edge: HalfEdgeId) -> bool {
        self.are_old[half_edge.index() / 64] >> (half_edge.index() % 64) & 1 == 1
    }

    /// Where an old half-edge was listed. Of one that was found in this frame there may be no answer.
    #[inline]
    fn old_place(&self, half_edge: HalfEdgeId) -> Option<usize> {
        if !self.is_old(half_edge) {
            return None;
        }
        let place = self.places[half_edge.index()] as usize;
        (self.old.loops.half_edges().get(place) == Some(&half_edge)).then_some(place)
    }

    /// Notes that an old loop became a new one, by `shared` half-edges.
    pub fn relate(&mut self, old: u32, new: u32, shared: u32) {
        match self.relations.last_mut() {
            Some(last) if (last.old, last.new) == (old, new) => last.shared += shared,
            _ => self.relations.push(Relation { old, new, shared }),
        }
    }

    /// The index of the loop through a silhouette half-edge, walked now unless it was found before. O(faces in the fans
    /// along it).
    pub fn complete(&mut self, faces: &mut Faces, start: HalfEdgeId) -> u32 {
        if self.is_found(start) {
            self.now.loops.loop_at(self.places[start.index()] as usize) as u32
        } else {
            self.walk(faces, start)
        }
    }

    fn walk(&mut self, faces: &mut Faces, start: HalfEdgeId) -> u32 {
        let index = self.now.loops.len() as u32;
        let start_place = self.old_place(start);
        // The old loop that the walk is on.
        let (mut old_loop, mut old_range) = (0, 0..0);
        let mut half_edge = start;
        loop {
            if let Some(place) = self.old_place(half_edge) {
                if !old_range.contains(&place) {
                    old_loop = self.old.loops.loop_at(place);
                    old_range = self.old.loops.range(old_loop);
                }
                // The start is where the loop ends, not a place to run past.
                let end = start_place.filter(|at| (place + 1..old_range.end).contains(at)).unwrap_or(old_range.end);
                let reached = self.run(place..end);
                self.relate(old_loop as u32, index, (reached - place) as u32);
                if reached == end {
                    half_edge = self.old.loops.half_edges()[if end == old_range.end { old_range.start } else { end }];
                    if half_edge == start {
                        break;
                    }
                    continue;
                }
                half_edge = self.old.loops.half_edges()[reached];
                self.relate(old_loop as u32, index, 1);
            }
            half_edge = self.step(faces, half_edge);
            if half_edge == start {
                break;
            }
        }
        self.now.loops.end_loop();
        index
    }

    /// Takes over an old loop and those after it, up to one that is not the same any more or was found before, all in one
    /// piece. The index of that one. O(half-edges taken over).
    pub fn take_over_resting(&mut self, faces: &mut Faces, first: usize) -> usize {
        let begin = self.old.loops.range(first).start;
        let next_new = self.next_new(self.old.trail_begin(begin)).map_or(usize::MAX, |at| at as usize);
        let mut next = first;
        while next < self.old.loops.len() {
            let range = self.old.loops.range(next);
            let is_same = self.old.trail_begin(range.end) <= next_new && !self.taken[range.start];
            // The trail says all of a loop but that the face where it begins still is front.
            if !is_same || !faces.is_front(self.old.loops.half_edges()[range.start].face()) {
                break;
            }
            let new = (self.now.loops.len() + next - first) as u32;
            self.relations.push(Relation { old: next as u32, new, shared: range.len() as u32 });
            next += 1;
        }
        if next > first {
            let end = self.old.loops.range(next - 1).end;
            self.take_over_trail(begin..end);
            self.now.loops.extend_from_loops(&self.old.loops, first..next);
        }
        next
    }

    /// The first place in the old trail, from this one on, at which the answer is new.
    fn next_new(&self, trail_begin: usize) -> Option<u32> {
        self.news.get(self.news.partition_point(|&at| (at as usize) < trail_begin)).copied()
    }

    /// Takes over all but the half-edges themselves.
    fn take_over_trail(&mut self, old_places: Range<usize>) {
        let Self { now, old, places, .. } = self;
        let half_edges = &old.loops.half_edges()[old_places.clone()];
        for (half_edge, place) in half_edges.iter().zip(now.trail_ends.len() as u32..) {
            places[half_edge.index()] = place;
        }
        let (begin, end) = (old.trail_begin(old_places.start), old.trail_begin(old_places.end));
        // Both trails are shorter than the number of half-edges, so their places fit 32 bits.
        let shift = (now.trail.len() as u32).wrapping_sub(begin as u32);
        now.trail.extend_from_slice(&old.trail[begin..end]);
        now.trail_ends.extend(old.trail_ends[old_places.clone()].iter().map(|end| end.wrapping_add(shift)));
        self.taken[old_places].fill(true);
    }

    /// Takes over old half-edges from these places up to a new answer on the way to the next one. The place of the
    /// first half-edge from which another way leads on, or the end.
    fn run(&mut self, places: Range<usize>) -> usize {
        let old = &self.old;
        let reached = match self.next_new(old.trail_begin(places.start)) {
            Some(turned) => places.start + old.trail_ends[places.clone()].partition_point(|&end| end <= turned),
            None => places.end,
        };
        let taken = places.start..reached;
        self.now.loops.extend_from_slice(&old.loops.half_edges()[taken.clone()]);
        self.take_over_trail(taken);
        reached
    }

    /// Lists a silhouette half-edge and walks to the next. O(faces in the fan).
    fn step(&mut self, faces: &mut Faces, half_edge: HalfEdgeId) -> HalfEdgeId {
        let WalkedLoops { loops, trail, trail_ends } = &mut self.now;
        self.places[half_edge.index()] = trail_ends.len() as u32;
        loops.push(half_edge);
        self.stepped.push(half_edge);
        let table = faces.surface.table;
        let is_front = |face| {
            let is_front = faces.is_front(face);
            trail.push(Asked::new(face, is_front));
            is_front
        };
        let next = next_silhouette_side(table, is_front, Side::of(half_edge));
        trail_ends.push(trail.len() as u32);
        next.half_edge()
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        let marks = size_of_val(self.places.as_slice()) + size_of_val(self.news.as_slice()) + self.taken.len();
        let sets = size_of_val(self.are_old.as_slice()) + size_of_val(self.stepped.as_slice());
        marks + sets + size_of_val(self.relations.as_slice()) + self.now.bytes() + self.old.bytes()
    }
}
