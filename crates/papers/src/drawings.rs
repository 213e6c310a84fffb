//! What papers that draw share: cameras around a mesh, a method by its name and options, and frames of several methods in turn.

use crate::error::Cause;
use crate::table::Range;
use silhouette_compare::drawing::{Drawing, FrameStyle};
use silhouette_compare::metrics::PictureKind;
use silhouette_compare::registry::Entry;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::method::OptionValues;
use silhouette_core::view::{Camera, Framing};
use silhouette_core::{PreparedMesh, Progress, TriangleMesh};
use silhouette_render::Gpu;
use std::sync::Arc;

/// Vertical field of view in radians: that of every comparison.
pub const FOV_Y_RAD: f64 = std::f64::consts::FRAC_PI_4;

/// The camera in a direction from the middle of a mesh, whose bounding sphere fits the picture.
///
/// # Errors
/// [`Cause`]: no faces.
pub fn camera(mesh: &TriangleMesh, direction: DVec3, fov_y_rad: f64, size: [u32; 2]) -> Result<Camera, Cause> {
    let bounds = mesh.bounds().ok_or(Cause::EmptyMesh)?;
    let up = if direction.normalize().y.abs() > 0.95 { Vec3::X } else { Vec3::Y };
    Ok(Camera::framing(&bounds, direction, up, Framing::Perspective { fov_y_rad }, size)?)
}

/// A method that draws a mesh, with options as words: filled where it can, otherwise as lines.
///
/// # Errors
/// [`Cause`]: options that do not fit, or a device that failed.
pub fn drawing(
    gpu: &Gpu,
    mesh: &Arc<PreparedMesh>,
    entry: &Entry,
    words: &str,
    style: FrameStyle,
    progress: &dyn Progress,
) -> Result<Drawing, Cause> {
    let options = OptionValues::parse(entry.info().options, words.split_whitespace())?;
    let prepared = entry.prepare(mesh, &options, progress)?;
    let kind = if entry.capabilities().fill { PictureKind::Fill } else { PictureKind::Lines };
    Ok(Drawing::new(gpu, mesh, prepared, kind, style)?)
}

/// Median milliseconds of a frame by each drawing, in turn for each camera, so that a change of the machine's speed affects all
/// alike. Each draws every view twice, and the second frame is timed: a frame of an application follows one of the same drawing,
/// which has left its buffers in the caches.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed.
pub fn time(
    gpu: &Gpu,
    cameras: &[Camera],
    drawings: &mut [&mut Drawing],
    progress: &dyn Progress,
) -> Result<Vec<f64>, Cause> {
    let mut samples = vec![Vec::new(); drawings.len()];
    for camera in cameras {
        progress.check()?;
        for (drawing, samples) in drawings.iter_mut().zip(&mut samples) {
            drawing.draw(gpu, camera)?;
            samples.push(drawing.draw(gpu, camera)?.frame_ms);
        }
    }
    let median = |samples| Range::of(samples, "rounds").map_or(f64::NAN, |range| range.median);
    Ok(samples.into_iter().map(median).collect())
}
