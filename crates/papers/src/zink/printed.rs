//! The arithmetic of the article.

/// Bytes of one of the article's vertices: position, normal and tangent of three floats each, and the ridge flag.
pub const VERTEX_BYTES: u64 = 40;

/// Vertices per edge.
pub const VERTICES_PER_EDGE: u64 = 4;

/// Triangles per edge.
pub const TRIANGLES_PER_EDGE: u64 = 2;

/// How far a vertex is moved along its normal, in units of the mesh, over its distance from the eye.
pub const EXTEND: f64 = 0.1 / 75.0;
