//! What published methods are measured against.
//!
//! [`FineMesh`]: the mesh itself, rasterised. A method that fills the outline of a coarse mesh as a finer one would have it is
//! compared with that finer mesh, drawn by this.

mod fine_mesh;

pub use fine_mesh::{FineMesh, FineMeshOptions, Shading};
