//! Silhouette edges as closed, ordered, oriented loops.
//!
//! A *silhouette half-edge* belongs to a front face and to a silhouette edge. From one, the next is found by pivoting
//! about its end vertex inside the fan of front faces, until a silhouette half-edge leaves that vertex: what Hall (2003,
//! Complete Silhouette) does about the start vertex and in the opposite direction. Crossing an edge inside the fan is a
//! permutation of the half-edges of front faces, and so is stepping on within a face; so the walk from any silhouette
//! half-edge returns to it, and the loops partition the set, for every facing whatever. Chaining by vertex would not do:
//! several loops often touch in one vertex.
//!
//! Departures from Hall: (1) the walk runs forward, so the front face is on the left without reversing the result;
//! (2) a non-manifold edge between front faces only is crossed to the next of its half-edges, cyclically; at any other
//! non-manifold edge each front face has a silhouette half-edge of its own; (3) where the winding is inconsistent, loops
//! still close, but consecutive half-edges need not share a vertex.

use crate::facing::FaceFacings;
use crate::id::{EdgeId, FaceId, HalfEdgeId, VertexId};
use crate::mesh::TriangleMesh;
use crate::silhouette::{SilhouetteEdges, is_silhouette_edge};
use crate::topology::{Topology, Twin};
use std::collections::HashMap;
use std::ops::Range;

/// Closed loops of silhouette half-edges, front face on the left, seen from the viewer's side of the surface.
///
/// On a consistently wound mesh each half-edge ends where the next begins, the last where the first begins. Loops are
/// ordered by their lowest edge, which is also where each begins, unless who formed them says otherwise.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct SilhouetteLoops {
    half_edges: Vec<HalfEdgeId>,
    /// Where each loop ends in `half_edges`.
    ends: Vec<usize>,
}

impl SilhouetteLoops {
    /// Number of loops.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there is no loop.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The half-edges of each loop.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[HalfEdgeId]> {
        (0..self.ends.len()).map(|index| self.get(index))
    }

    /// All half-edges, loop after loop.
    pub fn half_edges(&self) -> &[HalfEdgeId] {
        &self.half_edges
    }

    /// The half-edges of one loop.
    ///
    /// # Panics
    /// If there is no such loop.
    pub fn get(&self, index: usize) -> &[HalfEdgeId] {
        &self.half_edges[self.range(index)]
    }

    /// Where one loop stands in [`half_edges`](Self::half_edges).
    ///
    /// # Panics
    /// If there is no such loop.
    pub fn range(&self, index: usize) -> Range<usize> {
        let begin = if index == 0 { 0 } else { self.ends[index - 1] };
        begin..self.ends[index]
    }

    /// The index of the loop that holds a place of [`half_edges`](Self::half_edges); the number of loops for a place
    /// beyond them. O(log loops).
    pub fn loop_at(&self, place: usize) -> usize {
        self.ends.partition_point(|&end| end <= place)
    }

    /// Removes all loops; keeps the memory.
    pub fn clear(&mut self) {
        self.half_edges.clear();
        self.ends.clear();
    }

    /// Appends a half-edge to the loop that is being formed.
    #[inline]
    pub fn push(&mut self, half_edge: HalfEdgeId) {
        self.half_edges.push(half_edge);
    }

    /// Appends half-edges to the loop that is being formed.
    #[inline]
    pub fn extend_from_slice(&mut self, half_edges: &[HalfEdgeId]) {
        self.half_edges.extend_from_slice(half_edges);
    }

    /// Appends some of other loops. None may be in the course of being formed.
    ///
    /// # Panics
    /// If there are no such loops.
    pub fn extend_from_loops(&mut self, other: &Self, loops: Range<usize>) {
        let begin = if loops.start == 0 { 0 } else { other.ends[loops.start - 1] };
        let (first, ends) = (self.half_edges.len(), &other.ends[loops]);
        self.half_edges.extend_from_slice(&other.half_edges[begin..ends.last().copied().unwrap_or(begin)]);
        self.ends.extend(ends.iter().map(|end| end - begin + first));
    }

    /// Ends the loop that is being formed.
    ///
    /// # Panics
    /// In builds with debug assertions, if it has no half-edge.
    pub fn end_loop(&mut self) {
        debug_assert!(self.ends.last().copied().unwrap_or(0) < self.half_edges.len(), "a loop has a half-edge");
        self.ends.push(self.half_edges.len());
    }

    /// Replaces these loops by `loops`, each begun at its lowest edge and all ordered by it. `starts` is scratch memory:
    /// for each loop its lowest edge and where that lies. O(S + loops log loops), no allocation once memory has grown.
    pub fn refill_ordered(&mut self, topology: &Topology, loops: &Self, starts: &mut Vec<LoopStart>) {
        starts.clear();
        starts.extend(loops.iter().enumerate().map(|(index, half_edges)| {
            let keys = half_edges.iter().map(|&half_edge| (topology.edge_of(half_edge), half_edge));
            let (place, lowest) = keys.enumerate().min_by_key(|&(_, key)| key).unzip();
            LoopStart { lowest, index, place: place.unwrap_or(0) }
        }));
        starts.sort_unstable();
        self.clear();
        for start in starts.iter() {
            let (before, after) = loops.get(start.index).split_at(start.place);
            self.half_edges.extend_from_slice(after);
            self.half_edges.extend_from_slice(before);
            self.ends.push(self.half_edges.len());
        }
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        size_of_val(self.half_edges.as_slice()) + size_of_val(self.ends.as_slice())
    }
}

/// Where a loop has its lowest edge: scratch of [`SilhouetteLoops::refill_ordered`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct LoopStart {
    lowest: Option<(EdgeId, HalfEdgeId)>,
    index: usize,
    place: usize,
}

/// The vertex that a half-edge leaves.
///
/// # Panics
/// If the mesh has no such half-edge.
pub fn start_vertex(mesh: &TriangleMesh, half_edge: HalfEdgeId) -> VertexId {
    VertexId::new(mesh.triangles()[half_edge.face().index()][half_edge.slot() as usize])
}

/// Forms loops; keeps its scratch memory from call to call.
#[derive(Debug, Clone, Default)]
pub struct LoopWalker {
    /// A bit an edge; all zero between calls.
    silhouette: Vec<u64>,
    /// A bit a half-edge; all zero between calls.
    visited: Vec<u64>,
    /// Whether non-manifold edges that were not found are silhouette edges; empty between calls.
    looked_at: HashMap<EdgeId, bool>,
}

impl LoopWalker {
    /// Replaces `out` by the loops through `edges`, which are silhouette edges of `facings`: all of them, or those that a
    /// method found that may miss loops.
    ///
    /// O(S + faces in the fans around silhouette vertices), times log S where these hold non-manifold edges; no
    /// allocation once memory has grown.
    ///
    /// # Panics
    /// If `edges` and `facings` do not belong to `topology`.
    pub fn walk(
        &mut self,
        topology: &Topology,
        facings: &FaceFacings,
        edges: &SilhouetteEdges,
        out: &mut SilhouetteLoops,
    ) {
        out.clear();
        self.visited.resize(topology.half_edge_count().div_ceil(64), 0);
        let mut looked_at = std::mem::take(&mut self.looked_at);
        let mut is_front = |face| facings.is_front(face);
        for &start in edges.iter().flat_map(|edge| topology.half_edges(edge)) {
            if facings.is_front(start.face()) && !is_set(&self.visited, start.index()) {
                self.follow(start, out, |_, half_edge| {
                    // A walk that takes a silhouette edge for another one, since it was not found, leaves the fan for good. Its
                    // faces are looked at once, not each time that a walk comes to it.
                    let is_silhouette = |_: &mut _, edge| {
                        edges.contains(edge)
                            || *looked_at.entry(edge).or_insert_with(|| is_silhouette_edge(topology, facings, edge))
                    };
                    next_silhouette_half_edge(topology, &mut is_front, is_silhouette, half_edge)
                });
            }
        }
        looked_at.clear();
        self.looked_at = looked_at;
        self.forget(out);
    }

    /// [`walk`](Self::walk) where `edges` are *all* silhouette edges of a view, and facings are looked up, or found, one by
    /// one. Inside a fan of front faces an edge that is no silhouette edge has front faces on all sides, so that a bit an
    /// edge leads the walk, and facings are asked for where a loop begins: of one or two faces, and of all faces at a
    /// non-manifold silhouette edge.
    ///
    /// # Panics
    /// If `edges` are not all the silhouette edges of these facings on `topology`, which may not be
    /// [severed](Topology::severed). The walker is of no use after a panic.
    pub fn walk_complete(
        &mut self,
        topology: &Topology,
        mut is_front: impl FnMut(FaceId) -> bool,
        edges: &SilhouetteEdges,
        out: &mut SilhouetteLoops,
    ) {
        out.clear();
        self.silhouette.resize(topology.edge_count().div_ceil(64), 0);
        self.visited.resize(topology.half_edge_count().div_ceil(64), 0);
        for edge in edges.iter() {
            set(&mut self.silhouette, edge.index());
        }
        for edge in edges.iter() {
            let sides = topology.half_edges(edge);
            // Of two sides one is front, so that one visited leaves nothing to begin at.
            if sides.len() == 2 && sides.iter().any(|side| is_set(&self.visited, side.index())) {
                continue;
            }
            for &side in sides {
                if !is_set(&self.visited, side.index()) && is_front(side.face()) {
                    self.follow(side, out, |walker, half_edge| walker.next(topology, half_edge));
                }
            }
        }
        for edge in edges.iter() {
            self.silhouette[edge.index() / 64] = 0;
        }
        self.forget(out);
    }

    /// Appends the loop through a silhouette half-edge. A half-edge that comes again is the start.
    fn follow(
        &mut self,
        start: HalfEdgeId,
        out: &mut SilhouetteLoops,
        mut next: impl FnMut(&Self, HalfEdgeId) -> HalfEdgeId,
    ) {
        let mut half_edge = start;
        while !is_set(&self.visited, half_edge.index()) {
            set(&mut self.visited, half_edge.index());
            out.half_edges.push(half_edge);
            half_edge = next(self, half_edge);
        }
        out.ends.push(out.half_edges.len());
    }

    /// Pivots about the end vertex inside the fan of front faces.
    fn next(&self, topology: &Topology, half_edge: HalfEdgeId) -> HalfEdgeId {
        let mut candidate = half_edge.next_in_face();
        while !is_set(&self.silhouette, topology.edge_of(candidate).index()) {
            let across = match topology.twin(candidate) {
                Twin::HalfEdge(twin) => twin,
                Twin::NonManifold => next_around_edge(topology, candidate),
                Twin::Boundary => panic!("a boundary edge of a front face is a silhouette edge"),
            };
            candidate = across.next_in_face();
            assert!(candidate != half_edge.next_in_face(), "around a silhouette vertex there are silhouette edges");
        }
        candidate
    }

    fn forget(&mut self, out: &SilhouetteLoops) {
        for half_edge in &out.half_edges {
            self.visited[half_edge.index() / 64] = 0;
        }
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        let looked_at = self.looked_at.capacity() * size_of::<(EdgeId, bool)>();
        size_of_val(self.silhouette.as_slice()) + size_of_val(self.visited.as_slice()) + looked_at
    }
}

fn set(bits: &mut [u64], index: usize) {
    bits[index / 64] |= 1 << (index % 64);
}

fn is_set(bits: &[u64], index: usize) -> bool {
    bits[index / 64] >> (index % 64) & 1 == 1
}

/// The silhouette half-edge that follows another in its loop: pivots about the end vertex inside the fan of front faces.
/// `is_silhouette` is asked of non-manifold edges only. O(faces in the fan), and at each non-manifold edge that question
/// and O(log faces at the edge).
///
/// # Panics
/// If `half_edge` is of another mesh. If it is no silhouette half-edge, the walk may not end.
pub fn next_silhouette_half_edge<F: FnMut(FaceId) -> bool>(
    topology: &Topology,
    is_front: &mut F,
    mut is_silhouette: impl FnMut(&mut F, EdgeId) -> bool,
    half_edge: HalfEdgeId,
) -> HalfEdgeId {
    let mut candidate = half_edge.next_in_face();
    loop {
        let across = match topology.twin(candidate) {
            Twin::Boundary => return candidate,
            Twin::HalfEdge(twin) if is_front(twin.face()) => twin,
            Twin::HalfEdge(_) => return candidate,
            Twin::NonManifold if is_silhouette(is_front, topology.edge_of(candidate)) => return candidate,
            Twin::NonManifold => next_around_edge(topology, candidate),
        };
        candidate = across.next_in_face();
    }
}

/// The half-edge that follows in the cycle of those at a non-manifold edge.
fn next_around_edge(topology: &Topology, half_edge: HalfEdgeId) -> HalfEdgeId {
    let around = topology.half_edges(topology.edge_of(half_edge));
    let index = around.binary_search(&half_edge).expect("a half-edge is incident to its edge");
    around[(index + 1) % around.len()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use std::cell::Cell;

    /// Pages that share a spine, all front: every walk crosses the spine, and may not look at all pages each time.
    #[test]
    fn work_at_a_non_manifold_edge_is_linear_in_its_faces() {
        let looks = |pages: u32| {
            let positions = (0..pages + 2).map(|i| Vec3::new(i as f32, (i * i % 7) as f32, 1.0)).collect();
            let mesh = TriangleMesh::new(positions, (0..pages).map(|page| [0, 1, page + 2]).collect()).unwrap();
            let topology = Topology::new(&mesh);
            let facings = FaceFacings::from_fn(mesh.face_count(), |_| true);
            let edges = SilhouetteEdges::of(&topology, &facings);
            let (looks, mut loops) = (Cell::new(0), SilhouetteLoops::default());
            let mut is_front = |_| {
                looks.set(looks.get() + 1);
                true
            };
            LoopWalker::default().walk_complete(&topology, &mut is_front, &edges, &mut loops);
            assert_eq!((loops.half_edges().len(), looks.take()), (2 * pages as usize, loops.len()), "a look a loop");
            for (index, &half_edge) in loops.half_edges().iter().enumerate() {
                let is_silhouette = |_: &mut _, edge| edges.contains(edge);
                let next = next_silhouette_half_edge(&topology, &mut is_front, is_silhouette, half_edge);
                assert_eq!(next, loops.half_edges()[(index + 1) % loops.half_edges().len()], "both walks agree");
                looks.set(looks.get() + 1);
            }
            looks.get()
        };
        assert_eq!(looks(2000), 10 * looks(200));
    }

    /// A book of which one page is back: whoever found only the loop of one front page has the spine, but not the edges of
    /// the others. The walk asks facings, so it follows theirs all the same.
    #[test]
    fn part_of_the_edges_is_enough_where_facings_are_known() {
        let positions = (0..7).map(|i| Vec3::new(i as f32, (i * i % 7) as f32, 1.0)).collect();
        let mesh = TriangleMesh::new(positions, (0..5).map(|page| [0, 1, page + 2]).collect()).unwrap();
        let topology = Topology::new(&mesh);
        let facings = FaceFacings::from_fn(mesh.face_count(), |face| face.get() != 2);
        let of_first_page = (0..3).map(|slot| topology.edge_of(HalfEdgeId::of(FaceId::new(0), slot)));
        let (mut some, mut loops) = (SilhouetteEdges::default(), SilhouetteLoops::default());
        some.refill(of_first_page);
        LoopWalker::default().walk(&topology, &facings, &some, &mut loops);
        assert_eq!(loops.len(), 4, "a loop a front page");
        let (all, mut whole) = (SilhouetteEdges::of(&topology, &facings), SilhouetteLoops::default());
        LoopWalker::default().walk_complete(&topology, |face| facings.is_front(face), &all, &mut whole);
        assert_eq!(whole, loops);
    }
}
