//! Exact visible and hidden lines of a triangle mesh.

mod chains;
mod contours;
mod events;
mod face_tree;
mod finder;
mod frame;
mod gaps;
mod join;
mod kind;
mod lines;
mod options;
mod picture_grid;
mod pieces;
pub mod plot;
mod propagate;
mod scene;
mod select;
mod sight;
mod stroke;
mod vertex_faces;

pub use chains::{Chain, ChainStyle, Chains, SegmentSource};
pub use face_tree::FaceTree;
pub use finder::{LineError, LineFinder, MAX_PAIRS};
pub use kind::LineKind;
pub use lines::{LineStats, Lines};
pub use options::LineOptions;
pub use scene::{CurvePiece, LineScene, SceneError};
