//! [`GbufferFilter`]: lines where neighbouring pixels do not belong together.
//!
//! 1. `gbuffer.rs`: depth and normal of the mesh at each pixel, in textures of its own.
//! 2. `discontinuities.rs`: a filter finds where depth steps or normals turn.
//! 3. `distance_field`: each pixel finds the nearest of those places by jump flooding.
//! 4. `filter_ink.rs`: pixels within half of the width are inked.
//!
//! # Departures from Saito and Takahashi
//! 1. They enhance a shaded picture by what the filter yields, in greys; here a threshold decides, and lines have a width.
//! 2. Their first-order operator grows with the slant of a surface, and they weigh it by the range around the pixel. Here a step in
//!    depth counts as far as it exceeds the steps beside it, which is nothing on a plane however slanted: depth is taken as its
//!    reciprocal, in which planes are linear over a perspective image.
//! 3. The threshold is a share of the mesh's radius, so that a mesh has the same lines in any unit and at any distance.
//! 4. Turns of the normal, which engines look for beside depth, are found as well (`edges=all`).
//! 5. Engines widen lines by looking farther around each pixel, which costs the square of the width; here the cost of a width is its
//!    logarithm.

mod method;

#[cfg(feature = "gpu")]
mod discontinuities;
#[cfg(feature = "gpu")]
mod filter_ink;
#[cfg(feature = "gpu")]
mod gbuffer;
#[cfg(feature = "gpu")]
mod renderer;

pub use method::{FilteredEdges, GbufferFilter, GbufferFilterOptions, Operator};
#[cfg(feature = "gpu")]
pub use renderer::{GbufferFilterPipelines, GbufferFilterRenderer};
