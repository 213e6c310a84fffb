//! Polylines as strokes of exact pixel width.
//!
//! 1. [`line_segments`]: project, clip, drop sub-pixel steps; one quad for each segment that is left.
//! 2. [`line_joins`]: a wedge on the outer side of every turn.
//! 3. [`line_visibility`]: which fragments the mesh hides.
//!
//! [`pipelines`], [`renderer`]: the steps on a device.

mod instances;
mod line_joins;
mod line_segments;
mod line_visibility;
mod pipelines;
mod polylines;
mod renderer;
mod scene_depth;
mod style;

pub use line_segments::{Projector, ScreenSegment};
pub use line_visibility::{DepthScale, SceneDepth};
pub use pipelines::StrokePipelines;
pub use polylines::Polylines;
pub use renderer::StrokeRenderer;
pub use style::{Cap, Hidden, Interior, Join, StrokeStyle};
