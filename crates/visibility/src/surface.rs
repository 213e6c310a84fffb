//! The surface beside an edge: its faces as half-planes, and which of them the edge belongs to in a tie.

use crate::viewed_mesh::ViewedMesh;
use silhouette_core::glam::Vec3;
use silhouette_core::orientation::orientation;
use silhouette_core::{EdgeId, FaceId, HalfEdgeId, Topology, TriangleMesh};
use std::cmp::Ordering;

/// A face at an edge: the half-plane from the edge through the corner that the edge does not have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wing {
    /// The face.
    pub face: FaceId,
    /// Its half-edge there.
    pub half_edge: HalfEdgeId,
    /// The corner.
    pub apex: Vec3,
}

/// Faces without area that are followed one after another, at most.
const MOST_FLAT_FACES: u32 = 8;

/// Most faces visited across faces without area per edge. Where such faces are listed many times, the paths across them
/// multiply.
const MOST_ACROSS: u32 = 1 << 16;

/// Visits the wings of an edge, in the order of its half-edges. A face without area is none: the surface goes on across the
/// longest of its edges, which the other two cover. O(faces at the edge), and across those without area.
pub fn for_each_wing(
    mesh: &TriangleMesh,
    topology: &Topology,
    is_flat: &dyn Fn(FaceId) -> bool,
    edge: EdgeId,
    visit: &mut dyn FnMut(Wing),
) {
    let mut across = Across { mesh, topology, is_flat, left: MOST_ACROSS };
    for &half_edge in topology.half_edges(edge) {
        across.follow(half_edge, MOST_FLAT_FACES, visit);
    }
}

/// Finds wings across faces without area.
struct Across<'a> {
    mesh: &'a TriangleMesh,
    topology: &'a Topology,
    is_flat: &'a dyn Fn(FaceId) -> bool,
    /// Faces that may still be visited.
    left: u32,
}

impl Across<'_> {
    fn follow(&mut self, half_edge: HalfEdgeId, most: u32, visit: &mut dyn FnMut(Wing)) {
        let face = half_edge.face();
        if !(self.is_flat)(face) {
            let apex = self.mesh.corners(face)[(half_edge.slot() as usize + 2) % 3];
            visit(Wing { face, half_edge, apex });
            return;
        }
        let across = self.topology.edge_of(longest_side(self.mesh, face));
        if most == 0 || across == self.topology.edge_of(half_edge) {
            return;
        }
        for &other in self.topology.half_edges(across).iter().filter(|other| other.face() != face) {
            if self.left == 0 {
                return;
            }
            self.left -= 1;
            self.follow(other, most - 1, visit);
        }
    }
}

/// The longest side of a face, of equal ones that of the lowest slot.
pub fn longest_side(mesh: &TriangleMesh, face: FaceId) -> HalfEdgeId {
    let corners = mesh.corners(face).map(Vec3::as_dvec3);
    let length = |slot: usize| corners[slot].distance_squared(corners[(slot + 1) % 3]);
    let longest = (1..3).fold(0, |longest, slot| if length(slot) > length(longest) { slot } else { longest });
    HalfEdgeId::of(face, longest as u32)
}

impl ViewedMesh<'_> {
    /// Visits the wings of an edge.
    pub fn for_each_wing(&self, edge: EdgeId, mut visit: impl FnMut(Wing)) {
        for_each_wing(self.mesh, self.topology, &|face| self.unpaired.is_flat(face), edge, &mut visit);
    }

    /// How many wings an edge has to its left and to its right, looking from its lower vertex to the higher one.
    pub fn wings_beside(&self, edge: EdgeId) -> [u32; 2] {
        let (_, [a, b]) = self.ends(edge);
        let mut beside = [0; 2];
        self.for_each_wing(edge, |wing| {
            beside[usize::from(self.viewer.turn(a, b, wing.apex).sign() < 0)] += 1;
        });
        beside
    }

    /// The apex of the wing that an edge belongs to: where something touches the edge in space, the edge is as visible as
    /// this wing close to it. It is the nearest on the side with more wings; of sides with equally many, the one to the
    /// left looking from the end that comes first by its coordinates, so that no number of a vertex or face decides. `None`
    /// for an edge without wings. O(square of the faces at the edge).
    pub fn surface_at(&self, edge: EdgeId) -> Option<Vec3> {
        let (_, ends) = self.ends(edge);
        let is_before =
            |one: Vec3, other: Vec3| one.to_array().partial_cmp(&other.to_array()).is_some_and(Ordering::is_lt);
        let [a, b] = if is_before(ends[1], ends[0]) { [ends[1], ends[0]] } else { ends };
        let mut beside: [Vec<Vec3>; 2] = Default::default();
        self.for_each_wing(edge, |wing| {
            beside[usize::from(self.viewer.turn(a, b, wing.apex).sign() < 0)].push(wing.apex);
        });
        let [left, right] = &beside;
        let (wings, facing) = if left.len() >= right.len() { (left, 1.0) } else { (right, -1.0) };
        // The plane through a wing on the left has the viewer above it.
        let is_nearer = |one: Vec3, than: Vec3| orientation(a, b, than, one) * facing > 0.0;
        wings.iter().copied().reduce(|nearest, wing| if is_nearer(wing, nearest) { wing } else { nearest })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unpaired::UnpairedEdges;
    use silhouette_core::{DisplacedViewer, VertexId, Viewpoint};

    /// A flat square of which one triangle has a vertex in the middle of its diagonal, filled by a face without area.
    fn with_a_filled_t_junction() -> TriangleMesh {
        let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]].map(|[x, y]| Vec3::new(x, y, 0.0));
        let triangles = vec![[0, 1, 2], [0, 2, 4], [0, 4, 3], [4, 2, 3]];
        TriangleMesh::new(corners.to_vec(), triangles).unwrap()
    }

    fn wings(mesh: &TriangleMesh, edge: [u32; 2]) -> ([u32; 2], Option<Vec3>) {
        let topology = Topology::new(mesh);
        let unpaired = UnpairedEdges::new(mesh, &topology);
        let viewer = DisplacedViewer::of_mesh(Viewpoint::Orthographic { toward_viewer: Vec3::Z }, mesh);
        let viewed = ViewedMesh { mesh, topology: &topology, unpaired: &unpaired, viewer };
        let edge = topology.find_edge(VertexId::new(edge[0]), VertexId::new(edge[1])).unwrap();
        (viewed.wings_beside(edge), viewed.surface_at(edge))
    }

    #[test]
    fn the_surface_goes_on_across_a_face_without_area() {
        let mesh = with_a_filled_t_junction();
        let corner = |vertex: usize| Some(mesh.positions()[vertex]);
        assert_eq!(wings(&mesh, [0, 4]), ([1, 1], corner(3)), "half of the diagonal has a wing on both sides");
        assert_eq!(wings(&mesh, [0, 2]).0, [0, 1], "the whole of it is left to the halves");
        assert_eq!(wings(&mesh, [0, 1]), ([1, 0], corner(2)));
    }

    #[test]
    fn the_nearest_wing_of_the_fuller_side_is_the_surface() {
        let at = |x: f32, y: f32, z: f32| Vec3::new(x, y, z);
        let corners =
            [Vec3::ZERO, Vec3::Y, at(1.0, 0.0, 0.0), at(1.0, 0.0, 1.0), at(1.0, 0.0, -1.0), at(-1.0, 0.0, 5.0)];
        // Around the edge 0-1: three wings to its right, one to its left.
        for triangles in [[[0, 1, 2], [0, 1, 3], [0, 1, 4], [0, 1, 5]], [[1, 0, 5], [1, 0, 4], [0, 1, 3], [1, 0, 2]]] {
            let mesh = TriangleMesh::new(corners.to_vec(), triangles.to_vec()).unwrap();
            assert_eq!(wings(&mesh, [0, 1]), ([1, 3], Some(corners[3])));
        }
    }
}
