//! Edges at which an OBJ file says that the surface is sharp: between smoothing groups (`s`) and along line elements (`l`).

use super::polygon::sides;
use rayon::slice::ParallelSliceMut as _;
use std::collections::HashSet;

/// The smoothing group of faces that are shaded flat, and of those that stand before the first `s`.
const FLAT: u32 = 0;

/// What a file says about sharp edges, collected while it is read.
#[derive(Default)]
pub(super) struct FeatureEdges {
    /// The smoothing group that holds for the faces to come.
    group: u32,
    runs: Vec<Run>,
    /// Pairs of vertices that lines join, lower first; they need not be edges of the mesh.
    lines: HashSet<[u32; 2]>,
}

/// Successive polygons of one smoothing group with equally many corners.
struct Run {
    /// The first triangle of the first polygon.
    first: usize,
    /// Triangles per polygon, at least one.
    per_polygon: usize,
    group: u32,
}

impl FeatureEdges {
    /// Reads what an `s` row names. Anything but `off` and a number from 0 is passed over.
    pub(super) fn begin_group(&mut self, name: &[u8]) {
        let number = || std::str::from_utf8(name).ok()?.parse().ok();
        if let Some(group) = if name == b"off" { Some(FLAT) } else { number() } {
            self.group = group;
        }
    }

    /// Takes a polygon that has become the triangles from `first` on, as many as `triangles`.
    pub(super) fn polygon(&mut self, first: usize, triangles: usize) {
        let continues = |run: &Run| run.group == self.group && run.per_polygon == triangles;
        if !self.runs.last().is_some_and(continues) {
            self.runs.push(Run { first, per_polygon: triangles, group: self.group });
        }
    }

    /// Takes a piece of a line.
    pub(super) fn line(&mut self, a: u32, b: u32) {
        self.lines.insert([a.min(b), a.max(b)]);
    }

    /// The sharp edges of the mesh that has become of the file, as pairs of vertices, lower first, sorted, each once.
    ///
    /// An edge is sharp
    /// - where polygons of different smoothing groups meet,
    /// - if it is a side of a polygon of group 0, which is shaded flat; a diagonal that cuts a polygon into triangles is
    ///   no side,
    /// - if a line element runs along it.
    ///
    /// Groups count only if they distinguish polygons: a file whose polygons are all in one group, be it 0, says nothing
    /// by it.
    ///
    /// O(F) without groups, otherwise O(F log F).
    pub(super) fn of_mesh(self, triangles: &[[u32; 3]]) -> Vec<[u32; 2]> {
        let mut edges = Vec::new();
        if self.runs.iter().any(|run| run.group != self.runs[0].group) {
            edges = self.between_groups(triangles);
        }
        if !self.lines.is_empty() {
            let sides = triangles.iter().flat_map(|&triangle| sides(triangle));
            edges.extend(sides.filter(|side| self.lines.contains(side)));
        }
        // A face may name a vertex twice.
        edges.retain(|[a, b]| a != b);
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    /// The sides of polygons that their smoothing groups make sharp.
    fn between_groups(&self, triangles: &[[u32; 3]]) -> Vec<[u32; 2]> {
        let mut grouped: Vec<([u32; 2], u32)> = Vec::new();
        let ends = self.runs.iter().skip(1).map(|run| run.first).chain([triangles.len()]);
        for (run, end) in self.runs.iter().zip(ends) {
            for polygon in triangles[run.first..end].chunks(run.per_polygon) {
                if is_fan(polygon) {
                    grouped.extend(sides_of_fan(polygon).map(|side| (side, run.group)));
                } else {
                    grouped.extend(unshared_sides(polygon).map(|side| (side, run.group)));
                }
            }
        }
        grouped.par_sort_unstable();
        let is_sharp = |at_edge: &&[([u32; 2], u32)]| {
            let ([(_, lowest), ..], [.., (_, highest)]) = (at_edge, at_edge) else { return false };
            *lowest == FLAT || lowest != highest
        };
        grouped.chunk_by(|a, b| a.0 == b.0).filter(is_sharp).map(|at_edge| at_edge[0].0).collect()
    }
}

/// Whether triangles are the fan of a polygon, as they are unless it is concave.
fn is_fan(polygon: &[[u32; 3]]) -> bool {
    polygon.windows(2).all(|pair| pair[0][0] == pair[1][0] && pair[0][2] == pair[1][1])
}

/// The sides that belong to one triangle of a polygon only: its own, whichever way it was cut into triangles.
fn unshared_sides(polygon: &[[u32; 3]]) -> impl Iterator<Item = [u32; 2]> {
    let mut all: Vec<_> = polygon.iter().flat_map(|&triangle| sides(triangle)).collect();
    all.sort_unstable();
    let unshared: Vec<_> = all.chunk_by(|a, b| a == b).filter(|equal| equal.len() == 1).map(|equal| equal[0]).collect();
    unshared.into_iter()
}

/// The sides of a polygon that has been fanned into these triangles, without its diagonals.
fn sides_of_fan(fan: &[[u32; 3]]) -> impl Iterator<Item = [u32; 2]> {
    let last = fan.len() - 1;
    fan.iter().enumerate().flat_map(move |(rank, &triangle)| {
        let is_side = [rank == 0, true, rank == last];
        sides(triangle).zip(is_side).filter(|&(_, is_side)| is_side).map(|(side, _)| side)
    })
}
