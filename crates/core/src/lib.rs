#![doc = include_str!("../README.md")]
//!
//! # What lies where
//!
//! Read [`method`] first when you add a method: it is the whole contract. The rest, in the order data flows:
//!
//! 1. [`load`]: a file becomes a [`TriangleMesh`] (one cargo feature per format); [`shapes`] generates meshes instead.
//!    [`origin`](mod@origin): from where positions count, for meshes far from zero.
//! 2. [`weld`]: merging of coincident vertices, [`heal`]: mending of T-junctions, both on request only; [`seams`]: what welding would close. [`inspect`]: what is wrong with a mesh, with ids.
//! 3. [`topology`]: edges with all their incident faces, twin half-edges; [`feature_edges`](mod@feature_edges): those at which the surface is sharp; [`face_normal`](mod@face_normal). [`subdivide`]: a finer, smoother mesh; `simplify`: a coarser one (cargo feature `simplify`).
//! 4. [`view`]: the [`Viewpoint`] that decides facing, and the [`Camera`] around it.
//! 5. [`orientation`]: the exact predicate on four points, or three as seen from a viewpoint; [`displaced`]: the same for a viewer in general position. [`facing`]: front or back, by the exact sign, for every face; [`facing_memo`]: for those that somebody asks about.
//! 6. [`silhouette`]: the silhouette edges of a facing; [`loops`]: the same edges as closed, oriented loops; [`curves`]: silhouettes as smooth pieces.
//! 7. [`prepared`]: artefacts derived from a mesh, each built the first time something asks for it.
//! 8. `save`: a mesh with its hard edges and silhouettes becomes a file (cargo feature `save`).
//!
//! Cost is stated in faces F, edges E, vertices V and silhouette edges S. Every result is the same bits for any number
//! of threads. Nothing here knows about a GPU. Only the feature `simplify` needs a C++ compiler.

pub mod curves;
pub mod disjoint_sets;
pub mod displaced;
#[cfg(any(feature = "gltf", feature = "save"))]
mod edge_visibility;
mod exact;
pub mod face_normal;
pub mod facing;
pub mod facing_memo;
pub mod feature_edges;
pub mod heal;
pub mod id;
pub mod inside_out;
pub mod inspect;
pub mod line_style;
pub mod load;
pub mod loops;
pub mod mesh;
pub mod method;
pub mod morton;
pub mod orientation;
pub mod origin;
pub mod prepared;
pub mod progress;
#[cfg(feature = "save")]
pub mod save;
pub mod seams;
pub mod shapes;
pub mod silhouette;
#[cfg(feature = "simplify")]
pub mod simplify;
pub mod subdivide;
pub mod topology;
pub mod view;
pub mod weld;

pub use glam;

pub use curves::SilhouetteCurves;
pub use disjoint_sets::DisjointSets;
pub use displaced::DisplacedViewer;
pub use facing::{FaceFacings, Facing, FacingRule};
pub use facing_memo::FacingMemo;
pub use id::{EdgeId, FaceId, HalfEdgeId, PerElement, VertexId};
pub use loops::SilhouetteLoops;
pub use mesh::{MeshError, TriangleMesh};
pub use method::{
    ExtractsCurves, ExtractsEdges, ExtractsLoops, Method, MethodGuide, MethodInfo, MethodOptions, NoOptions,
};
pub use prepared::PreparedMesh;
pub use progress::{Cancelled, NoProgress, Progress, Quiet};
pub use silhouette::{SilhouetteEdges, silhouette_edges};
pub use topology::Topology;
pub use view::{Camera, Projection, Viewpoint};
