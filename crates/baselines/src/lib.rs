//! What published methods are measured against.
//!
//! [`FineMesh`]: the mesh itself, rasterised. A method that fills the outline of a coarse mesh as a finer one would have it is
//! compared with that finer mesh, drawn by this. [`LodMesh`] (cargo feature `simplify`): a chain of simplified meshes, one of
//! which is chosen for each view, as engines do.

#[cfg(feature = "gpu")]
mod distance_field;
mod fine_mesh;
pub mod gbuffer_filter;
pub mod inverted_hull;
pub mod jump_flood;
mod line_options;
#[cfg(feature = "simplify")]
mod lod_chain;
#[cfg(feature = "simplify")]
mod lod_mesh;
#[cfg(all(feature = "simplify", feature = "gpu"))]
mod lod_renderer;
mod shading;

pub use fine_mesh::{FineMesh, FineMeshOptions};
pub use gbuffer_filter::{GbufferFilter, GbufferFilterOptions};
pub use inverted_hull::{InvertedHull, InvertedHullOptions};
pub use jump_flood::{JumpFlood, JumpFloodOptions};
#[cfg(feature = "simplify")]
pub use lod_chain::LodLevel;
#[cfg(feature = "simplify")]
pub use lod_mesh::{LodMesh, LodMeshOptions};
#[cfg(all(feature = "simplify", feature = "gpu"))]
pub use lod_renderer::LodRenderer;
pub use shading::Shading;
