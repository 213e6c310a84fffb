//! Patches and components by flood fill, and whether each can be oriented.

use super::Sides;
use crate::disjoint_sets::DisjointSets;
use crate::id::{FaceId, HalfEdgeId, PerFace};
use crate::topology::Twin;

/// The component of each face, and what the flood fill learnt of each.
pub(super) struct Patches {
    /// Components are numbered by their lowest face.
    pub component_of: PerFace<u32>,
    /// Whether the faces of each component can be wound consistently.
    pub is_orientable: Vec<bool>,
}

const UNSEEN: u32 = u32::MAX;

/// Floods across interior edges, carrying whether a face would have to be reversed to agree with the first face of its
/// patch; a face that would have to be both makes the patch non-orientable. Then joins patches that meet in
/// non-manifold edges, across which there is no agreement to ask for. O(F).
pub(super) fn flood(sides: Sides) -> Patches {
    let mut patch_of = PerFace::from(vec![UNSEEN; sides.mesh.face_count()]);
    let mut is_reversed = PerFace::from(vec![false; sides.mesh.face_count()]);
    let mut patch_is_orientable = Vec::new();
    let mut pending = Vec::new();
    for seed in patch_of.ids() {
        if patch_of[seed] != UNSEEN {
            continue;
        }
        let patch = patch_is_orientable.len() as u32;
        let mut is_orientable = true;
        patch_of[seed] = patch;
        pending.push(seed);
        while let Some(face) = pending.pop() {
            for (neighbor, same_direction) in neighbors(sides, face) {
                let reversed = is_reversed[face] != same_direction;
                if patch_of[neighbor] == UNSEEN {
                    patch_of[neighbor] = patch;
                    is_reversed[neighbor] = reversed;
                    pending.push(neighbor);
                } else {
                    is_orientable &= is_reversed[neighbor] == reversed;
                }
            }
        }
        patch_is_orientable.push(is_orientable);
    }
    join(sides, &patch_of, &patch_is_orientable)
}

/// Faces across the interior edges of `face`, with whether the two run along the edge in the same direction.
fn neighbors(sides: Sides, face: FaceId) -> impl Iterator<Item = (FaceId, bool)> {
    (0..3).filter_map(move |slot| {
        let half_edge = HalfEdgeId::of(face, slot);
        let Twin::HalfEdge(twin) = sides.topology.twin(half_edge) else { return None };
        let counts = twin.face() != face && !sides.is_collapsed(sides.topology.edge_of(half_edge));
        counts.then(|| (twin.face(), sides.start(half_edge) == sides.start(twin)))
    })
}

/// Joins patches that share a non-manifold edge and numbers the components.
fn join(sides: Sides, patch_of: &PerFace<u32>, patch_is_orientable: &[bool]) -> Patches {
    let mut sets = DisjointSets::new(patch_is_orientable.len());
    for edge in sides.topology.edges().ids() {
        if sides.topology.half_edges(edge).len() > 2 && !sides.is_collapsed(edge) {
            let mut faces = sides.topology.faces(edge);
            let first = faces.next().map(|face| patch_of[face]);
            for patch in faces.map(|face| patch_of[face]) {
                sets.unite(first.unwrap_or(patch), patch);
            }
        }
    }
    let mut is_orientable: Vec<bool> = Vec::new();
    let mut component_of_patch = vec![0; patch_is_orientable.len()];
    for patch in 0..patch_is_orientable.len() as u32 {
        let leading = sets.find(patch);
        if leading == patch {
            component_of_patch[patch as usize] = is_orientable.len() as u32;
            is_orientable.push(true);
        } else {
            component_of_patch[patch as usize] = component_of_patch[leading as usize];
        }
        is_orientable[component_of_patch[patch as usize] as usize] &= patch_is_orientable[patch as usize];
    }
    let component_of = patch_of.iter().map(|(_, &patch)| component_of_patch[patch as usize]).collect::<Vec<_>>();
    Patches { component_of: component_of.into(), is_orientable }
}
