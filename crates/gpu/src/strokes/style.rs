//! [`StrokeStyle`]: how lines are drawn.

use crate::color::Color;
use crate::pen::{Pen, PenPlacement};

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

/// What a line renderer draws where the mesh is.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Interior {
    /// The mesh in one colour, hiding what lies behind it: a drawing on paper.
    Paper(Color),
    /// No colour, but depth: the mesh hides what is drawn later, and a transparent ground stays transparent.
    DepthOnly,
    /// Nothing: lines over the caller's own shading.
    #[default]
    None,
}

/// How lines are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrokeStyle {
    /// Width, in pixels of the target, and placement.
    pub pen: Pen,
    /// Ink. Where it is translucent, strokes that overlap darken each other.
    pub ink: Color,
    /// Turns.
    pub join: Join,
    /// Ends.
    pub cap: Cap,
    /// Parts that the mesh covers.
    pub hidden: Hidden,
    /// What is drawn where the mesh is.
    pub interior: Interior,
}

impl Default for StrokeStyle {
    /// Black, 1.5 px, centred, everything round, hidden parts removed, no interior.
    fn default() -> Self {
        Self {
            pen: Pen { width_px: 1.5, placement: PenPlacement::Centred },
            ink: Color::BLACK,
            join: Join::default(),
            cap: Cap::default(),
            hidden: Hidden::default(),
            interior: Interior::default(),
        }
    }
}
