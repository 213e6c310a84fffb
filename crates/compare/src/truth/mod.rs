//! The true visible lines of a view, in pixels: what a drawn picture is measured against.
//!
//! 1. The exact visible lines of `silhouette-visibility`, as chains.
//! 2. [`visible`]: the chains as lines with the front face on their left, each part of an edge once;
//!    [`samples`]: points along them.
//! 3. [`pen`]: the lines drawn with a method's own kind of pen; [`coverage`]: the exact share of each pixel's area.
//!
//! What is known to make methods err: [`mesh_facts`] of a mesh's edges and faces, [`view_facts`] of the lines of a view,
//! [`sight`]: which face a pixel shows.
//!
//! [`finder`] takes the steps in order. No step looks at a picture or needs a device. The truth of filled pictures is a
//! picture itself: [`fill`].

pub mod coverage;
pub mod fill;
pub mod finder;
pub mod mesh_facts;
pub mod pen;
pub mod samples;
pub mod sight;
pub mod view_facts;
pub mod visible;

pub use finder::{Truth, TruthError, TruthFinder};
pub use samples::{Run, SPACING_PX, TrueLines, TrueSample};
