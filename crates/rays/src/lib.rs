//! Bounding volume hierarchies, and what is asked of a mesh through them.
//!
//! [`hierarchy`] builds hierarchies over boxes of which many may be equal, by `obvhs`. [`ray`] finds where rays meet a mesh.

pub mod hierarchy;
pub mod ray;
