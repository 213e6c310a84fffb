//! Preparation (Hall 2003): the edge connectivity table, which maps each face to its neighbours and keeps its plane.
//!
//! Departure: an entry names the half-edge across, not only the face, since two faces may share several edges. Plane
//! and neighbours of a face lie side by side, 32 bytes, half a cache line: a walk looks at both of each face it comes
//! to.

use crate::plane_test::{PlaneTest, plane};
use crate::refuse::{self, Defect};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::prepared::Artefact;
use silhouette_core::progress::Cancelled;
use silhouette_core::topology::Twin;
use silhouette_core::{FaceId, HalfEdgeId, PreparedMesh, Progress, Topology, TriangleMesh, Viewpoint};
use std::sync::Arc;

/// No face is across. (A mesh has fewer faces than that.)
const NOTHING_ACROSS: u32 = u32::MAX;

/// A half-edge as face and slot apart: a walk that keeps them so never divides by three.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Side {
    pub face: FaceId,
    slot: u32,
}

impl Side {
    pub fn new(face: FaceId, slot: u32) -> Self {
        Self { face, slot }
    }

    pub fn of(half_edge: HalfEdgeId) -> Self {
        Self { face: half_edge.face(), slot: half_edge.slot() }
    }

    pub fn half_edge(self) -> HalfEdgeId {
        HalfEdgeId::of(self.face, self.slot)
    }

    /// The side that follows around the same face.
    #[inline]
    pub fn next_in_face(self) -> Self {
        Self { slot: if self.slot == 2 { 0 } else { self.slot + 1 }, ..self }
    }
}

/// One face.
#[derive(Debug, Clone, Copy)]
#[repr(align(32))]
struct Row {
    /// Unit normal and offset relative to the table's centre; zeros where 64 bits do not tell them.
    plane: [f32; 4],
    /// The face across each side, and which of its sides that is.
    faces: [u32; 3],
    slots: [u8; 3],
}

/// Neighbours and plane of each face, and where the mesh may not be tracked across.
#[derive(Debug, Clone)]
pub struct ConnectivityTable {
    rows: Vec<Row>,
    topology: Arc<Topology>,
    defects: Vec<Defect>,
    center: DVec3,
    /// Largest distance of a used vertex from `center`.
    radius: f64,
    /// Box around the used vertices; lowest above highest without faces.
    bounds: [DVec3; 2],
}

impl ConnectivityTable {
    /// The table of a mesh with this topology. Edges that cannot be tracked across are listed and cut; whether a mesh
    /// that has any is to be tracked is for others to say. O(F + E).
    ///
    /// # Panics
    /// If the topology is of another mesh.
    pub fn new(mesh: &TriangleMesh, topology: &Arc<Topology>) -> Self {
        assert_eq!(topology.half_edge_count(), 3 * mesh.face_count(), "topology of another mesh");
        let defects = refuse::defects(mesh, topology);
        let topology = refuse::cut(topology, &defects);
        let across = |face, slot| match topology.twin(HalfEdgeId::of(face, slot)) {
            Twin::HalfEdge(twin) => (twin.face().get(), twin.slot() as u8),
            // Non-manifold edges have been cut.
            Twin::Boundary | Twin::NonManifold => (NOTHING_ACROSS, 0),
        };
        let row = |face| {
            let across = [0, 1, 2].map(|slot| across(face, slot));
            Row { plane: [0.0; 4], faces: across.map(|(face, _)| face), slots: across.map(|(_, slot)| slot) }
        };
        let rows = (0..mesh.face_count()).map(FaceId::from_usize).map(row).collect();
        let bounds = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        let mut table = Self { rows, topology, defects, center: DVec3::ZERO, radius: 0.0, bounds };
        table.place(mesh.positions(), mesh.triangles());
        table
    }

    /// Replaces the planes by those of other positions. O(F), allocates nothing.
    pub(crate) fn place(&mut self, positions: &[Vec3], triangles: &[[u32; 3]]) {
        let corners = |triangle: &[u32; 3]| triangle.map(|vertex| positions[vertex as usize].as_dvec3());
        let empty = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        let extend = |[min, max]: [DVec3; 2], p: DVec3| [min.min(p), max.max(p)];
        self.bounds = triangles.iter().flat_map(corners).fold(empty, extend);
        let [min, max] = self.bounds;
        let center = if triangles.is_empty() { DVec3::ZERO } else { (min + max) * 0.5 };
        self.center = center;
        self.radius = triangles.iter().flat_map(corners).map(|p| p.distance_squared(center)).fold(0.0, f64::max).sqrt();
        for (row, triangle) in self.rows.iter_mut().zip(triangles) {
            row.plane = plane(corners(triangle), center);
        }
    }

    /// Number of faces.
    pub fn face_count(&self) -> usize {
        self.rows.len()
    }

    /// The topology to track on: that of the mesh, cut at all defects.
    pub fn topology(&self) -> &Arc<Topology> {
        &self.topology
    }

    /// Edges that cannot be tracked across, ascending.
    pub fn defects(&self) -> &[Defect] {
        &self.defects
    }

    /// The half-edge across, if there is a face across that can be tracked to.
    ///
    /// # Panics
    /// If the mesh has no such half-edge.
    #[inline]
    pub fn twin(&self, half_edge: HalfEdgeId) -> Option<HalfEdgeId> {
        self.across(Side::of(half_edge)).map(Side::half_edge)
    }

    /// The side across, if there is a face across.
    #[inline]
    pub(crate) fn across(&self, side: Side) -> Option<Side> {
        let row = &self.rows[side.face.index()];
        let face = row.faces[side.slot as usize];
        let slot = u32::from(row.slots[side.slot as usize]);
        (face != NOTHING_ACROSS).then_some(Side { face: FaceId::new(face), slot })
    }

    /// Unit normal and offset, relative to [`center`](Self::center).
    #[inline]
    pub(crate) fn plane(&self, face: FaceId) -> [f32; 4] {
        self.rows[face.index()].plane
    }

    /// Whether the plane of a face is known to 32 bits; not so for needles and faces without area.
    pub(crate) fn is_reliable(&self, face: FaceId) -> bool {
        self.plane(face)[..3].iter().any(|&coordinate| coordinate != 0.0)
    }

    /// The test of a view against the planes.
    pub(crate) fn test(&self, viewpoint: &Viewpoint) -> PlaneTest {
        PlaneTest::new(viewpoint, self.center, self.radius)
    }

    /// Middle of the box around the mesh, in object space.
    pub(crate) fn center(&self) -> DVec3 {
        self.center
    }

    /// Radius of the mesh about [`center`](Self::center).
    pub(crate) fn radius(&self) -> f64 {
        self.radius
    }

    /// Lowest and highest corner of the box around the mesh; lowest above highest where there is no face.
    pub(crate) fn bounds(&self) -> [DVec3; 2] {
        self.bounds
    }
}

impl Artefact for ConnectivityTable {
    const NAME: &'static str = "connectivity-table";

    fn build(mesh: &PreparedMesh, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let topology = mesh.artefact::<Topology>(Self::NAME, progress)?;
        progress.check()?;
        progress.stage("connectivity table", 1);
        let table = Self::new(mesh.mesh(), &topology);
        progress.advance(1);
        Ok(table)
    }

    fn bytes(&self) -> usize {
        let cut = if self.defects.is_empty() { 0 } else { Artefact::bytes(&*self.topology) };
        size_of_val(self.rows.as_slice()) + size_of_val(self.defects.as_slice()) + cut
    }
}
