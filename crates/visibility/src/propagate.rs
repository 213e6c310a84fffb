//! Step 7: layers propagated from stroke to stroke, so that few sight lines need to be cast.
//!
//! Near a vertex, the layers in front of a stroke are those of the faces around the vertex, which are looked at one by one,
//! and those of all others, which are the same for every stroke that ends there, unless a face touches the vertex in space. So
//! spans that meet in a vertex know each other's layers up to a difference. Sets of such spans are formed by union
//! and find, each span holding its difference to the set's first; one sight line in the longest gap of a set then decides
//! it. Exact decisions exclude that two ways around lead to different sums; should they all the same, the set's spans are
//! decided one by one.
//!
//! Appel 1967 ("The notion of quantitative invisibility", ACM National Conference) propagates invisibility along lines and
//! from line to line; the difference at a vertex is his "local" change, here decided by exact predicates for any fan of
//! faces.

use crate::cut::{CutStroke, Cuts};
use crate::gaps::{Gap, spans};
use crate::layers::Layers;
use crate::line_error::LineError;
use crate::sight::Sight;
use crate::stroke::Strokes;
use crate::vertex_faces::VertexFaces;
use rayon::prelude::*;
use silhouette_core::Progress;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

/// Faces that all lines of sight of a view may look at: some ten seconds of work on one core.
const MAX_SIGHT_FACES: u64 = 200_000_000;

/// Seeds that a task takes: some 0.05 ms of work.
const SEEDS_PER_TASK: usize = 16;

/// Strokes times faces at a vertex up to which layers are propagated across it.
const MOST_AT_A_VERTEX: usize = 1 << 16;

/// Vertices that a task takes: some 0.05 ms of work.
const GROUPS_PER_TASK: usize = 64;

/// Places in a gap at which a sight line is tried, as shares of its length, until one is certain.
const TRIALS: [f64; 6] = [0.5, 0.381_966, 0.618_034, 0.723_607, 0.276_393, 0.145_898];

/// A span of gaps: a node of the sets.
struct Span {
    stroke: u32,
    gaps: Range<usize>,
}

/// An end of a drawn stroke at a vertex.
struct StrokeEnd {
    vertex: u32,
    stroke: u32,
    end: usize,
    span: u32,
    /// Layers near the end, beyond those of the span's first gap.
    offset: Layers,
    touched: bool,
}

/// What decides the layers of all gaps.
pub struct Propagation<'a> {
    /// The strokes.
    pub strokes: &'a Strokes,
    /// Casts sight lines.
    pub sight: Sight<'a>,
    /// Faces around vertices.
    pub vertex_faces: &'a VertexFaces,
}

impl Propagation<'_> {
    /// The layers in front of each gap, and the number of sight lines that were cast. Layers of an empty gap may mean
    /// nothing.
    ///
    /// O(gaps + faces around the ends of strokes + log F per sight line), parallel.
    ///
    /// # Errors
    /// [`LineError`].
    pub fn decide(
        &self,
        Cuts { strokes, gaps, .. }: &Cuts,
        progress: &dyn Progress,
    ) -> Result<(Vec<Layers>, u64), LineError> {
        let (all_spans, ends) = self.spans_and_ends(strokes, gaps);
        let mut sets = Sets::new(all_spans.len());
        for (one, other, difference) in self.differences(&ends) {
            sets.unite(one, other, difference);
        }
        let seeds = seeds(&all_spans, gaps, &mut sets);
        progress.stage("lines of sight", seeds.len() as u64);
        let faces = AtomicU64::new(0);
        let look_at = |seeds: &[Seed]| {
            if faces.load(Ordering::Relaxed) > MAX_SIGHT_FACES {
                return Err(LineError::TooCrowded);
            }
            progress.check()?;
            let looked: Vec<Looked> = seeds.iter().map(|seed| self.look(&all_spans, gaps, seed)).collect();
            faces.fetch_add(looked.iter().map(|looked| looked.faces).sum(), Ordering::Relaxed);
            progress.advance(seeds.len() as u64);
            Ok(looked)
        };
        let seen: Result<Vec<Vec<Looked>>, LineError> = seeds.par_chunks(SEEDS_PER_TASK).map(look_at).collect();
        let seen: Vec<Looked> = seen?.into_iter().flatten().collect();
        if faces.into_inner() > MAX_SIGHT_FACES {
            return Err(LineError::TooCrowded);
        }
        let mut of_root = vec![Layers::NONE; all_spans.len()];
        for (seed, looked) in seeds.iter().zip(&seen) {
            of_root[seed.root as usize] = looked.layers;
            of_root[seed.root as usize].add(seed.offset, -1);
        }
        let mut layers = vec![Layers::NONE; gaps.len()];
        for (index, span) in all_spans.iter().enumerate() {
            let (root, offset) = sets.root_for_decision(index as u32);
            for gap in span.gaps.clone() {
                let mut sum = of_root[root as usize];
                sum.add(offset, 1);
                sum.add(gaps[gap].offset, 1);
                layers[gap] = sum;
            }
        }
        Ok((layers, seen.iter().map(|looked| looked.sight_lines).sum()))
    }

    fn spans_and_ends(&self, cut: &[CutStroke], gaps: &[Gap]) -> (Vec<Span>, Vec<StrokeEnd>) {
        let (mut all_spans, mut ends) = (Vec::with_capacity(cut.len()), Vec::with_capacity(2 * cut.len()));
        for CutStroke { stroke, gaps: own, range, touched } in cut {
            let first = all_spans.len();
            let of_stroke = &gaps[own.clone()];
            all_spans.extend(
                spans(of_stroke)
                    .map(|span| Span { stroke: *stroke, gaps: own.start + span.start..own.start + span.end }),
            );
            let last = all_spans.len() - 1;
            let vertices = self.strokes.strokes[*stroke as usize].vertices;
            let reaches = [range[0] <= 0.0, range[1] >= 1.0];
            let at_ends = [(first, Layers::NONE), (last, of_stroke[of_stroke.len() - 1].offset)];
            for (end, (span, offset)) in at_ends.into_iter().enumerate() {
                if reaches[end] && (vertices[end] as usize) < self.sight.view.mesh.vertex_count() {
                    let (vertex, touched) = (vertices[end], touched[end]);
                    ends.push(StrokeEnd { vertex, stroke: *stroke, end, span: span as u32, offset, touched });
                }
            }
        }
        (all_spans, ends)
    }

    /// Spans that meet in a vertex, and the layers of the second's first gap beyond those of the first's. Where very many
    /// strokes and faces meet, as at the apex of a fine cone, nothing is propagated, and each stroke has a line of sight of its
    /// own.
    fn differences(&self, ends: &[StrokeEnd]) -> Vec<(u32, u32, Layers)> {
        let mut order: Vec<(u32, u32)> = ends.iter().zip(0..).map(|(end, index)| (end.vertex, index)).collect();
        order.par_sort_unstable();
        let end = |&(_, index): &(u32, u32)| &ends[index as usize];
        let groups: Vec<&[(u32, u32)]> = order
            .chunk_by(|one, other| one.0 == other.0)
            .filter(|group| group.len() > 1 && !group.iter().any(|at| end(at).touched))
            .filter(|group| group.len() * self.vertex_faces.of(group[0].0).len() <= MOST_AT_A_VERTEX)
            .collect();
        let of_task = |groups: &[&[(u32, u32)]]| {
            let mut found = Vec::with_capacity(groups.len());
            for (first, others) in groups.iter().filter_map(|group| group.split_first()) {
                let (first, rest) = (end(first), self.rest_at(end(first)));
                for other in others.iter().map(end) {
                    let mut difference = rest;
                    difference.add(self.rest_at(other), -1);
                    found.push((first.span, other.span, difference));
                }
            }
            found
        };
        let found: Vec<Vec<(u32, u32, Layers)>> = groups.par_chunks(GROUPS_PER_TASK).map(of_task).collect();
        found.concat()
    }

    /// The layers in front of a stroke just inside of an end without those of the faces around the vertex, beyond the layers
    /// of the span's first gap: what all strokes that end there have in common.
    fn rest_at(&self, end: &StrokeEnd) -> Layers {
        let stroke = &self.strokes.strokes[end.stroke as usize];
        let own = self.strokes.own_faces(stroke);
        let faces = self.vertex_faces.of(end.vertex);
        let mut rest = end.offset;
        rest.add(self.sight.layers_near_end(stroke, end.end, faces, |face| own.contains(face)), -1);
        rest
    }

    /// The layers in front of the gap that a seed names.
    fn look(&self, all_spans: &[Span], gaps: &[Gap], seed: &Seed) -> Looked {
        let stroke = &self.strokes.strokes[all_spans[seed.span as usize].stroke as usize];
        let own = self.strokes.own_faces(stroke);
        let range = gaps[seed.gap].range;
        let mut looked = Looked { layers: Layers::NONE, sight_lines: 0, faces: 0 };
        for share in TRIALS {
            let t = range[0] + (range[1] - range[0]) * share;
            let seen = self.sight.look(stroke, t, |face| own.contains(face));
            looked.layers = seen.layers;
            looked.sight_lines += 1;
            looked.faces += seen.faces;
            if seen.certain {
                break;
            }
        }
        looked
    }
}

/// What lines of sight to one gap yield.
struct Looked {
    layers: Layers,
    sight_lines: u64,
    faces: u64,
}

/// Where a set is decided.
struct Seed {
    root: u32,
    span: u32,
    gap: usize,
    /// Layers of that gap beyond those of the root's first gap.
    offset: Layers,
}

/// For each set its longest gap; sets without a gap of any length have none.
fn seeds(all_spans: &[Span], gaps: &[Gap], sets: &mut Sets) -> Vec<Seed> {
    let mut best: Vec<Option<(f64, Seed)>> = Vec::new();
    best.resize_with(all_spans.len(), || None);
    for (index, span) in all_spans.iter().enumerate() {
        let (root, offset) = sets.root_for_decision(index as u32);
        for gap in span.gaps.clone() {
            let length = gaps[gap].length();
            if length > best[root as usize].as_ref().map_or(0.0, |(longest, _)| *longest) {
                let mut offset = offset;
                offset.add(gaps[gap].offset, 1);
                best[root as usize] = Some((length, Seed { root, span: index as u32, gap, offset }));
            }
        }
    }
    best.into_iter().flatten().map(|(_, seed)| seed).collect()
}

/// Union and find over spans, each with its layers beyond those of its parent.
struct Sets {
    parent: Vec<(u32, Layers)>,
    /// For each root, whether two ways lead to different sums.
    contradicted: Vec<bool>,
}

impl Sets {
    fn new(count: usize) -> Self {
        Self {
            parent: (0..count as u32).map(|index| (index, Layers::NONE)).collect(),
            contradicted: vec![false; count],
        }
    }

    /// The root of a span's set, and the span's layers beyond those of the root.
    fn root(&mut self, span: u32) -> (u32, Layers) {
        let (mut at, mut sum) = (span, Layers::NONE);
        while self.parent[at as usize].0 != at {
            // Halve the path: each span on it is hung to its grandparent.
            let (parent, mut offset) = self.parent[at as usize];
            let (grandparent, more) = self.parent[parent as usize];
            offset.add(more, 1);
            self.parent[at as usize] = (grandparent, offset);
            sum.add(offset, 1);
            at = grandparent;
        }
        (at, sum)
    }

    /// The same, each span of a contradicted set being a set of its own.
    fn root_for_decision(&mut self, span: u32) -> (u32, Layers) {
        let (root, offset) = self.root(span);
        if self.contradicted[root as usize] { (span, Layers::NONE) } else { (root, offset) }
    }

    /// Notes that `other` has `difference` more layers than `one`.
    fn unite(&mut self, one: u32, other: u32, difference: Layers) {
        let ((root, offset), (other_root, other_offset)) = (self.root(one), self.root(other));
        // offset + difference = other_offset + what the other root has beyond this one.
        let mut beyond = offset;
        beyond.add(difference, 1);
        beyond.add(other_offset, -1);
        if root == other_root {
            self.contradicted[root as usize] |= beyond != Layers::NONE;
            return;
        }
        self.contradicted[root as usize] |= self.contradicted[other_root as usize];
        self.parent[other_root as usize] = (root, beyond);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layers(front: i32) -> Layers {
        Layers { front, back: 0 }
    }

    #[test]
    fn differences_add_up_along_any_way() {
        let mut sets = Sets::new(6);
        sets.unite(0, 1, layers(1));
        sets.unite(2, 3, layers(2));
        sets.unite(1, 2, layers(-5));
        sets.unite(4, 3, layers(7));
        let relative = |sets: &mut Sets, span| {
            let ((root, here), (first_root, first)) = (sets.root(span), sets.root(0));
            assert_eq!(root, first_root);
            here.front - first.front
        };
        assert_eq!([1, 2, 3, 4].map(|span| relative(&mut sets, span)), [1, -4, -2, -9]);
        assert_eq!(sets.root(5), (5, layers(0)));
        sets.unite(0, 3, layers(-2));
        assert!(!sets.contradicted.contains(&true));
        sets.unite(0, 3, layers(-1));
        assert_eq!(sets.root_for_decision(3), (3, layers(0)), "each is decided alone");
    }
}
