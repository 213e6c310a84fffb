#![doc = include_str!("../README.md")]
//!
//! # What lies where
//!
//! [`hierarchy`] builds hierarchies over boxes of which many may be equal, by `obvhs`; [`mesh_hierarchy`] one over the faces of
//! a mesh, which finds what is near a point ([`distance`]), a segment (`segment.rs`) or a triangle (`triangle.rs`). [`ray`] finds where rays meet a mesh.

pub mod distance;
pub mod hierarchy;
pub mod mesh_hierarchy;
pub mod ray;
mod segment;
mod triangle;

pub use distance::Nearest;
pub use mesh_hierarchy::MeshHierarchy;
pub use ray::RayCaster;
