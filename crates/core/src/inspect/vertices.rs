//! Vertices that nothing uses or that lie on one another.

use super::fans::Fans;
use crate::id::VertexId;
use crate::mesh::TriangleMesh;
use rayon::prelude::*;

/// Vertices that no face names, ascending. O(V).
pub(super) fn unreferenced(fans: &Fans) -> Vec<VertexId> {
    fans.some_face.iter().filter(|(_, face)| face.is_none()).map(|(vertex, _)| vertex).collect()
}

/// Groups of vertices at equal positions (0.0 and -0.0 are equal), unreferenced ones included. Groups by their lowest
/// vertex, vertices ascending. O(V log V).
pub(super) fn duplicates(mesh: &TriangleMesh) -> Vec<Vec<VertexId>> {
    // Adding 0.0 turns -0.0 into 0.0, after which equal floats have equal bits.
    let key = |vertex: usize| (mesh.positions()[vertex].to_array().map(|x| (x + 0.0).to_bits()), vertex as u32);
    let mut keys: Vec<([u32; 3], u32)> = (0..mesh.vertex_count()).into_par_iter().map(key).collect();
    keys.par_sort_unstable();
    let same_position = keys.chunk_by(|one, other| one.0 == other.0).filter(|group| group.len() > 1);
    let mut groups: Vec<Vec<VertexId>> =
        same_position.map(|group| group.iter().map(|&(_, vertex)| VertexId::new(vertex)).collect()).collect();
    groups.par_sort_unstable_by_key(|group| group[0]);
    groups
}
