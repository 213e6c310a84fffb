//! How errors grow with offset, scale, distance, depth bits and the aspect of slivers, beside naive 32-bit arithmetic.
//!
//! [`naive`]: what one would write without thinking, as the control. [`sweeps`]: the scenes. [`measured`]: the series. [`chart`]: their
//! pictures.

pub mod chart;
pub mod measured;
pub mod naive;
pub mod sweeps;

use chart::Chart;
use silhouette_render::Gpu;

/// The folder of the charts, below the project's root.
pub const FOLDER: &str = "docs/images/stability";

/// The charts that no device has a part in, and that are the same bits everywhere.
pub fn exact_charts() -> Vec<Chart> {
    vec![measured::edges(), measured::places()]
}

/// The charts of pictures.
pub fn drawn_charts(gpu: &Gpu) -> Vec<Chart> {
    measured::pictures(gpu)
}
