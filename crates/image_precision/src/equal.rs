//! Section 3.1: back faces where their depth *equals* what front faces left. A negative control.
//!
//! The paper expects depths to agree along silhouettes. They do not: a pixel is sampled at its centre, where the back face
//! is strictly behind the front face, however fine the mesh. What little appears comes from coarse depth: 16 bits with a
//! wide range *make* equality where 24 bits draw nothing. So this variant draws (almost) nothing, at any precision.

/// Pixels of ink that the method leaves on a mesh that is seen at more than a pixel a face, in exact arithmetic: none.
pub const PREDICTED_INK_PX: u32 = 0;
