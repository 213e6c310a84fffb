//! [`InwardSolids`]: closed surfaces whose faces are wound so that their outer side is inside.

use crate::unpaired::UnpairedEdges;
use silhouette_core::glam::DVec3;
use silhouette_core::{DisjointSets, EdgeId, FaceId, Topology, TriangleMesh};

/// Which faces belong to a closed, consistently wound surface that encloses a negative volume.
pub struct InwardSolids {
    component_of: Vec<u32>,
    is_inward: Vec<bool>,
}

impl InwardSolids {
    /// Finds them. O(F + E), in one thread, so that sums have one order.
    pub fn new(mesh: &TriangleMesh, topology: &Topology, unpaired: &UnpairedEdges) -> Self {
        let mut sets = DisjointSets::new(mesh.face_count());
        let mut unpaired_edges = unpaired.as_slice().iter().peekable();
        let is_paired = |edge: EdgeId| unpaired_edges.next_if(|&&unpaired| unpaired == edge).is_none();
        let edges: Vec<EdgeId> = topology.edges().ids().collect();
        let paired: Vec<bool> = edges.iter().copied().map(is_paired).collect();
        for (&edge, _) in edges.iter().zip(&paired).filter(|(_, paired)| **paired) {
            let [one, other] = [0, 1].map(|at| topology.half_edges(edge)[at].face().get());
            sets.unite(one, other);
        }
        let component_of: Vec<u32> = (0..mesh.face_count() as u32).map(|face| sets.find(face)).collect();
        let mut is_closed = vec![true; mesh.face_count()];
        for (&edge, _) in edges.iter().zip(&paired).filter(|(_, paired)| !**paired) {
            topology.faces(edge).for_each(|face| is_closed[component_of[face.index()] as usize] = false);
        }
        let mut sixfold_volume = vec![0.0; mesh.face_count()];
        for face in (0..mesh.face_count()).map(FaceId::from_usize) {
            let component = component_of[face.index()];
            // About a corner of the component, not about the origin, which may be far away.
            let origin = mesh.corners(FaceId::new(component))[0].as_dvec3();
            let [a, b, c]: [DVec3; 3] = mesh.corners(face).map(|corner| corner.as_dvec3() - origin);
            sixfold_volume[component as usize] += a.cross(b).dot(c);
        }
        let is_inward =
            is_closed.into_iter().zip(sixfold_volume).map(|(closed, volume)| closed && volume < 0.0).collect();
        Self { component_of, is_inward }
    }

    /// Whether a face is of such a surface.
    pub fn contains(&self, face: FaceId) -> bool {
        self.is_inward[self.component_of[face.index()] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::shapes;

    #[test]
    fn only_whole_solids_are_inward() {
        let cube = shapes::by_name("cube").unwrap();
        let turned = |count: usize, kept: usize| {
            let turn = |(face, &[a, b, c]): (usize, &[u32; 3])| if face < count { [a, c, b] } else { [a, b, c] };
            let triangles = cube.triangles().iter().enumerate().map(turn).take(kept).collect();
            let mesh = TriangleMesh::new(cube.positions().to_vec(), triangles).unwrap();
            let topology = Topology::new(&mesh);
            let found = InwardSolids::new(&mesh, &topology, &UnpairedEdges::new(&mesh, &topology));
            (0..kept).filter(|&face| found.contains(FaceId::from_usize(face))).count()
        };
        assert_eq!([turned(0, 12), turned(12, 12), turned(5, 12), turned(12, 11)], [0, 12, 0, 0]);
    }
}
