//! The fans of faces around each vertex: a surface is a manifold at a vertex with one fan, pinched at one with more.

use super::Sides;
use crate::disjoint_sets::DisjointSets;
use crate::id::{EdgeId, FaceId, HalfEdgeId, PerVertex, VertexId};
use rayon::prelude::*;

/// A vertex whose faces form several fans.
pub(super) struct Pinch {
    pub vertex: VertexId,
    /// The lowest face of each fan.
    pub fans: Vec<FaceId>,
}

/// Some face at each vertex (`None` for unreferenced ones), and the vertices with several fans in the order of their ids.
pub(super) struct Fans {
    pub some_face: PerVertex<Option<FaceId>>,
    pub pinches: Vec<Pinch>,
}

/// Groups the corners at each vertex by shared edges. O(F log d).
pub(super) fn find(sides: Sides) -> Fans {
    let corners = Corners::new(sides);
    let vertices = sides.mesh.vertex_count() as u32;
    let pinches = (0..vertices)
        .into_par_iter()
        .map(VertexId::new)
        .map_init(Scratch::default, |scratch, vertex| {
            let fans = scratch.fans(sides, corners.at(vertex));
            (fans.len() > 1).then(|| Pinch { vertex, fans: fans.to_vec() })
        })
        .flatten_iter()
        .collect();
    let some_face = |vertex| corners.at(VertexId::new(vertex)).first().map(|corner| corner.face());
    Fans { some_face: (0..vertices).map(some_face).collect::<Vec<_>>().into(), pinches }
}

/// The corners at each vertex, a corner being named by the half-edge that leaves it.
struct Corners {
    first: Vec<u32>,
    corners: Vec<HalfEdgeId>,
}

impl Corners {
    /// Counting sort by vertex, stable in the half-edge ids.
    fn new(sides: Sides) -> Self {
        let triangles = sides.mesh.triangles();
        let mut first = vec![0_u32; sides.mesh.vertex_count() + 1];
        for &vertex in triangles.iter().flatten() {
            first[vertex as usize + 1] += 1;
        }
        for i in 1..first.len() {
            first[i] += first[i - 1];
        }
        let mut next = first.clone();
        let mut corners = vec![HalfEdgeId::new(0); 3 * triangles.len()];
        for (half_edge, &vertex) in triangles.iter().flatten().enumerate() {
            corners[next[vertex as usize] as usize] = HalfEdgeId::from_usize(half_edge);
            next[vertex as usize] += 1;
        }
        Self { first, corners }
    }

    fn at(&self, vertex: VertexId) -> &[HalfEdgeId] {
        &self.corners[self.first[vertex.index()] as usize..self.first[vertex.index() + 1] as usize]
    }
}

#[derive(Default)]
struct Scratch {
    /// The two edges of each corner with the corner's rank.
    spokes: Vec<(EdgeId, u32)>,
    sets: DisjointSets,
    fans: Vec<FaceId>,
}

impl Scratch {
    /// The lowest face of each fan, ascending, given the corners at a vertex in ascending order.
    fn fans(&mut self, sides: Sides, corners: &[HalfEdgeId]) -> &[FaceId] {
        self.spokes.clear();
        for (rank, &corner) in corners.iter().enumerate() {
            let arriving = corner.next_in_face().next_in_face();
            for edge in [corner, arriving].map(|half_edge| sides.topology.edge_of(half_edge)) {
                if !sides.is_collapsed(edge) {
                    self.spokes.push((edge, rank as u32));
                }
            }
        }
        self.spokes.sort_unstable();
        self.sets.reset(corners.len());
        for pair in self.spokes.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
            self.sets.unite(pair[0].1, pair[1].1);
        }
        // A face that names the vertex twice has two corners here, but is in one fan.
        for rank in 1..corners.len() {
            if corners[rank].face() == corners[rank - 1].face() {
                self.sets.unite(rank as u32 - 1, rank as u32);
            }
        }
        self.fans.clear();
        for (rank, corner) in corners.iter().enumerate() {
            if self.sets.find(rank as u32) == rank as u32 {
                self.fans.push(corner.face());
            }
        }
        &self.fans
    }
}
