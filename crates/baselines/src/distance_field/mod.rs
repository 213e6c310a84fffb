//! The field of nearest seeds around a view, which `jump-flood` and `gbuffer-filter` draw lines of any width from.
//!
//! 1. A stage of the method plants seeds on lines, at fractions of a pixel ([`Field::planted`]).
//! 2. `flood.rs`: each pixel finds the nearest seed, in `log2(reach) + 2` passes whatever the picture holds.
//! 3. A stage of the method inks each pixel that is near enough to its seed ([`Field::known`]).
//!
//! The field reaches beyond the viewport on all sides, so that lines of what lies just outside are drawn within it.

mod field;
mod flood;
mod offscreen;
mod reach;
mod uniform;

pub(crate) use field::{Field, FieldLayouts, check_size};
pub(crate) use flood::FloodStage;
pub(crate) use offscreen::{OFFSCREEN_DEPTH, Offscreen};
#[cfg(feature = "simplify")]
pub(crate) use reach::nearest_depth;
pub(crate) use reach::{Extent, widest_px};
pub(crate) use uniform::{FieldUniform, Rim};
