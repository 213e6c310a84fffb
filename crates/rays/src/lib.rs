//! Bounding volume hierarchies, and what is asked of a mesh through them.
//!
//! [`hierarchy`] builds hierarchies over boxes of which many may be equal, by `obvhs`.

pub mod hierarchy;
