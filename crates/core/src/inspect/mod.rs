//! What a mesh is and what is wrong with it: counts, components, genus, boundary, and every defect with its element ids.
//!
//! Nothing here is a refusal. Open, non-manifold, degenerate and inconsistently wound meshes are ordinary data to every
//! method; [`inspect`] explains what they will meet. Words, as used in every field below:
//!
//! - A *boundary edge* has one face, an *interior edge* two, a *non-manifold edge* three or more. The side of a face from
//!   a vertex to itself is no edge here; it is reported as [`Defects::repeated_vertex_faces`].
//! - A *component* is a set of faces connected through shared edges. Surfaces that touch in a vertex only are two
//!   components.
//! - A *fan* is a set of faces around one vertex connected through their edges at that vertex.
//! - *Closed*: there are faces, and every edge has at least two.

mod boundary;
mod components;
mod defects;
mod faces;
mod fans;
mod folds;
mod measure;
mod patches;
mod vertices;

#[cfg(test)]
mod tests;

pub use boundary::BoundaryLoop;
pub use components::Component;
pub use defects::{Defects, EdgeDefect};
pub use faces::has_zero_area;
pub use measure::{EdgeLengths, Extent, SmallestAngle};

use crate::heal::{TJunctions, find_t_junctions};
use crate::id::{EdgeId, HalfEdgeId};
use crate::inside_out::Parts;
use crate::mesh::TriangleMesh;
use crate::progress::{Cancelled, NoProgress, Progress};
use crate::seams::OpenSeams;
use crate::topology::Topology;
use crate::weld::weld_exact;

/// What [`inspect`] found. Plain data: serialise it, or print its fields.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Inspection {
    /// Vertices, unreferenced ones included.
    pub vertices: usize,
    /// Edges.
    pub edges: usize,
    /// Faces.
    pub faces: usize,
    /// Edges with exactly one face.
    pub boundary_edges: usize,
    /// Whether there are faces and every edge has at least two.
    pub is_closed: bool,
    /// Whether no edge has three faces and the faces around each vertex form a single fan.
    pub is_manifold: bool,
    /// Whether the faces at every interior edge agree on which side is out.
    pub is_consistently_wound: bool,
    /// Whether reversing some faces would make them agree. A Möbius strip is not orientable.
    pub is_orientable: bool,
    /// Faces of parts that are [wound inside out](crate::inside_out): exact for closed parts, a guess for open ones.
    pub inside_out_faces: usize,
    /// Closed parts that are walls of cavities, which rightly point inward.
    pub cavities: usize,
    /// Boundary edges that welding would join; `None` if there are none.
    pub seams: Option<OpenSeams>,
    /// Vertices on boundary edges that they do not divide, once seams of distance 0 are closed; `None` if there are none.
    pub t_junctions: Option<TJunctions>,
    /// Referenced vertices - edges + faces.
    pub euler_characteristic: i64,
    /// Sum of the components' genera; `None` if one of them has none, or there is no face.
    pub genus: Option<u64>,
    /// From where the mesh's positions count, in the coordinates of its file; zero unless it lies far from there.
    pub origin: [f64; 3],
    /// Box around the vertices that faces use; `None` without faces.
    pub extent: Option<Extent>,
    /// Edge lengths in object units; `None` without edges.
    pub edge_lengths: Option<EdgeLengths>,
    /// The sharpest corner of the faces that have an area; `None` without such faces.
    pub smallest_angle: Option<SmallestAngle>,
    /// Surfaces connected through edges, by their lowest face.
    pub components: Vec<Component>,
    /// Boundaries, by their lowest half-edge.
    pub boundary_loops: Vec<BoundaryLoop>,
    /// Everything that is wrong.
    pub defects: Defects,
}

/// Examines `mesh`, of which `topology` must be the topology.
///
/// Every list is sorted by element id, every number is the same bits for any number of threads. Zero-area faces are
/// found by exact arithmetic. O(F log d + V log V) for the highest vertex degree d, without recursion.
///
/// # Panics
/// If `topology` belongs to another mesh.
pub fn inspect(mesh: &TriangleMesh, topology: &Topology) -> Inspection {
    inspect_with_progress(mesh, topology, &NoProgress).expect("nobody cancels")
}

/// Like [`inspect`], but stops between its steps when `progress` asks to.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
///
/// # Panics
/// As [`inspect`].
pub fn inspect_with_progress(
    mesh: &TriangleMesh,
    topology: &Topology,
    progress: &dyn Progress,
) -> Result<Inspection, Cancelled> {
    assert_eq!(topology.half_edge_count(), 3 * mesh.face_count(), "the topology belongs to another mesh");
    let sides = Sides { mesh, topology };
    // Each step is reported to `progress`.
    progress.stage("inspecting", 8);
    let done = || {
        progress.advance(1);
        progress.check()
    };
    let patches = patches::flood(sides);
    done()?;
    let fans = fans::find(sides);
    done()?;
    let boundary_loops = boundary::chain(sides);
    done()?;
    let defects = defects::find(sides, &fans);
    done()?;
    let components = components::describe(sides, &patches, &fans, &boundary_loops, &defects);
    done()?;

    let (seams, t_junctions) = if boundary_loops.is_empty() {
        (None, None)
    } else {
        let seams = OpenSeams::of(mesh, topology);
        progress.check()?;
        let welded = weld_exact(mesh).mesh;
        progress.check()?;
        let t_junctions = find_t_junctions(&welded, &Topology::new(&welded));
        (Some(seams).filter(|seams| seams.edges > 0), t_junctions)
    };
    done()?;
    let parts = Parts::new(mesh, topology);
    done()?;
    let (inside_out_faces, cavities) = parts.count(progress)?;
    done()?;
    let edges = components.iter().map(|component| component.edges).sum::<usize>();
    let referenced = mesh.vertex_count() - defects.unreferenced_vertices.len();
    Ok(Inspection {
        vertices: mesh.vertex_count(),
        edges,
        faces: mesh.face_count(),
        boundary_edges: boundary_loops.iter().map(|boundary| boundary.edges).sum(),
        is_closed: mesh.face_count() > 0 && boundary_loops.is_empty(),
        is_manifold: defects.non_manifold_edges.is_empty() && defects.non_manifold_vertices.is_empty(),
        is_consistently_wound: defects.inconsistent_edges.is_empty(),
        inside_out_faces,
        cavities,
        seams,
        t_junctions,
        is_orientable: components.iter().all(|component| component.is_orientable),
        euler_characteristic: referenced as i64 - edges as i64 + mesh.face_count() as i64,
        genus: components.iter().map(|component| component.genus).reduce(|a, b| Some(a? + b?)).flatten(),
        origin: mesh.origin().to_array(),
        extent: Extent::of(mesh),
        edge_lengths: EdgeLengths::of(sides),
        smallest_angle: SmallestAngle::of(mesh),
        components,
        boundary_loops,
        defects,
    })
}

/// A mesh with its topology, and the questions about sides of faces that every step asks.
#[derive(Clone, Copy)]
struct Sides<'a> {
    mesh: &'a TriangleMesh,
    topology: &'a Topology,
}

impl Sides<'_> {
    /// Vertex that a half-edge leaves.
    fn start(self, half_edge: HalfEdgeId) -> u32 {
        self.mesh.triangles()[half_edge.face().index()][half_edge.slot() as usize]
    }

    /// Whether the edge is a side from a vertex to itself, which counts as no edge.
    fn is_collapsed(self, edge: EdgeId) -> bool {
        let [a, b] = self.topology.edges()[edge];
        a == b
    }

    /// Length of an edge in object units.
    fn length(self, edge: EdgeId) -> f64 {
        let [a, b] = self.topology.edges()[edge].map(|v| self.mesh.positions()[v as usize].as_dvec3());
        a.distance(b)
    }
}
