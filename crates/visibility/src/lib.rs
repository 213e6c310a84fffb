//! Exact visible and hidden lines of a triangle mesh.

mod chains;
mod kind;
mod lines;
mod options;

pub use chains::{Chain, ChainStyle, Chains, SegmentSource};
pub use kind::LineKind;
pub use lines::{LineStats, Lines};
pub use options::LineOptions;
