//! The whole method on the GPU: a frame's triangles are made by compute stages and drawn by an indirect draw. Nothing is read
//! back, and the CPU does nothing per vertex or face.
//!
//! | step | stage | invocations |
//! |---|---|---|
//! | shading normals, of moved meshes only | `shading_normals.wgsl` | shading vertices |
//! | feature segments, of moved meshes only | `feature_segments.wgsl` | feature edges |
//! | vertex visibility | `vertex_visibility.wgsl` | shading vertices |
//! | silhouette points | `silhouette_points.wgsl` | edges; half-edges on feature edges |
//! | samples of feature segments, counted | `feature_samples.wgsl` | feature edges |
//! | silhouette segments, sampling, concavity, triangles counted | `silhouette_segments.wgsl` | faces |
//! | where each face's triangles begin | `prefix_sum.wgsl` | feature edges and faces |
//! | samples of feature segments, placed | `feature_samples.wgsl` | feature edges |
//! | perturbation | `perturbation.wgsl` | vertices |
//! | local re-meshing | `remeshing.wgsl` | faces |
//!
//! Differences from the CPU:
//!
//! 1. Arithmetic in 32 bits, in the mesh's [`LocalFrame`](silhouette_gpu::LocalFrame). A vertex whose normal is perpendicular
//!    to the view up to rounding may get the other sign; the triangles join in either case, as everything is derived from one
//!    bit per shading vertex, and every point that several faces share is computed once.
//! 2. Every vertex is tested; there are no clusters.
//! 3. There is room for a bounded number of triangles, [`Room`]. In a frame that would exceed it, each curve becomes one straight
//!    piece.
//! 4. Triangles with two equal corners are written, and draw nothing; so are those that are left out.
//! 5. Of a mesh whose vertices move on the device, normals and feature segments follow them. Which edges are feature edges, and
//!    how they are chained, stays as it is at rest.

mod buffers;
mod fills_image;
mod pipelines;
mod prefix_sum;
mod renderer;
mod room;
mod settings;
mod tables;

#[cfg(test)]
mod tests;

pub use fills_image::{ImagePipelines, ImageRenderer};
pub use pipelines::SmoothingPipelines;
pub use renderer::SmoothingRenderer;
pub use room::Room;
