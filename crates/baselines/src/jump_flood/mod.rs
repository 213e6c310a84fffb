//! [`JumpFlood`]: outlines of objects, of any width at nearly the same cost.
//!
//! 1. `object_mask.rs`: the objects of a group, each in its number, with four samples per pixel.
//! 2. `border_seeds.rs`: seeds where an object's border runs through a pixel, found from how many of its samples the object covers.
//! 3. `distance_field`: each pixel finds the nearest seed by jump flooding.
//! 4. `outline_ink.rs`: pixels within the width of their seed are inked, outside of the seed's object.
//!
//! # Departures from Rong and Tan, and from what engines do
//! 1. Engines flood one mask, so that objects which touch or overlap in the image become one. Here each pixel that an object covers
//!    takes seeds of objects in front of it alone: every object has its own outline, over those behind it.
//! 2. Seeds lie at fractions of a pixel, as in Ben Golus's "The quest for very wide outlines" (2020), found by Gustavson and Strand's
//!    formula instead of a Sobel filter.
//! 3. Fragments have the depth of their seed, so that whatever stands before the object hides its outline as well.

mod method;

#[cfg(feature = "gpu")]
mod border_seeds;
#[cfg(feature = "gpu")]
mod group;
#[cfg(feature = "gpu")]
mod object_mask;
#[cfg(feature = "gpu")]
mod outline_ink;

#[cfg(feature = "gpu")]
pub use group::{JumpFloodGroup, JumpFloodPipelines, JumpFloodRenderer};
pub use method::{Antialiasing, JumpFlood, JumpFloodOptions};
