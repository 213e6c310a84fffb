//! Meshes become files: glTF 2.0 in a GLB container, cargo feature `save`.
//!
//! [`write_glb`] writes a mesh with the visibility of its edges, for viewers that draw hard edges and silhouettes by the
//! extension `EXT_mesh_primitive_edge_visibility`; [`load`](crate::load) reads it back. [`GltfArrays`] and [`write_container`] are
//! the parts for documents of another make.
//!
//! ```
//! use silhouette_core::feature_edges::feature_edges;
//! use silhouette_core::save::write_glb;
//! use silhouette_core::{Topology, shapes};
//!
//! let mesh = shapes::by_name("gear")?;
//! let topology = Topology::new(&mesh);
//! let is_hard = feature_edges(&mesh, &topology, &[], 30.0); // from 30 degrees
//! let mut glb = Vec::new();
//! write_glb(&mesh, &topology, &is_hard, &mut glb)?;
//! # assert!(glb.starts_with(b"glTF"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod arrays;
mod container;
mod edge_codes;
mod glb;

pub use arrays::GltfArrays;
pub use container::write_container;
pub use glb::write_glb;
