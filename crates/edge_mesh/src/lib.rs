#![doc = include_str!("../README.md")]
//!
//! # The method
//!
//! Every edge of the mesh goes into a second, static mesh. In each frame a
//! stage of the device decides which edges are drawn, and widens those. Here the lines are right in pixels, corners are closed,
//! views from the plane of a face lose nothing, and the mesh may be open, non-manifold, skinned, stretched or mirrored.
//!
//! [`EdgeMesh`] is prepared once per mesh, its pipelines once per set of options, a [`Renderer`] once per instance. In each frame
//! `prepare` uploads the view, `encode` records compute passes, `draw` records lines in a render pass of the caller's
//! (`silhouette_gpu` has the convention). The example `outlines` is an application of its own, `skinned` one with instances that move.
//!
//! # Steps
//!
//! | step | files | where |
//! |---|---|---|
//! | 1. records of all edges | `builder.rs`, `edge_record.rs`, `zero_area.rs` | CPU, once |
//! | 2. facing of every face | `silhouette_core::facing`, or `face_planes.rs` with `oct_normal.rs` | CPU, or device |
//! | 3. which edges are drawn | `drawn_edges.rs`, or `silhouette_chunks.rs` and the vertex stage of step 4 | device |
//! | 4. lines | `lines.rs`, `chunks.rs`, `style.rs` | device |
//!
//! [`as_printed`] is the article's own arithmetic (`arithmetic=as-printed`).
//!
//! # Which edges
//! *Silhouettes*: edges whose faces differ in facing, and boundary edges of front faces. At rest these are the edges that brute
//! force finds, for every view, but around faces without area, which take the facing of a neighbour here. With `boundaries=all` a sheet has an outline from behind, too. *Ridges* and *valleys*: convex and concave
//! edges whose faces' normals make at least an angle, each with its own threshold, width and colour; both are off by default.
//! *Creases*: edges that the mesh's file marks as sharp, drawn as ridges or valleys (`creases=given`). Silhouettes come last and
//! cover the others. Silhouettes lie beyond the front face, ridges and valleys on both sides of their edge.
//!
//! # When to choose it
//! For the same mesh in every frame: games, viewers, many instances. It needs the topology once. Without adjacency, or when it
//! changes, `image-precision` draws the same lines from triangles alone.
//!
//! - `path=compacted`, the default: raster cost follows the edges that are drawn. Faster on llvmpipe at every size measured.
//! - `path=vertex-stage`: no storage that a stage writes, as the article has it; about four vertices per edge of the mesh, of chunks that
//!   hold a silhouette alone while facings are exact.
//! - `facing=exact`, the default: facings of a mesh at rest are exact, 1 bit per face uploaded when the viewpoint changes. Once
//!   positions are replaced, and with `facing=device`, the device decides in 32 bits, and the CPU does nothing per vertex or face.
//! - `cull=auto`, the default: of closed meshes seen from outside the interior draws front faces alone, which is half the work.
//!
//! # Departures from the article
//! 1. The article's E points away from the camera, so that the vertices which its text calls front facing are those of the back face.
//!    Its code is right. Facing here follows the workspace's rule: front is strictly before the plane.
//! 2. Its lines move by a fixed share of the distance to the eye along model-space normals, so that their width depends on the
//!    resolution, the field of view and the angle between the faces. Here lines are expanded in the image plane, in any unit.
//! 3. Distances computed in world space were added in model space, and normals went through the model matrix, which misjudges
//!    faces under non-uniform scale. Here facing is decided in the mesh's own space; mirrors are taken into account.
//! 4. The test "product below 0" loses both edges of a face that is seen edge-on. Here facings are compared.
//! 5. Products of 32-bit planes vanish, overflow, and may differ at both ends of an edge. Here each face is classified once, and
//!    nothing is multiplied or normalised for its sign.
//! 6. Boundary edges were not generated. Here they are drawn where their face is front, or always; an edge with k faces has k - 1 records.
//! 7. Ridges and silhouettes add up to an alpha of 2. Here an edge is one or the other, with colours of their own.
//! 8. Edges that are not drawn were displaced, rasterised and discarded. Here they are not listed, or lie outside the clip volume.
//! 9. Lines had no ends, so that corners gaped. Here ends are rounded.
//! 10. Ridges were decided once. Here a mesh that moves finds them anew, from this frame's normals.
//!
//! # Memory
//! On the device, per edge: 16 bytes for the record (shared by all instances), 4 for the list of silhouettes, 4 for that of ridges and
//! valleys, 2.8 for facings and stored normals: at most 27 bytes, against 160 in the article ([`EdgeMesh::bytes_per_edge`]).
//! Positions and triangles are those of the mesh itself, 12 bytes per vertex and per face.
//!
//! # Limits
//! - Lines have the depth of their edge, moved sideways in the image: wide ones on a surface that curves away may float before it.
//! - Faces without area take the facing of a neighbour ([`EdgeRecord`]s refer to it), found at rest.
//! - A moving mesh is judged in 32 bits: a face within rounding of edge-on may face either way.
//! - Bends of a moving mesh are judged in its own space, so that a model matrix that stretches does not make ridges.
//! - At most 2^29 faces and vertices ([`TooManyElements`]).

#[cfg(feature = "gpu")]
pub mod as_printed;
mod builder;
#[cfg(feature = "gpu")]
mod chunks;
#[cfg(feature = "gpu")]
pub mod drawn_edges;
#[cfg(feature = "gpu")]
mod edge_buffers;
pub mod edge_record;
#[cfg(feature = "gpu")]
pub mod face_planes;
#[cfg(feature = "gpu")]
mod lines;
mod method;
pub mod oct_normal;
pub mod options;
#[cfg(feature = "gpu")]
mod pipelines;
#[cfg(feature = "gpu")]
mod renderer;
#[cfg(feature = "gpu")]
mod silhouette_chunks;
#[cfg(feature = "gpu")]
mod style;
mod zero_area;

pub use edge_record::EdgeRecord;
pub use method::{EdgeMesh, TooManyElements};
pub use options::EdgeMeshOptions;
#[cfg(feature = "gpu")]
pub use pipelines::Pipelines;
#[cfg(feature = "gpu")]
pub use renderer::Renderer;
