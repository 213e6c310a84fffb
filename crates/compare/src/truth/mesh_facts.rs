//! [`MeshFacts`]: what is known of a mesh's edges and faces before any view that makes methods err.

use silhouette_core::face_normal::face_normal;
use silhouette_core::glam::Vec3;
use silhouette_core::inside_out::inside_out_faces;
use silhouette_core::{DisjointSets, EdgeId, FaceId, Topology, TriangleMesh};
use std::f64::consts::PI;

/// Least dihedral angle of a crease, in degrees: what viewers of CAD models draw by default.
pub const CREASE_DEG: f64 = 30.0;

/// A part is nearly closed if a disc that is as long around as its boundary has less than this share of its area. A cup as wide as
/// high is (0.2), half a ball is not (0.5).
const NEARLY_CLOSED: f64 = 0.25;

/// The kind of line that an edge makes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EdgeKind {
    /// It has more than one face and is no crease: a line only where a view makes it one.
    Silhouette,
    /// It joins two consistently wound faces whose normals differ by [`CREASE_DEG`] or more.
    Crease,
    /// It has one face.
    Boundary,
}

/// A property of the mesh at a place of the picture that is known to make methods err there. Each place has one: the first
/// that holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Circumstance {
    /// The surface ends: a line is a boundary edge, or ink lies where a face of an open part is seen from its back.
    OpenBoundary,
    /// Faces are wound inwards, or against their neighbours.
    InwardWinding,
    /// Each of the faces covers less than a pixel.
    SmallFaces,
    /// None of these.
    Unexplained,
}

/// Facts of a mesh that do not depend on the view.
#[derive(Debug)]
pub struct MeshFacts {
    kinds: Vec<EdgeKind>,
    /// By edge: whether faces there are wound inwards or against each other.
    is_wrongly_wound: Vec<bool>,
    /// By face: whether it is wound inwards.
    is_inward: Vec<bool>,
    /// By face: whether the part of the surface that it belongs to has a boundary edge.
    is_open: Vec<bool>,
}

impl MeshFacts {
    /// Collects them. A part is what consistently wound pairs of faces join. It is wound inwards where its signed volume is
    /// negative and it is closed, or nearly: a disc as long around as its boundary has less than a quarter of its area.
    /// Which side of a sheet is its outer one nobody can say. O(E α(F)).
    pub fn new(mesh: &TriangleMesh, topology: &Topology) -> Self {
        let edges = || (0..topology.edge_count()).map(EdgeId::from_usize);
        let mut parts = DisjointSets::new(mesh.face_count());
        let mut kinds = Vec::with_capacity(topology.edge_count());
        let least_cosine = CREASE_DEG.to_radians().cos();
        for edge in edges() {
            let pair = topology.consistent_pair(mesh, edge);
            if let Some([a, b]) = pair {
                parts.unite(a.get(), b.get());
            }
            let normals = pair.map(|faces| faces.map(|face| face_normal(mesh.corners(face))));
            kinds.push(match (topology.faces(edge).len(), normals) {
                (1, _) => EdgeKind::Boundary,
                (_, Some([Some(one), Some(other)])) if one.dot(other) <= least_cosine => EdgeKind::Crease,
                _ => EdgeKind::Silhouette,
            });
        }
        let part_of: Vec<usize> = (0..mesh.face_count() as u32).map(|face| parts.find(face) as usize).collect();
        let (mut area, mut boundary) = (vec![0.0; mesh.face_count()], vec![0.0; mesh.face_count()]);
        for (face, &part) in part_of.iter().enumerate() {
            let [a, b, c] = mesh.corners(FaceId::from_usize(face)).map(Vec3::as_dvec3);
            area[part] += 0.5 * (b - a).cross(c - a).length();
        }
        let is_boundary = |edge: &EdgeId| kinds[edge.index()] == EdgeKind::Boundary;
        for edge in edges().filter(is_boundary) {
            let [a, b] = topology.end_points(edge).map(|vertex| mesh.positions()[vertex.index()].as_dvec3());
            topology.faces(edge).for_each(|face| boundary[part_of[face.index()]] += a.distance(b));
        }
        let is_open: Vec<bool> = part_of.iter().map(|&part| boundary[part] > 0.0).collect();
        let is_nearly_closed = |part: usize| boundary[part] * boundary[part] <= NEARLY_CLOSED * 4.0 * PI * area[part];
        let inside_out = inside_out_faces(mesh, topology);
        let is_inward: Vec<bool> =
            part_of.iter().zip(inside_out).map(|(&part, inside_out)| inside_out && is_nearly_closed(part)).collect();
        let is_wrongly_wound = |edge: EdgeId| {
            let is_turned = topology.faces(edge).len() == 2 && topology.consistent_pair(mesh, edge).is_none();
            is_turned || topology.faces(edge).any(|face| is_inward[face.index()])
        };
        let is_wrongly_wound = edges().map(is_wrongly_wound).collect();
        Self { kinds, is_wrongly_wound, is_inward, is_open }
    }

    /// Number of faces that are wound inwards.
    pub fn inward_faces(&self) -> usize {
        self.is_inward.iter().filter(|&&is_inward| is_inward).count()
    }

    /// The kind of line that an edge makes.
    pub fn kind(&self, edge: EdgeId) -> EdgeKind {
        self.kinds[edge.index()]
    }

    /// The circumstance of a line along an edge; `has_small_faces` says whether each of its faces covers less than a pixel.
    pub fn of_edge(&self, edge: EdgeId, has_small_faces: impl FnOnce() -> bool) -> Circumstance {
        if self.kind(edge) == EdgeKind::Boundary {
            Circumstance::OpenBoundary
        } else if self.is_wrongly_wound[edge.index()] {
            Circumstance::InwardWinding
        } else if has_small_faces() {
            Circumstance::SmallFaces
        } else {
            Circumstance::Unexplained
        }
    }

    /// The circumstance of ink on a face that is seen from its front or its back; [`Circumstance::SmallFaces`] is for the
    /// caller to decide. The back of a closed part that is wound outwards is seen from its inside alone.
    pub fn of_face(&self, face: FaceId, is_back: bool) -> Circumstance {
        let (inward, open) = (self.is_inward[face.index()], self.is_open[face.index()]);
        match (is_back, inward, open) {
            (true, true, _) => Circumstance::InwardWinding,
            (true, false, true) => Circumstance::OpenBoundary,
            _ => Circumstance::Unexplained,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::inside_out::turned;
    use silhouette_core::shapes;

    fn facts(mesh: &TriangleMesh) -> (Topology, MeshFacts) {
        let topology = Topology::new(mesh);
        let facts = MeshFacts::new(mesh, &topology);
        (topology, facts)
    }

    fn count(mesh: &TriangleMesh, kind: EdgeKind) -> usize {
        let (topology, facts) = facts(mesh);
        (0..topology.edge_count()).filter(|&edge| facts.kind(EdgeId::from_usize(edge)) == kind).count()
    }

    #[test]
    fn each_edge_has_one_kind() {
        let cube = shapes::by_name("cube").unwrap();
        let of_cube = [EdgeKind::Silhouette, EdgeKind::Crease, EdgeKind::Boundary].map(|kind| count(&cube, kind));
        assert_eq!(of_cube, [6, 12, 0], "the diagonals of its sides bend nowhere");
        let open = TriangleMesh::new(cube.positions().to_vec(), cube.triangles()[..10].to_vec()).unwrap();
        assert_eq!(count(&open, EdgeKind::Boundary), 4);
    }

    #[test]
    fn winding_and_openness_are_those_of_whole_parts() {
        let cube = shapes::by_name("cube").unwrap();
        let inverted = turned(&cube, &[true; 12]);
        let (topology, of_inverted) = facts(&inverted);
        for edge in (0..topology.edge_count()).map(EdgeId::from_usize) {
            assert_eq!(of_inverted.of_edge(edge, || true), Circumstance::InwardWinding);
        }
        assert_eq!(of_inverted.of_face(FaceId::new(0), true), Circumstance::InwardWinding);
        let (_, of_cube) = facts(&cube);
        assert_eq!(of_cube.of_face(FaceId::new(0), true), Circumstance::Unexplained);
        let open = TriangleMesh::new(cube.positions().to_vec(), cube.triangles()[..10].to_vec()).unwrap();
        let (topology, of_open) = facts(&open);
        assert_eq!(of_open.of_face(FaceId::new(0), true), Circumstance::OpenBoundary);
        assert_eq!(of_open.of_face(FaceId::new(0), false), Circumstance::Unexplained);
        let boundary = (0..topology.edge_count()).map(EdgeId::from_usize).find(|&edge| topology.faces(edge).len() == 1);
        assert_eq!(of_open.of_edge(boundary.unwrap(), || true), Circumstance::OpenBoundary);
    }

    /// A ball with a hole is as good as closed; which side of a sheet is outside nobody can say.
    #[test]
    fn only_what_is_nearly_closed_is_wound_inwards() {
        let ball = shapes::by_name("icosphere:3").unwrap();
        let open = |kept: usize| {
            let mut faces: Vec<[u32; 3]> = ball.triangles().to_vec();
            faces.sort_by(|a, b| {
                let height =
                    |face: &[u32; 3]| face.iter().map(|&corner| ball.positions()[corner as usize].y).sum::<f32>();
                height(a).total_cmp(&height(b))
            });
            faces.truncate(kept);
            let mesh = TriangleMesh::new(ball.positions().to_vec(), faces).unwrap();
            turned(&mesh, &vec![true; mesh.face_count()])
        };
        let count = ball.face_count();
        for (kept, circumstance) in [
            (count - 20, Circumstance::InwardWinding),
            (count / 2, Circumstance::OpenBoundary),
            (count / 10, Circumstance::OpenBoundary),
        ] {
            let (_, facts) = facts(&open(kept));
            assert_eq!(facts.of_face(FaceId::new(0), true), circumstance, "{kept} of {count}");
        }
    }

    #[test]
    fn a_face_turned_against_its_neighbours_shows_at_its_edges_alone() {
        let ball = shapes::by_name("icosphere:2").unwrap();
        let mut is_turned = vec![false; ball.face_count()];
        is_turned[7] = true;
        let (topology, facts) = facts(&turned(&ball, &is_turned));
        let wrong = (0..topology.edge_count()).map(EdgeId::from_usize);
        let wrong = wrong.filter(|&edge| facts.of_edge(edge, || false) == Circumstance::InwardWinding);
        assert_eq!(wrong.count(), 3);
    }
}
