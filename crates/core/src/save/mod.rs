//! Meshes become files: glTF 2.0 in a GLB container, cargo feature `save`.
//!
//! [`write_glb`] writes a mesh with the visibility of its edges, for viewers that draw hard edges and silhouettes by the
//! extension `EXT_mesh_primitive_edge_visibility`; [`load`](crate::load) reads it back. [`GltfArrays`] and [`write_container`] are
//! the parts for documents of another make.

mod arrays;
mod container;
mod edge_codes;
mod glb;

pub use arrays::GltfArrays;
pub use container::write_container;
pub use glb::write_glb;
