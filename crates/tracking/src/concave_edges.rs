//! Preparation (Hall 2003): the concave edges in order of decreasing angle, and the boundary.
//!
//! An edge is concave where its interior angle exceeds `pi`, that is where the far corner of one of its faces lies
//! strictly on the outer side of the other: decided exactly, since the rule that silhouettes are born at concave edges
//! holds for exact facings and exact concavity only. `angle` is by how much `pi` is exceeded, in radians, 0 to `pi`.
//!
//! Two cases beyond Hall's. An edge whose faces are folded onto each other has an angle of `pi`, on whichever side they
//! lie: no view sees both, as at a boundary edge. So has an edge of a face whose plane 64-bit arithmetic cannot determine
//! (needles, no area): such a face may stay back while all around it turns.

use crate::connectivity_table::ConnectivityTable;
use silhouette_core::facing::{Facing, judge};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::prepared::Artefact;
use silhouette_core::progress::Cancelled;
use silhouette_core::{FaceId, HalfEdgeId, NoProgress, PreparedMesh, Progress, TriangleMesh, Viewpoint};
use std::f32::consts::PI;

/// Sine below which two faces on opposite sides of a half-turn count as folded onto each other.
const FOLD_SINE: f64 = 1e-6;

/// Faces between two checks for cancellation: about 5 ms.
const FACES_PER_CHECK: usize = 1 << 16;

/// A concave edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConcaveEdge {
    /// Its half-edges, the lower one first.
    pub half_edges: [HalfEdgeId; 2],
    /// By how much the interior angle exceeds `pi`, in radians.
    pub angle_rad: f32,
}

/// Concave edges and boundary edges of a mesh: where new silhouettes are searched. 16 bytes per concave edge, 4 per
/// boundary edge.
#[derive(Debug, Clone, Default)]
pub struct TrackedEdges {
    concave: ConcaveEdges,
    boundary: Vec<HalfEdgeId>,
}

/// Concave edges in order of decreasing angle.
#[derive(Debug, Clone, Default)]
pub(crate) struct ConcaveEdges {
    by_angle: Vec<ConcaveEdge>,
    /// Ranks in `by_angle`, in the order of half-edges.
    by_half_edge: Vec<u32>,
}

impl TrackedEdges {
    /// Finds the edges of a mesh with this table. O(F + E), and O(C log C) for C concave edges.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn new(mesh: &TriangleMesh, table: &ConnectivityTable, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let mut concave = ConcaveEdges::default();
        concave.search(mesh.positions(), mesh.triangles(), table, progress)?;
        concave.sort();
        progress.check()?;
        let half_edges = (0..3 * table.face_count()).map(HalfEdgeId::from_usize);
        let boundary = half_edges.filter(|&half_edge| table.twin(half_edge).is_none()).collect();
        Ok(Self { concave, boundary })
    }

    /// No edges: for trackers in the exact mode, which search none.
    pub fn none() -> Self {
        Self::default()
    }

    /// Concave edges in order of decreasing angle, equal angles in the order of half-edges.
    pub fn concave(&self) -> &[ConcaveEdge] {
        &self.concave.by_angle
    }

    /// Half-edges with nothing across, ascending.
    pub fn boundary(&self) -> &[HalfEdgeId] {
        &self.boundary
    }

    pub(crate) fn concave_edges(&self) -> &ConcaveEdges {
        &self.concave
    }
}

impl ConcaveEdges {
    /// Replaces the edges by those of other positions. O(E), and O(C log C) for C concave edges; no allocation from the
    /// second call on.
    pub(crate) fn find(&mut self, positions: &[Vec3], triangles: &[[u32; 3]], table: &ConnectivityTable) {
        self.search(positions, triangles, table, &NoProgress).expect("nobody cancels");
        self.sort();
    }

    fn search(
        &mut self,
        positions: &[Vec3],
        triangles: &[[u32; 3]],
        table: &ConnectivityTable,
        progress: &dyn Progress,
    ) -> Result<(), Cancelled> {
        let shape = Shape { positions, triangles, table };
        let concave = |one| {
            let other = table.twin(one).filter(|&other| one < other)?;
            let angle_rad = shape.concave_angle(one, other)?;
            Some(ConcaveEdge { half_edges: [one, other], angle_rad })
        };
        self.by_angle.clear();
        let faces = table.face_count();
        for first in (0..faces).step_by(FACES_PER_CHECK) {
            progress.check()?;
            let half_edges = 3 * first..3 * faces.min(first + FACES_PER_CHECK);
            self.by_angle.extend(half_edges.map(HalfEdgeId::from_usize).filter_map(concave));
        }
        Ok(())
    }

    fn sort(&mut self) {
        self.by_angle
            .sort_unstable_by(|a, b| b.angle_rad.total_cmp(&a.angle_rad).then_with(|| a.half_edges.cmp(&b.half_edges)));
        self.by_half_edge.clear();
        self.by_half_edge.extend(0..self.by_angle.len() as u32);
        let by_angle = &self.by_angle;
        self.by_half_edge.sort_unstable_by_key(|&rank| by_angle[rank as usize].half_edges);
    }

    /// As [`find`](Self::find) needs for any positions of this topology, so that moving meshes never allocate again.
    pub(crate) fn reserve(&mut self, edges: usize) {
        self.by_angle.reserve(edges);
        self.by_half_edge.reserve(edges);
    }

    /// Bytes held.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self.by_angle.as_slice()) + size_of_val(self.by_half_edge.as_slice())
    }
}

struct Shape<'a> {
    positions: &'a [Vec3],
    triangles: &'a [[u32; 3]],
    table: &'a ConnectivityTable,
}

impl Shape<'_> {
    fn corners(&self, face: FaceId) -> [Vec3; 3] {
        self.triangles[face.index()].map(|vertex| self.positions[vertex as usize])
    }

    /// By how much the interior angle between two faces exceeds `pi`; `None` at an edge that is flat or convex.
    fn concave_angle(&self, one: HalfEdgeId, other: HalfEdgeId) -> Option<f32> {
        let corners = self.corners(one.face());
        let other_corners = self.corners(other.face());
        if !(self.table.is_reliable(one.face()) && self.table.is_reliable(other.face())) {
            return Some(PI);
        }
        let far_corner = other_corners[(other.slot() as usize + 2) % 3];
        let is_concave = judge(corners, &Viewpoint::Perspective { eye: far_corner }).facing == Facing::Front;
        let (normal, other_normal) = (unit_normal(corners), unit_normal(other_corners));
        let (sine, cosine) = (normal.cross(other_normal).length(), normal.dot(other_normal));
        if is_concave { Some(sine.atan2(cosine) as f32) } else { (cosine < 0.0 && sine < FOLD_SINE).then_some(PI) }
    }
}

fn unit_normal(corners: [Vec3; 3]) -> DVec3 {
    let [v0, v1, v2] = corners.map(Vec3::as_dvec3);
    (v1 - v0).cross(v2 - v0).normalize()
}

impl Artefact for TrackedEdges {
    const NAME: &'static str = "tracked-edges";

    fn build(mesh: &PreparedMesh, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let table = mesh.artefact::<ConnectivityTable>(Self::NAME, progress)?;
        progress.check()?;
        progress.stage("concave edges", 1);
        let edges = Self::new(mesh.mesh(), &table, progress)?;
        progress.advance(1);
        Ok(edges)
    }

    fn bytes(&self) -> usize {
        self.concave.bytes() + size_of_val(self.boundary.as_slice())
    }
}

/// The concave edges that a concavity level selects: the head of the list by angle, copied in the order of half-edges,
/// so that a frame runs through memory once and in one direction.
#[derive(Debug, Clone, Default)]
pub(crate) struct ActiveEdges {
    pub half_edges: Vec<[HalfEdgeId; 2]>,
    /// Their faces, ascending, each once, and a copy of the planes of these faces.
    pub faces: Vec<FaceId>,
    pub planes: Vec<[f32; 4]>,
    is_face: Vec<u64>,
}

impl ActiveEdges {
    /// Selects the edges whose angle exceeds `level_rad`; none for `None`. O(C + F / 64), no allocation once grown.
    pub fn select(&mut self, concave: &ConcaveEdges, level_rad: Option<f32>, table: &ConnectivityTable) {
        let faces = table.face_count();
        let is_above = |edge: &ConcaveEdge| level_rad.is_some_and(|level| edge.angle_rad > level);
        let count = concave.by_angle.partition_point(is_above);
        self.half_edges.clear();
        self.faces.clear();
        self.half_edges.reserve(concave.by_angle.len());
        self.is_face.resize(faces.div_ceil(64), 0);
        for &rank in concave.by_half_edge.iter().filter(|&&rank| (rank as usize) < count) {
            let half_edges = concave.by_angle[rank as usize].half_edges;
            self.half_edges.push(half_edges);
            for face in half_edges.map(HalfEdgeId::face) {
                self.is_face[face.index() / 64] |= 1 << (face.index() % 64);
            }
        }
        self.faces.reserve(faces.min(2 * concave.by_angle.len()));
        for (index, word) in self.is_face.iter_mut().enumerate() {
            let mut bits = std::mem::take(word);
            while bits != 0 {
                self.faces.push(FaceId::from_usize(64 * index + bits.trailing_zeros() as usize));
                bits &= bits - 1;
            }
        }
        self.planes.clear();
        self.planes.reserve(self.faces.capacity());
        self.planes.extend(self.faces.iter().map(|&face| table.plane(face)));
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        size_of_val(self.half_edges.as_slice()) + 20 * self.faces.len() + size_of_val(self.is_face.as_slice())
    }
}
