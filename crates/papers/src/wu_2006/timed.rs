//! Frames of several methods, in turn.

use super::drawn::{camera, farther};
use crate::directions::spread;
use crate::error::Cause;
use crate::table::Range;
use silhouette_compare::drawing::Drawing;
use silhouette_core::{Progress, TriangleMesh};
use silhouette_render::Gpu;

/// Median milliseconds of a frame by each method, drawn in turn from `rounds` sides, `distance` times as far as where the bounding
/// sphere fits the picture. Each draws every view twice, and the second frame is timed.
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
    let mut samples = [const { Vec::new() }; N];
    for direction in spread(rounds) {
        progress.check()?;
        let near = camera(fine, direction, super::drawn::SIDE_PX)?;
        let camera = farther(&near, distance)?;
        for (drawing, samples) in drawings.iter_mut().zip(&mut samples) {
            drawing.draw(gpu, &camera)?;
            samples.push(drawing.draw(gpu, &camera)?.frame_ms);
        }
    }
    Ok(samples.map(|samples| Range::of(samples, "rounds").map_or(f64::NAN, |range| range.median)))
}
