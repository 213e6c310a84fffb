#![doc = include_str!("../README.md")]
//!
//! # Methods
//!
//! | method | draws | ink lies | lines inside of the outline | cost of a wide line |
//! |---|---|---|---|---|
//! | [`InvertedHull`] | the mesh's back faces, pushed outwards | outside | where a part stands before another | none |
//! | [`GbufferFilter`] | steps in depth and turns of normals that a filter finds | on both sides | the same, from a threshold on | one pass per doubling |
//! | [`JumpFlood`] | what lies around an object, or around each object of a group | outside | none | one pass per doubling |
//! | [`FineMesh`] | the mesh itself, rasterised: what a filled outline of a coarse mesh is compared with | | | |
//! | [`LodMesh`] (feature `simplify`) | a level of a chain of simplified meshes, chosen for each view | | | |
//!
//! The first three draw into a render pass of the application's, by the convention of `silhouette-gpu` (feature `gpu`), with the same
//! options for width, ink and interior. The example `outlines` is a whole application. What each costs and leaves out stands with its type.

#[cfg(feature = "gpu")]
mod distance_field;
mod fine_mesh;
pub mod gbuffer_filter;
pub mod inverted_hull;
pub mod jump_flood;
mod line_options;
#[cfg(feature = "gpu")]
mod line_style;
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
