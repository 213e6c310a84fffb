//! Step 1: the contours of a view, edges where the number of surface layers changes in the picture.
//!
//! Seen from the viewer, crossing the projection of an edge enters those of its faces that lie on the far side and leaves
//! those on the near side. Where as many are entered as left, nothing changes. What remains are silhouette edges, boundary
//! edges, and those edges of non-manifold or inconsistently wound places that do not balance.

use crate::face_tree::FaceTree;
use rayon::prelude::*;
use silhouette_core::facing::judge;
use silhouette_core::glam::Vec3;
use silhouette_core::orientation::{orientation, turn};
use silhouette_core::prepared::Artefact;
use silhouette_core::{
    Cancelled, EdgeId, FaceId, Facing, HalfEdgeId, PreparedMesh, Progress, SilhouetteEdges, Topology, TriangleMesh,
    Viewpoint,
};

/// How many surface layers lie somewhere, or by how much that number changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub struct Layers {
    /// Front faces.
    pub front: i32,
    /// Back faces.
    pub back: i32,
}

impl Layers {
    /// Adds `times` times `other`.
    pub fn add(&mut self, other: Self, times: i32) {
        self.front += other.front * times;
        self.back += other.back * times;
    }

    /// How many solids or sheets there are at least: the larger of both numbers. A solid in front of something shows a
    /// front face and a back face, a wall seen from inside of its solid a back face, a sheet one of either.
    pub fn invisibility(self) -> u32 {
        self.front.max(self.back).max(0).unsigned_abs()
    }

    /// One layer of a face.
    pub fn of(facing: Facing) -> Self {
        match facing {
            Facing::Front => Self { front: 1, back: 0 },
            Facing::Back => Self { front: 0, back: 1 },
        }
    }
}

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

impl Contour {
    /// On which side it has more layers, front faces before back faces: 1 for the left, -1 for the right.
    pub fn surface_side(&self) -> i8 {
        let Layers { front, back } = self.to_the_left;
        if (if front == 0 { back } else { front }) > 0 { 1 } else { -1 }
    }
}

/// Edges of a mesh that do not join two consistently wound faces: boundary edges, non-manifold edges, edges along which
/// both faces run the same way. They may be contours without being silhouette edges. Independent of the view.
#[derive(Debug, Clone, Default)]
pub struct UnpairedEdges(Vec<EdgeId>);

impl UnpairedEdges {
    /// Ascending.
    pub fn as_slice(&self) -> &[EdgeId] {
        &self.0
    }

    /// Whether an edge is unpaired. O(log U) for U unpaired edges.
    pub fn contains(&self, edge: EdgeId) -> bool {
        self.0.binary_search(&edge).is_ok()
    }
}

fn is_unpaired(topology: &Topology, mesh: &TriangleMesh, edge: EdgeId) -> bool {
    match topology.half_edges(edge) {
        [one, other] => runs_forward(mesh, topology, edge, *one) == runs_forward(mesh, topology, edge, *other),
        _ => true,
    }
}

impl Artefact for UnpairedEdges {
    const NAME: &'static str = "unpaired-edges";

    fn build(mesh: &PreparedMesh, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let topology = mesh.artefact::<Topology>(Self::NAME, progress)?;
        let edges = topology.edges().ids();
        Ok(Self(edges.filter(|&edge| is_unpaired(&topology, mesh.mesh(), edge)).collect()))
    }

    fn bytes(&self) -> usize {
        size_of_val(self.0.as_slice())
    }
}

/// Whether a half-edge runs from its edge's lower vertex to the higher one.
fn runs_forward(mesh: &TriangleMesh, topology: &Topology, edge: EdgeId, half_edge: HalfEdgeId) -> bool {
    mesh.triangles()[half_edge.face().index()][half_edge.slot() as usize] == topology.edges()[edge][0]
}

/// Edges that a task takes: some 0.05 ms of work.
pub const EDGES_PER_TASK: usize = 256;

/// Finds the contours of one view.
#[derive(Debug, Clone, Copy)]
pub struct ContourFinder<'a> {
    /// The mesh.
    pub mesh: &'a TriangleMesh,
    /// Its topology.
    pub topology: &'a Topology,
    /// Its unpaired edges.
    pub unpaired: &'a UnpairedEdges,
    /// Where it is seen from.
    pub viewpoint: Viewpoint,
    /// Faces on which the eye lies, ascending. They are seen by nobody: their edges surround the eye, so that what one adds
    /// no other takes away.
    pub at_eye: &'a [FaceId],
}

/// The faces on which the eye of a perspective lies, their edges and corners included, ascending. Exact. O(log F).
pub fn faces_at_eye(mesh: &TriangleMesh, tree: &FaceTree, viewpoint: &Viewpoint) -> Vec<FaceId> {
    let Viewpoint::Perspective { eye } = *viewpoint else { return Vec::new() };
    let mut found = Vec::new();
    tree.faces_near(eye, |face| {
        if holds(mesh.corners(face), eye) {
            found.push(face);
        }
    });
    found.sort_unstable();
    found
}

/// Whether a point lies on a face that has an area: in its plane, and seen along some axis, not beyond any side. Exact.
pub fn holds([a, b, c]: [Vec3; 3], point: Vec3) -> bool {
    orientation(a, b, c, point) == 0.0
        && [Vec3::X, Vec3::Y, Vec3::Z].into_iter().any(|axis| {
            let along = |p, q, r| turn(&Viewpoint::Orthographic { toward_viewer: axis }, p, q, r);
            let area = along(a, b, c);
            area != 0.0
                && [along(a, b, point), along(b, c, point), along(c, a, point)].iter().all(|side| side * area >= 0.0)
        })
}

impl ContourFinder<'_> {
    /// The vertices of an edge, lower id first, and their positions.
    pub fn ends(&self, edge: EdgeId) -> ([u32; 2], [Vec3; 2]) {
        let vertices = self.topology.edges()[edge];
        (vertices, vertices.map(|vertex| self.mesh.positions()[vertex as usize]))
    }

    /// The facing of a face.
    pub fn facing(&self, face: FaceId) -> Facing {
        judge(self.mesh.corners(face), &self.viewpoint).facing
    }

    /// What crossing an edge towards its left changes, faces for which `counts` does not hold left out.
    ///
    /// A front face lies to the left of its half-edges and a back face to their right. A face seen edge-on counts as a back
    /// face of no width: along any path, what one of its edges adds another takes away.
    pub fn change_to_the_left(&self, edge: EdgeId, counts: impl Fn(FaceId) -> bool) -> Layers {
        let mut change = Layers::default();
        for &half_edge in self.topology.half_edges(edge) {
            let face = half_edge.face();
            if counts(face) && self.at_eye.binary_search(&face).is_err() {
                let facing = self.facing(face);
                let forward = runs_forward(self.mesh, self.topology, edge, half_edge);
                let lies_left = forward == (facing == Facing::Front);
                change.add(Layers::of(facing), if lies_left { 1 } else { -1 });
            }
        }
        change
    }

    /// Which side of an edge is the surface that it bounds, looking from its lower vertex to the higher one: 1 for the left,
    /// -1 for the right. That of a front face where it has one.
    pub fn surface_side(&self, edge: EdgeId) -> i8 {
        let half_edges = self.topology.half_edges(edge);
        let front = half_edges.iter().find(|half_edge| self.facing(half_edge.face()) == Facing::Front);
        let forward = |half_edge| runs_forward(self.mesh, self.topology, edge, half_edge);
        let is_left = front.map_or_else(|| !forward(half_edges[0]), |&half_edge| forward(half_edge));
        if is_left { 1 } else { -1 }
    }

    /// All contours: of the silhouette, which must be complete, and of the unpaired edges. Ascending by edge.
    /// O((S + unpaired edges) log S), parallel.
    pub fn find(&self, silhouette: &SilhouetteEdges) -> Vec<Contour> {
        let paired = silhouette.iter().filter(|&edge| !self.unpaired.contains(edge));
        let sides = self.at_eye.iter().flat_map(|&face| (0..3).map(move |slot| HalfEdgeId::of(face, slot)));
        let around_eye = sides.map(|half_edge| self.topology.edge_of(half_edge));
        let mut candidates: Vec<EdgeId> = paired.chain(self.unpaired.0.iter().copied()).chain(around_eye).collect();
        candidates.sort_unstable();
        candidates.dedup();
        candidates.par_iter().with_min_len(EDGES_PER_TASK).filter_map(|&edge| self.contour(edge)).collect()
    }

    /// The contour of a silhouette edge, an unpaired edge or one around the eye.
    fn contour(&self, edge: EdgeId) -> Option<Contour> {
        let (vertices, ends) = self.ends(edge);
        if ends[0] == ends[1] {
            return None;
        }
        let is_fold = self.at_eye.is_empty() && !self.unpaired.contains(edge);
        let to_the_left = if is_fold { self.fold(edge) } else { self.change_to_the_left(edge, |_| true) };
        (to_the_left != Layers::default()).then_some(Contour { edge, vertices, ends, to_the_left })
    }

    /// The change at a paired silhouette edge: its faces lie on one side, one of either facing, so that one tells of both.
    fn fold(&self, edge: EdgeId) -> Layers {
        let half_edge = self.topology.half_edges(edge)[0];
        let is_front = self.facing(half_edge.face()) == Facing::Front;
        let lies_left = runs_forward(self.mesh, self.topology, edge, half_edge) == is_front;
        let change = if lies_left { 1 } else { -1 };
        Layers { front: change, back: change }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::{FaceFacings, NoProgress};

    fn contours(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Vec<(EdgeId, Layers)> {
        let mesh = TriangleMesh::new(positions, triangles).unwrap();
        let prepared = PreparedMesh::new(mesh.clone());
        let topology = prepared.artefact::<Topology>("test", &NoProgress).unwrap();
        let unpaired = prepared.artefact::<UnpairedEdges>("test", &NoProgress).unwrap();
        let viewpoint = Viewpoint::Orthographic { toward_viewer: Vec3::Z };
        let silhouette = SilhouetteEdges::of(&topology, &FaceFacings::new(&mesh, &viewpoint));
        let finder = ContourFinder { mesh: &mesh, topology: &topology, unpaired: &unpaired, viewpoint, at_eye: &[] };
        finder.find(&silhouette).iter().map(|contour| (contour.edge, contour.to_the_left)).collect()
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
    fn an_eye_on_a_face_is_found_and_one_beside_it_is_not() {
        let mesh = TriangleMesh::new(LEFT.to_vec(), vec![[0, 1, 2], [1, 1, 2], [1, 0, 3]]).unwrap();
        let tree = FaceTree::new(&mesh);
        let count = |eye| faces_at_eye(&mesh, &tree, &Viewpoint::Perspective { eye }).len();
        let on = [LEFT[0], LEFT[1], Vec3::new(0.5, 0.0, 0.0), Vec3::new(0.4, 0.3, 0.0)];
        assert_eq!(on.map(count), [2, 2, 2, 1]);
        let beside = [Vec3::new(0.4, 0.3, 1e-30), Vec3::new(1.0, 1.0, 0.0), Vec3::new(0.0, 1e-30, 0.0), Vec3::NEG_X];
        assert_eq!(beside.map(count), [0; 4]);
    }

    #[test]
    fn invisibility_counts_solids_walls_and_sheets() {
        for (front, back, expected) in [(0, 0, 0), (1, 1, 1), (0, 1, 1), (2, 1, 2), (1, 2, 2)] {
            assert_eq!(Layers { front, back }.invisibility(), expected);
        }
    }
}
