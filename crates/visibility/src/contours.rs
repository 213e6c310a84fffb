//! Step 1: the contours of a view, edges where the number of surface layers changes in the picture.
//!
//! Seen from the viewer, crossing the projection of an edge enters those of its faces that lie on the far side and leaves
//! those on the near side. Where as many are entered as left, nothing changes. What remains are silhouette edges, boundary
//! edges, and those edges of non-manifold or inconsistently wound places that do not balance. The displaced viewer sees no
//! face edge-on, so the changes add up to 0 around every point of the picture.

use crate::layers::Layers;
use crate::unpaired::runs_forward;
use crate::viewed_mesh::ViewedMesh;
use rayon::prelude::*;
use silhouette_core::glam::Vec3;
use silhouette_core::{EdgeId, Facing, SilhouetteEdges};

/// An edge across which the number of layers changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contour {
    /// The edge.
    pub edge: EdgeId,
    /// Its vertices, lower id first.
    pub vertices: [u32; 2],
    /// Their positions.
    pub ends: [Vec3; 2],
    /// Change of layers on crossing it towards the left, looking from the first end to the second.
    pub to_the_left: Layers,
}

/// Edges that a task takes: some 0.05 ms of work.
pub const EDGES_PER_TASK: usize = 256;

impl ViewedMesh<'_> {
    /// All contours: of the silhouette, which must be complete, and of the unpaired edges. Ascending by edge.
    /// O(S + unpaired edges), parallel.
    pub fn contours(&self, silhouette: &SilhouetteEdges) -> Vec<Contour> {
        // Both lists ascend.
        let mut unpaired = self.unpaired.as_slice();
        let mut candidates = Vec::with_capacity(silhouette.len() + unpaired.len());
        for edge in silhouette.iter() {
            while let Some((&first, rest)) = unpaired.split_first().filter(|(first, _)| **first < edge) {
                candidates.push((first, false));
                unpaired = rest;
            }
            let is_paired = unpaired.first() != Some(&edge);
            candidates.push((edge, is_paired));
            unpaired = if is_paired { unpaired } else { &unpaired[1..] };
        }
        candidates.extend(unpaired.iter().map(|&edge| (edge, false)));
        let contour = |&(edge, is_paired): &(EdgeId, bool)| self.contour(edge, is_paired);
        candidates.par_iter().with_min_len(EDGES_PER_TASK).filter_map(contour).collect()
    }

    /// The contour of an edge: of the silhouette if it is paired.
    fn contour(&self, edge: EdgeId, is_paired: bool) -> Option<Contour> {
        let (vertices, ends) = self.ends(edge);
        let to_the_left = if is_paired { self.fold(edge) } else { self.change_to_the_left(edge, |_| true) };
        (to_the_left != Layers::NONE && ends[0] != ends[1]).then_some(Contour { edge, vertices, ends, to_the_left })
    }

    /// The change at a paired silhouette edge: its faces lie on one side, one of either facing, so that one tells of both.
    fn fold(&self, edge: EdgeId) -> Layers {
        let half_edge = self.topology.half_edges(edge)[0];
        let is_front = self.facing(half_edge.face()) == Facing::Front;
        let lies_left = runs_forward(self.mesh, self.topology, edge, half_edge) == is_front;
        Layers { front: 1, back: 1 }.times(if lies_left { 1 } else { -1 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unpaired::UnpairedEdges;
    use silhouette_core::{DisplacedViewer, FaceFacings, Topology, TriangleMesh, Viewpoint};

    fn contours(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Vec<(EdgeId, Layers)> {
        let mesh = TriangleMesh::new(positions, triangles).unwrap();
        let topology = Topology::new(&mesh);
        let unpaired = UnpairedEdges::new(&mesh, &topology);
        let viewer = DisplacedViewer::of_mesh(Viewpoint::Orthographic { toward_viewer: Vec3::Z }, &mesh);
        let silhouette = SilhouetteEdges::of(&topology, &FaceFacings::new(&mesh, &viewer));
        let viewed = ViewedMesh { mesh: &mesh, topology: &topology, unpaired: &unpaired, viewer };
        viewed.contours(&silhouette).iter().map(|contour| (contour.edge, contour.to_the_left)).collect()
    }

    const LEFT: [Vec3; 4] = [Vec3::ZERO, Vec3::X, Vec3::new(0.3, 1.0, 0.0), Vec3::new(0.6, 1.0, -1.0)];

    #[test]
    fn a_fold_changes_both_numbers_and_a_flat_edge_none() {
        let fold = contours(LEFT.to_vec(), vec![[0, 1, 2], [1, 0, 3]]);
        let on_edge_0 = fold.iter().find(|(edge, _)| edge.index() == 0).unwrap();
        assert_eq!(on_edge_0.1, Layers { front: 1, back: 1 }, "both faces lie to the left of 0 -> 1");
        assert_eq!(fold.len(), 5, "the fold and four boundary edges, of the back face too");

        let mut flat = LEFT.to_vec();
        flat[3] = Vec3::new(0.5, -1.0, 0.0);
        let flat = contours(flat, vec![[0, 1, 2], [1, 0, 3]]);
        assert!(flat.len() == 4 && flat.iter().all(|(edge, _)| edge.index() != 0), "{flat:?}");
    }

    #[test]
    fn faces_wound_against_each_other_make_a_contour_of_equal_facings() {
        let fold = contours(LEFT.to_vec(), vec![[0, 1, 2], [0, 1, 3]]);
        assert_eq!(fold[0], (EdgeId::new(0), Layers { front: 2, back: 0 }));
    }

    #[test]
    fn a_face_seen_edge_on_has_a_facing_and_one_without_area_has_none() {
        // The second face stands upright on the edge 0-1, towards the viewer: its contours are its two other edges.
        let mut upright = LEFT.to_vec();
        upright[3] = Vec3::new(0.5, 0.0, 1.0);
        let of_upright = contours(upright, vec![[0, 1, 2], [1, 0, 3]]);
        assert!(matches!(of_upright.len(), 4 | 5), "{of_upright:?}");
        // On the line of the edge it is as if it was not there.
        let mut flat = LEFT.to_vec();
        flat[3] = Vec3::new(0.5, 0.0, 0.0);
        assert_eq!(contours(flat, vec![[0, 1, 2], [1, 0, 3]]).len(), 3);
    }
}
