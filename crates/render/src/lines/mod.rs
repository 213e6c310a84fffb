//! Polylines as strokes of exact pixel width.
//!
//! 1. [`line_segments`]: project, clip, drop sub-pixel steps; one quad for each segment that is left.
//! 2. [`line_joins`]: a wedge on the outer side of every turn.
//! 3. [`line_visibility`]: which fragments the mesh hides.

pub(crate) mod line_joins;
pub(crate) mod line_segments;
pub(crate) mod line_visibility;
mod pass;
mod polylines;

pub use line_segments::ScreenSegment;
pub use pass::LinePass;
pub use polylines::Polylines;

use silhouette_gpu::{Pen, PenPlacement};

/// How the gap on the outer side of a turn is filled.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Join {
    /// By a sector of a disc.
    #[default]
    Round,
    /// By prolonging the strokes' outer sides until they meet, as long as the tip is no farther from the corner than
    /// `limit` times the stroke's reach on that side; otherwise as [`Bevel`](Self::Bevel).
    Miter {
        /// At least 1; 4 is usual.
        limit: f32,
    },
    /// By a triangle.
    Bevel,
}

/// How an open polyline ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Cap {
    /// At its end point.
    Butt,
    /// By half a disc beyond it.
    #[default]
    Round,
}

/// What happens to the parts of a line that the mesh covers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Hidden {
    /// They are left out.
    #[default]
    Removed,
    /// They are drawn like the others.
    Drawn,
}

/// How lines are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineStyle {
    /// Width, in pixels of the camera's viewport, and placement.
    pub pen: Pen,
    /// Ink, opaque: what the format stores for `Unorm`, linear for `Srgb`.
    pub color: [f32; 4],
    /// Turns.
    pub join: Join,
    /// Ends.
    pub cap: Cap,
    /// Parts that the mesh covers.
    pub hidden: Hidden,
}

impl Default for LineStyle {
    /// Black, 1.5 px, centred, everything round, hidden parts removed.
    fn default() -> Self {
        Self {
            pen: Pen { width_px: 1.5, placement: PenPlacement::Centred },
            color: [0.0, 0.0, 0.0, 1.0],
            join: Join::Round,
            cap: Cap::Round,
            hidden: Hidden::Removed,
        }
    }
}
