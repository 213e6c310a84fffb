//! Exact visible and hidden lines of a triangle mesh.

mod cache;
mod chains;
mod contours;
mod curves;
mod cutter;
mod decide;
mod events;
mod face_tree;
mod finder;
mod frame;
mod gaps;
mod intersections;
mod join;
mod kind;
mod lines;
mod options;
mod outline;
mod picture_grid;
mod pieces;
mod propagate;
mod scene;
mod select;
mod sight;
mod stroke;
mod vertex_faces;

pub use cache::LineCache;
pub use chains::{Chain, ChainStyle, Chains, SegmentSource};
pub use face_tree::FaceTree;
pub use finder::{LineError, LineFinder, MAX_PAIRS};
pub use intersections::FaceIntersections;
pub use kind::LineKind;
pub use lines::{LineStats, Lines};
pub use options::LineOptions;
pub use scene::{CurvePiece, LineScene, SceneError};
