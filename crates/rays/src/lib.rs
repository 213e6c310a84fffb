#![doc = include_str!("../README.md")]
//!
//! # What lies where
//!
//! [`hierarchy`] builds hierarchies over boxes of which many may be equal, by `obvhs`; [`mesh_hierarchy`] one over the faces of
//! a mesh, with questions about distances ([`distance`]) and segments (`segment.rs`). [`ray`] finds where rays meet a mesh.

pub mod distance;
pub mod hierarchy;
pub mod mesh_hierarchy;
pub mod ray;
mod segment;

pub use distance::Nearest;
pub use mesh_hierarchy::MeshHierarchy;
pub use ray::RayCaster;
