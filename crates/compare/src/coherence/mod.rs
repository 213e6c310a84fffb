//! Coherence: what a sequence of pictures does that the truth does not.
//!
//! Single pictures can all be good and their sequence unbearable: lines that wink in and out, and lines that swim beside the shape.
//! No contour-flicker metric was found in the literature; this one is defined in `docs/METRICS.md` so that others can adopt it.
//!
//! 1. [`motion`]: what moves from frame to frame: the camera, or the mesh.
//! 2. [`places`]: the true lines of a frame as places, each standing for a short stretch, with the loop that it belongs to;
//!    [`links`]: which place of the next frame a place becomes.
//! 3. [`drawn`]: what a method drew of a frame: a picture of lines, lines as geometry, or a filled picture.
//! 4. What is counted over all frames: [`movement`] that the truth does not have, [`flicker`], [`loops_lost`].
//! 5. [`metrics`]: the numbers, in one table.
//!
//! All lengths are in pixels of a picture that is 1000 pixels high ([`REFERENCE_HEIGHT_PX`]), whatever the picture at hand, so
//! that numbers of pictures of different sizes can be compared.

pub mod drawn;
pub mod flicker;
pub mod links;
pub mod loops_lost;
pub mod metrics;
pub mod motion;
pub mod movement;
pub mod places;
#[cfg(test)]
mod sample_sequence;

pub use drawn::DrawnFrame;
pub use metrics::{CoherenceMetrics, Observation, Sequence};
pub use motion::Motion;
pub use places::{TrueFrame, TruePlace};

/// Height of the picture whose pixels lengths are stated in.
pub const REFERENCE_HEIGHT_PX: f64 = 1000.0;

/// A true line is drawn at a place if the method's line lies no farther than this from it: three pixels of the picture that
/// is 1000 pixels high, and so one and a half of a picture of 512. Less would count as lost what a raster has moved.
pub const DRAWN_WITHIN: f64 = 3.0;

/// It is bare if no line of the method lies within this distance. Between the two a place is in doubt and counts as neither,
/// so that a line which stays at about one distance does not seem to come and go.
pub const BARE_BEYOND: f64 = 2.0 * DRAWN_WITHIN;

/// Reference pixels per pixel of a picture of this height.
pub fn reference_scale(height_px: u32) -> f64 {
    REFERENCE_HEIGHT_PX / f64::from(height_px)
}
