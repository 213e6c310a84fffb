//! [`ViewedMesh`]: a mesh as one displaced viewer sees it.

use crate::layers::Layers;
use crate::unpaired::{UnpairedEdges, runs_forward};
use silhouette_core::displaced::Turn;
use silhouette_core::glam::Vec3;
use silhouette_core::{DisplacedViewer, EdgeId, FaceId, Facing, FacingRule, Topology, TriangleMesh};

/// A mesh, what is known of it from everywhere, and the viewer.
#[derive(Debug, Clone, Copy)]
pub struct ViewedMesh<'a> {
    /// The mesh.
    pub mesh: &'a TriangleMesh,
    /// Its topology.
    pub topology: &'a Topology,
    /// Its unpaired edges and flat faces.
    pub unpaired: &'a UnpairedEdges,
    /// Who sees it. All ties are broken as this viewer sees them.
    pub viewer: DisplacedViewer,
}

impl ViewedMesh<'_> {
    /// The vertices of an edge, lower id first, and their positions.
    pub fn ends(&self, edge: EdgeId) -> ([u32; 2], [Vec3; 2]) {
        let vertices = self.topology.edges()[edge];
        (vertices, vertices.map(|vertex| self.position(vertex)))
    }

    /// The position of a vertex.
    #[inline]
    pub fn position(&self, vertex: u32) -> Vec3 {
        self.mesh.positions()[vertex as usize]
    }

    /// The facing of a face; one without area is back.
    #[inline]
    pub fn facing(&self, face: FaceId) -> Facing {
        self.viewer.judge(self.mesh.corners(face)).facing
    }

    /// How the corners of a face turn.
    #[inline]
    pub fn turn(&self, face: FaceId) -> Turn {
        let [a, b, c] = self.mesh.corners(face);
        self.viewer.turn(a, b, c)
    }

    /// What crossing an edge towards its left changes, faces for which `counts` does not hold left out, and faces without
    /// area. A front face lies to the left of its half-edges and a back face to their right. O(faces at the edge).
    pub fn change_to_the_left(&self, edge: EdgeId, counts: impl Fn(FaceId) -> bool) -> Layers {
        let mut change = Layers::NONE;
        for &half_edge in self.topology.half_edges(edge) {
            let face = half_edge.face();
            if counts(face) && !self.unpaired.is_flat(face) {
                let facing = self.facing(face);
                let forward = runs_forward(self.mesh, self.topology, edge, half_edge);
                let lies_left = forward == (facing == Facing::Front);
                change.add(Layers::of(facing), if lies_left { 1 } else { -1 });
            }
        }
        change
    }
}
