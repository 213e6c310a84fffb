//! Building a [`Topology`] by a parallel bucket sort of the half-edges.

use super::{BOUNDARY, NON_MANIFOLD, Topology};
use crate::id::{EdgeId, HalfEdgeId};
use crate::mesh::TriangleMesh;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering};

/// The edges whose lower vertex lies in one range of vertices, in final order; offsets relative to the range.
struct Part {
    edges: Vec<[u32; 2]>,
    /// Number of incident half-edges of each edge.
    counts: Vec<u32>,
    incident: Vec<HalfEdgeId>,
}

pub(super) fn build(mesh: &TriangleMesh) -> Topology {
    let triangles = mesh.triangles();
    let ranges = vertex_ranges(triangles, mesh.vertex_count(), rayon::current_num_threads());
    let parts: Vec<Part> = ranges.into_par_iter().map(|range| sort_range(triangles, range)).collect();

    // Where each part begins among the edges, and among the incident half-edges.
    let begins: Vec<[usize; 2]> = parts
        .iter()
        .scan([0; 2], |end, part| {
            let begin = *end;
            *end = [end[0] + part.edges.len(), end[1] + part.incident.len()];
            Some(begin)
        })
        .collect();

    let half_edge_count = triangles.len() * 3;
    let edge_of = unwritten(half_edge_count);
    let twins = unwritten(half_edge_count);
    let firsts: Vec<Vec<u32>> =
        parts.par_iter().zip(&begins).map(|(part, &begin)| link_half_edges(part, begin, &edge_of, &twins)).collect();

    let mut first = Vec::with_capacity(firsts.iter().map(Vec::len).sum::<usize>() + 1);
    firsts.iter().for_each(|part| first.extend_from_slice(part));
    first.push(half_edge_count as u32);
    let (mut edges, mut incident) = (Vec::with_capacity(first.len() - 1), Vec::with_capacity(half_edge_count));
    for part in parts {
        edges.extend_from_slice(&part.edges);
        incident.extend_from_slice(&part.incident);
    }
    let edge_of: Vec<EdgeId> = edge_of.into_iter().map(|edge| EdgeId::new(edge.into_inner())).collect();
    let twins: Vec<u32> = twins.into_iter().map(AtomicU32::into_inner).collect();
    Topology { edges: edges.into(), first, incident, edge_of: edge_of.into(), twins: twins.into() }
}

/// Scattered writes from several tasks, each half-edge written exactly once: relaxed atomics are plain stores on the
/// machines we know, and keep the code free of `unsafe`.
fn unwritten(count: usize) -> Vec<AtomicU32> {
    (0..count).map(|_| AtomicU32::new(BOUNDARY)).collect()
}

/// Vertices are counted in this many blocks to find ranges of equal work.
const BLOCKS: usize = 1024;

/// Splits the vertices into one range a thread, each the lower vertex of about as many half-edges. (Where neighbours have
/// unrelated ids, three quarters of the lower vertices lie in the lower half of the ids.)
fn vertex_ranges(triangles: &[[u32; 3]], vertices: usize, threads: usize) -> Vec<Range<u32>> {
    if threads < 2 || triangles.len() < BLOCKS {
        return std::iter::once(0..vertices as u32).collect();
    }
    let block = vertices.div_ceil(BLOCKS);
    let count = |mut counts: Vec<usize>, triangles: &[[u32; 3]]| {
        for &[a, b, c] in triangles {
            for lower in [a.min(b), b.min(c), c.min(a)] {
                counts[lower as usize / block] += 1;
            }
        }
        counts
    };
    let chunks = triangles.par_chunks(triangles.len().div_ceil(threads));
    let counts: Vec<Vec<usize>> = chunks.map(|chunk| count(vec![0; BLOCKS], chunk)).collect();

    let mut ranges = Vec::with_capacity(threads);
    let (mut begin, mut seen) = (0, 0);
    for index in 0..BLOCKS {
        seen += counts.iter().map(|chunk| chunk[index]).sum::<usize>();
        let end = ((index + 1) * block).min(vertices) as u32;
        if seen * threads >= (ranges.len() + 1) * triangles.len() * 3 && end > begin {
            ranges.push(begin..end);
            begin = end;
        }
    }
    if begin < vertices as u32 {
        ranges.push(begin..vertices as u32);
    }
    ranges
}

/// Calls `visit(lower vertex, higher vertex, half-edge)` for the half-edges whose lower vertex lies in `range`,
/// ascending.
fn for_each_half_edge(triangles: &[[u32; 3]], range: &Range<u32>, mut visit: impl FnMut(u32, u32, u32)) {
    for (face, &[a, b, c]) in triangles.iter().enumerate() {
        for (slot, (from, to)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
            let lower = from.min(to);
            if range.contains(&lower) {
                visit(lower, from.max(to), (3 * face + slot) as u32);
            }
        }
    }
}

/// Counting sort by lower vertex, then a sort of each vertex's bucket by `(higher vertex, half-edge)`.
fn sort_range(triangles: &[[u32; 3]], range: Range<u32>) -> Part {
    let bucket_of = |lower: u32| (lower - range.start) as usize;
    let mut ends = vec![0_u32; range.len() + 1];
    for_each_half_edge(triangles, &range, |lower, _, _| ends[bucket_of(lower) + 1] += 1);
    for bucket in 1..ends.len() {
        ends[bucket] += ends[bucket - 1];
    }

    // While filling, `ends[b]` is where bucket b continues; afterwards it is where bucket b ends.
    let mut entries = vec![0_u64; ends[range.len()] as usize];
    for_each_half_edge(triangles, &range, |lower, higher, half_edge| {
        let next = &mut ends[bucket_of(lower)];
        entries[*next as usize] = u64::from(higher) << 32 | u64::from(half_edge);
        *next += 1;
    });

    let mut part = Part {
        edges: Vec::with_capacity(entries.len() / 2 + 1),
        counts: Vec::with_capacity(entries.len() / 2 + 1),
        incident: Vec::with_capacity(entries.len()),
    };
    let mut begin = 0;
    for (lower, &end) in range.clone().zip(&ends) {
        let bucket = &mut entries[begin..end as usize];
        begin = end as usize;
        bucket.sort_unstable();
        for same_edge in bucket.chunk_by(|x, y| x >> 32 == y >> 32) {
            part.edges.push([lower, (same_edge[0] >> 32) as u32]);
            part.counts.push(same_edge.len() as u32);
            part.incident.extend(same_edge.iter().map(|&entry| HalfEdgeId::new(entry as u32)));
        }
    }
    part
}

/// Writes edge and twin of every half-edge of a part; yields where each edge's incident half-edges begin.
fn link_half_edges(part: &Part, begin: [usize; 2], edge_of: &[AtomicU32], twins: &[AtomicU32]) -> Vec<u32> {
    let mut offset = 0;
    let mut first = Vec::with_capacity(part.counts.len());
    for (edge, &count) in (begin[0]..).zip(&part.counts) {
        first.push((begin[1] + offset) as u32);
        let half_edges = &part.incident[offset..offset + count as usize];
        offset += count as usize;
        for half_edge in half_edges {
            edge_of[half_edge.index()].store(edge as u32, Ordering::Relaxed);
        }
        match half_edges {
            [_] => {}
            [one, other] => {
                twins[one.index()].store(other.get(), Ordering::Relaxed);
                twins[other.index()].store(one.get(), Ordering::Relaxed);
            }
            more => more.iter().for_each(|half_edge| twins[half_edge.index()].store(NON_MANIFOLD, Ordering::Relaxed)),
        }
    }
    first
}
