//! Frames of several methods, in turn.

use super::drawn::{camera, farther};
use crate::directions::spread;
use crate::drawings;
use crate::error::Cause;
use silhouette_compare::drawing::Drawing;
use silhouette_core::{Progress, TriangleMesh};
use silhouette_render::Gpu;

/// Median milliseconds of a frame by each method, drawn in turn from `rounds` sides, `distance` times as far as where the bounding
/// sphere fits the picture, as [`drawings::time`] times them.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed.
pub fn time<const N: usize>(
    gpu: &Gpu,
    fine: &TriangleMesh,
    mut drawings: [&mut Drawing; N],
    distance: f64,
    rounds: u32,
    progress: &dyn Progress,
) -> Result<[f64; N], Cause> {
    let cameras = spread(rounds).map(|direction| farther(&camera(fine, direction)?, distance));
    let cameras: Vec<_> = cameras.collect::<Result<_, _>>()?;
    let medians = drawings::time(gpu, &cameras, &mut drawings, progress)?;
    Ok(std::array::from_fn(|at| medians[at]))
}
