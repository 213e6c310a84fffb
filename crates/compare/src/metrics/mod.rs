//! How good a drawn picture is: one small function per metric, each with a unit, a range and a test that makes a picture
//! worse and watches the number move.
//!
//! Pictures of lines ([`lines`]):
//!
//! 1. [`ink`]: a picture becomes coverage per pixel.
//! 2. [`share`]: how much of the truth is missed, how much ink is spurious.
//! 3. [`separation`]: Chamfer and Hausdorff distance, over [`distance_transform`].
//! 4. [`width`]: how wide lines are drawn, and how evenly.
//! 5. [`gaps`]: how often a line is interrupted.
//! 6. [`corners`]: whether lines join where they turn.
//! 7. [`line_errors`]: where pictures err, by kind of line and by what is known to make methods err.
//!
//! Filled pictures ([`fill`]), with coverage as their alpha channel ([`filled_picture`]):
//!
//! 1. [`area`]: what is covered by one of picture and truth, but not by both.
//! 2. [`boundary`]: how far their boundaries lie apart.
//! 3. [`holes`]: pixels left bare inside.
//! 4. [`color`]: how much colours differ.
//!
//! [`point_grid`]: the nearest of many places.
//!
//! [`METRICS`] is the one table of them: results, report and documentation are written from it.

pub mod area;
pub mod boundary;
pub mod color;
pub mod corners;
pub mod distance_transform;
pub mod fill;
pub mod filled_picture;
pub mod gaps;
pub mod holes;
pub mod ink;
pub mod line_errors;
pub mod lines;
pub mod point_grid;
#[cfg(test)]
mod sample_fill;
#[cfg(test)]
mod sample_lines;
pub mod separation;
pub mod share;
pub mod table;
pub mod width;

pub use fill::{FillMetrics, measure_fill};
pub use filled_picture::FilledPicture;
pub use ink::Ink;
pub use line_errors::LineErrors;
pub use lines::{LineMetrics, TruePen, measure};
pub use table::{Better, METRICS, MetricSpec, PictureKind, PictureMetrics, find};
