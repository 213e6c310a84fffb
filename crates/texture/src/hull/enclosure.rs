//! [`Enclosure`]: the proof that a hull encloses an object, by exact arithmetic.
//!
//! 1. The hull is closed, manifold and consistently wound, and none of its faces is without area or has the vertices of
//!    another.
//! 2. It does not touch itself: an edge touches no face, but for the corners that they share. A hull that passes through itself
//!    loses rays, as the first way out of it is not the last.
//! 3. No edge of the object touches a face of the hull, and no edge of the hull a face of the object. Two triangles that have a
//!    point in common have one on an edge of either, so surfaces do not touch.
//! 4. The vertices of the object are inside: the hull winds around them once. Where nothing touches, all vertices of a connected
//!    part are on the same side, so one of each is asked. Vertices that no face uses are ignored.
//! 5. The hull winds around no point more than once, or less than 0 times: each of its components lies outside all others,
//!    wound outwards, or is a cavity inside them, wound inwards.
//!
//! Only the sign of a component's volume is taken from 64-bit sums.

use crate::hull::self_contact::meets;
use crate::hull::touching::touches;
use crate::hull::winding_number::winding_number;
use rayon::prelude::*;
use silhouette_core::inspect::{Inspection, inspect_with_progress};
use silhouette_core::{Cancelled, DisjointSets, FaceId, NoProgress, Progress, Quiet, Topology, TriangleMesh, VertexId};
use silhouette_rays::MeshHierarchy;

/// What keeps a mesh from being the hull of an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Offence {
    /// It has no faces.
    #[error("the hull has no faces; give a closed mesh")]
    Empty,
    /// An edge has one face.
    #[error("the hull is open at its edge {} {}; close it", .0[0], .0[1])]
    Open([VertexId; 2]),
    /// An edge has three or more faces.
    #[error("the hull has three or more faces at its edge {} {}; give a manifold mesh", .0[0], .0[1])]
    NonManifoldEdge([VertexId; 2]),
    /// Faces meet in a vertex only.
    #[error("the hull touches itself in its vertex {0}; give a manifold mesh")]
    NonManifoldVertex(VertexId),
    /// Neighbours disagree on which side is out.
    #[error("the hull's faces at its edge {} {} are wound against each other; wind all counter-clockwise from outside", .0[0], .0[1])]
    Winding([VertexId; 2]),
    /// A face has no area, or the vertices of another face.
    #[error("the hull's face {0} has no area or the vertices of another face; leave it out")]
    Flat(FaceId),
    /// The hull meets itself.
    #[error("the hull passes through or touches itself, with its edge {} {} in its face {face}; part the two", edge[0], edge[1])]
    SelfContact {
        /// An edge of the hull.
        edge: [VertexId; 2],
        /// A face of the hull that it touches.
        face: FaceId,
    },
    /// A component is wound inwards, or lies in another one.
    #[error(
        "the hull's component with face {0} is wound inwards or lies in another component; wind it counter-clockwise seen from \
         outside, and leave inner components out"
    )]
    Nested(FaceId),
    /// An edge of the object reaches through the hull.
    #[error("the object's edge {} {} passes through or touches the hull's face {face}; move that face outwards", edge[0], edge[1])]
    ObjectEdge {
        /// An edge of the object.
        edge: [VertexId; 2],
        /// A face of the hull that it touches.
        face: FaceId,
    },
    /// An edge of the hull reaches through the object.
    #[error("the hull's edge {} {} passes through or touches the object's face {face}; move that edge outwards", edge[0], edge[1])]
    HullEdge {
        /// An edge of the hull.
        edge: [VertexId; 2],
        /// A face of the object that it touches.
        face: FaceId,
    },
    /// Part of the object is outside.
    #[error("the object's vertex {0} and all that is connected to it are not inside the hull; enlarge it")]
    Outside(VertexId),
}

/// What was found about a hull and an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Enclosure {
    /// Edges of the object that touch the hull.
    pub object_edges: usize,
    /// Edges of the hull that touch the object.
    pub hull_edges: usize,
    /// Edges of the hull that touch another part of it.
    pub self_contacts: usize,
    /// Connected parts of the object of which the tested vertex is not inside the hull.
    pub parts_outside: usize,
    /// The first offence, in the order of the [module](self); `None` where enclosure is proved.
    pub first: Option<Offence>,
}

impl Enclosure {
    /// Whether the hull is one of the object.
    pub fn is_proved(&self) -> bool {
        self.first.is_none()
    }
}

/// An object, prepared for the test of any number of hulls.
pub struct Enclosed<'a> {
    mesh: &'a TriangleMesh,
    hierarchy: MeshHierarchy,
    edges: Vec<[u32; 2]>,
    /// The lowest vertex of each connected part.
    parts: Vec<u32>,
}

/// Edges that a task takes.
const EDGES_PER_TASK: usize = 1024;

impl<'a> Enclosed<'a> {
    /// Prepares an object. O(F log F).
    #[expect(clippy::missing_panics_doc, reason = "nobody cancels")]
    pub fn new(mesh: &'a TriangleMesh) -> Self {
        Self::with_progress(mesh, &NoProgress).expect("nobody cancels")
    }

    /// Like [`new`](Self::new), but stops between its steps when `progress` asks to.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn with_progress(mesh: &'a TriangleMesh, progress: &dyn Progress) -> Result<Self, Cancelled> {
        progress.check()?;
        let mut connected = connected_vertices(mesh);
        let mut parts: Vec<u32> = mesh.triangles().iter().map(|&[vertex, _, _]| connected.find(vertex)).collect();
        parts.sort_unstable();
        parts.dedup();
        progress.check()?;
        let edges = Topology::new(mesh).edges().as_slice().to_vec();
        Ok(Self { mesh, hierarchy: MeshHierarchy::with_progress(mesh, progress)?, edges, parts })
    }

    /// The object's mesh.
    pub fn mesh(&self) -> &'a TriangleMesh {
        self.mesh
    }

    /// The hierarchy over the object's faces.
    pub fn hierarchy(&self) -> &MeshHierarchy {
        &self.hierarchy
    }

    /// Tests a hull. The same for any number of threads. Expected O((E + H) log(F + H)) for E edges and F faces of the object
    /// and H of the hull, parallel.
    #[expect(clippy::missing_panics_doc, reason = "nobody cancels")]
    pub fn by(&self, hull: &TriangleMesh) -> Enclosure {
        self.by_with_progress(hull, &NoProgress).expect("nobody cancels")
    }

    /// Like [`by`](Self::by), but stops when `progress` asks to.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn by_with_progress(&self, hull: &TriangleMesh, progress: &dyn Progress) -> Result<Enclosure, Cancelled> {
        progress.check()?;
        let topology = Topology::new(hull);
        let inspection = inspect_with_progress(hull, &topology, &Quiet(progress))?;
        if let Some(defect) = defect(&inspection, &topology) {
            return Ok(Enclosure { first: Some(defect), ..Enclosure::default() });
        }
        let hierarchy = MeshHierarchy::with_progress(hull, progress)?;
        let hull_edges = topology.edges().as_slice();
        let on_itself = contacts(hull_edges, progress, |edge| self_contact(hull, &hierarchy, edge))?;
        let of_object = contacts(&self.edges, progress, |edge| contact(self.mesh, edge, &hierarchy))?;
        let of_hull = contacts(hull_edges, progress, |edge| contact(hull, edge, &self.hierarchy))?;
        let outside = self.parts_outside(hull, &hierarchy, progress)?;
        let in_self = on_itself.first.map(|(edge, face)| Offence::SelfContact { edge, face });
        let in_hull = of_object.first.map(|(edge, face)| Offence::ObjectEdge { edge, face });
        let in_object = of_hull.first.map(|(edge, face)| Offence::HullEdge { edge, face });
        let nested = || nested(hull, &inspection, &hierarchy).map(Offence::Nested);
        Ok(Enclosure {
            object_edges: of_object.count,
            hull_edges: of_hull.count,
            self_contacts: on_itself.count,
            parts_outside: outside.len(),
            first: in_self
                .or(in_hull)
                .or(in_object)
                .or_else(nested)
                .or_else(|| outside.first().map(|&vertex| Offence::Outside(VertexId::new(vertex)))),
        })
    }

    /// The vertices, one for each part, around which the hull does not wind once.
    fn parts_outside(
        &self,
        hull: &TriangleMesh,
        hierarchy: &MeshHierarchy,
        progress: &dyn Progress,
    ) -> Result<Vec<u32>, Cancelled> {
        let is_outside = |vertex: u32| {
            progress.check()?;
            let point = self.mesh.positions()[vertex as usize];
            Ok((winding_number(hull, hierarchy, point, |_| true) != Some(1)).then_some(vertex))
        };
        self.parts.par_iter().copied().filter_map(|vertex| is_outside(vertex).transpose()).collect()
    }
}

/// The vertices of a mesh that its faces connect.
fn connected_vertices(mesh: &TriangleMesh) -> DisjointSets {
    let mut sets = DisjointSets::new(mesh.vertex_count());
    for &[a, b, c] in mesh.triangles() {
        sets.unite(a, b);
        sets.unite(a, c);
    }
    sets
}

/// What makes a mesh no closed manifold.
fn defect(inspection: &Inspection, topology: &Topology) -> Option<Offence> {
    let defects = &inspection.defects;
    let open = inspection
        .boundary_loops
        .first()
        .map(|boundary| topology.end_points(topology.edge_of(boundary.first_half_edge)));
    let flat = defects.zero_area_faces.first().or_else(|| defects.duplicate_faces.first().map(|group| &group[0]));
    let empty = (inspection.faces == 0).then_some(Offence::Empty);
    empty
        .or(open.map(Offence::Open))
        .or(defects.non_manifold_edges.first().map(|defect| Offence::NonManifoldEdge(defect.vertices)))
        .or(defects.non_manifold_vertices.first().copied().map(Offence::NonManifoldVertex))
        .or(defects.inconsistent_edges.first().map(|defect| Offence::Winding(defect.vertices)))
        .or(flat.copied().map(Offence::Flat))
}

/// A component of the hull that is wound inwards though it lies outside all others, or outwards though it lies inside one; by
/// its lowest face.
fn nested(hull: &TriangleMesh, inspection: &Inspection, hierarchy: &MeshHierarchy) -> Option<FaceId> {
    let mut connected = connected_vertices(hull);
    let component_of: Vec<u32> = hull.triangles().iter().map(|&[vertex, _, _]| connected.find(vertex)).collect();
    let is_nested = |component: &&silhouette_core::inspect::Component| {
        let of_component = component_of[component.first_face.index()];
        let point = hull.corners(component.first_face)[0];
        let around = winding_number(hull, hierarchy, point, |face| component_of[face.index()] != of_component);
        let is_outward = component.volume.is_some_and(|volume| volume > 0.0);
        around != Some(if is_outward { 0 } else { 1 })
    };
    inspection.components.iter().find(is_nested).map(|component| component.first_face)
}

/// Edges that touch faces.
#[derive(Default)]
struct Contacts {
    count: usize,
    first: Option<([VertexId; 2], FaceId)>,
}

/// Those of the edges for which `contact` yields a face.
fn contacts(
    edges: &[[u32; 2]],
    progress: &dyn Progress,
    contact: impl Fn([u32; 2]) -> Option<FaceId> + Sync,
) -> Result<Contacts, Cancelled> {
    let of_task = |edges: &[[u32; 2]]| {
        progress.check()?;
        Ok(edges.iter().fold(Contacts::default(), |mut contacts, &edge| {
            if let Some(face) = contact(edge) {
                contacts.count += 1;
                contacts.first = contacts.first.or(Some((edge.map(VertexId::new), face)));
            }
            contacts
        }))
    };
    let tasks: Vec<Contacts> = edges.par_chunks(EDGES_PER_TASK).map(of_task).collect::<Result<_, Cancelled>>()?;
    let join = |a: Contacts, b: Contacts| Contacts { count: a.count + b.count, first: a.first.or(b.first) };
    Ok(tasks.into_iter().fold(Contacts::default(), join))
}

/// The lowest face of a hierarchy that an edge of a mesh touches.
fn contact(mesh: &TriangleMesh, edge: [u32; 2], faces: &MeshHierarchy) -> Option<FaceId> {
    let ends = edge.map(|vertex| mesh.positions()[vertex as usize]);
    let mut lowest: Option<FaceId> = None;
    faces.near_segment(ends, |face, corners| {
        if lowest.is_none_or(|lowest| face < lowest) && touches(ends, corners) {
            lowest = Some(face);
        }
    });
    lowest
}

/// The lowest face of a mesh that one of its own edges touches elsewhere than in shared corners.
fn self_contact(mesh: &TriangleMesh, hierarchy: &MeshHierarchy, edge: [u32; 2]) -> Option<FaceId> {
    let ends = edge.map(|vertex| mesh.positions()[vertex as usize]);
    let mut lowest: Option<FaceId> = None;
    hierarchy.near_segment(ends, |face, corners| {
        if lowest.is_none_or(|lowest| face < lowest) && meets(edge, ends, mesh.triangles()[face.index()], corners) {
            lowest = Some(face);
        }
    });
    lowest
}
