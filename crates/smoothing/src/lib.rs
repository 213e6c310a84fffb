//! Smooth silhouettes for coarse triangle meshes.
#![allow(missing_docs, reason = "under construction")]
pub mod bridges;
pub mod concavity;
pub mod curves;
pub mod eye;
pub mod feature_edges;
pub mod feature_polylines;
pub mod feature_samples;
pub mod feature_segments;
pub mod hermite;
pub mod options;
pub mod outward;
pub mod perturbation;
pub mod remeshing;
pub mod sampling;
pub mod shading_mesh;
pub mod shading_normals;
pub mod silhouette_points;
pub mod silhouette_segments;
pub mod silhouette_triangles;
pub mod smoothing;
pub mod vertex_visibility;
pub mod view_mesh;

pub use eye::{Eye, SmoothingView};
pub use hermite::Hermite;
pub use options::SmoothingOptions;
pub use shading_mesh::ShadingMesh;
pub use smoothing::Smoothing;
pub use view_mesh::{Origin, Remesher, ViewMesh};

#[cfg(feature = "gpu")]
mod fills_image;
#[cfg(feature = "gpu")]
pub mod gpu;
#[cfg(feature = "gpu")]
pub mod view_mesh_renderer;
#[cfg(feature = "gpu")]
pub use fills_image::{ImagePipelines, ImageRenderer};
#[cfg(feature = "gpu")]
pub use gpu::{SmoothingPipelines, SmoothingRenderer};
#[cfg(feature = "gpu")]
pub use view_mesh_renderer::{ViewMeshPipelines, ViewMeshRenderer};

#[cfg(test)]
mod tests;
