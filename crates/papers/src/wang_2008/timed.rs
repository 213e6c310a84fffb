//! Frames of all methods of Table I, in turn.

use super::copies::{Copies, FrameTime, Model};
use super::subjects::Subject;
use super::window::{Kind, Window};
use crate::error::Cause;
use crate::table::Range;
use silhouette_compare::drawing::DrawError;
use silhouette_core::Progress;
use silhouette_core::glam::DVec3;
use silhouette_gpu::MeshBuffers;
use silhouette_render::Gpu;
use silhouette_smoothing::{BoundaryCurve, PnTriangles, Smoothing};
use std::sync::Arc;

/// Median milliseconds of a frame by each method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameTimes {
    /// The coarse mesh as it is, with interpolated normals.
    pub direct: FrameTime,
    /// Boundary curves.
    pub boundary_curve: FrameTime,
    /// PN triangles.
    pub pn: FrameTime,
    /// Ours, in parallel projection.
    pub orthographic: FrameTime,
    /// Ours, in perspective.
    pub perspective: FrameTime,
}

/// Where the eye is, as seen from the middle: level with a circle a third of a turn above the horizon, a degree on per frame.
pub fn on_path(frame: u32) -> DVec3 {
    let (sine, cosine) = f64::from(frame).to_radians().sin_cos();
    DVec3::new(sine, 0.35, cosine)
}

/// Draws by every method in turn, `rounds` times, so that a change of the machine's speed affects all alike. In a round each draws
/// two frames, of which the second is timed. The eye moves on by a degree from frame to frame, so that nothing made for one view
/// serves the next.
///
/// # Errors
/// [`Cause`]: cancelled, or a device that failed or cannot hold the mesh.
pub fn time(
    gpu: &Gpu,
    window: &Window,
    subject: &Subject,
    rounds: u32,
    progress: &dyn Progress,
) -> Result<FrameTimes, Cause> {
    let mesh = &subject.mesh;
    let buffers = Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh.mesh()).map_err(DrawError::from)?);
    let model = Model { mesh, buffers: &buffers, copies: subject.copies };
    let crease = format!("crease={}", subject.crease_deg);
    let with = |words: &str| format!("{words} {crease}");
    let mut drawn = [
        // No points inserted: the same vertices and the same shader as all others, made once.
        (Kind::Perspective, Copies::new::<PnTriangles>(gpu, model, &with("level=0"))?),
        (Kind::Perspective, Copies::new::<BoundaryCurve>(gpu, model, &crease)?),
        (Kind::Perspective, Copies::new::<PnTriangles>(gpu, model, &with(&format!("level={}", subject.pn_level)))?),
        (Kind::Orthographic, Copies::new::<Smoothing>(gpu, model, &crease)?),
        (Kind::Perspective, Copies::new::<Smoothing>(gpu, model, &crease)?),
    ];
    let mut samples = [const { Vec::new() }; 5];
    for round in 0..rounds {
        progress.check()?;
        for ((kind, copies), samples) in drawn.iter_mut().zip(&mut samples) {
            copies.frame(gpu, &window.camera(on_path(2 * round), *kind)?)?;
            let time = copies.frame(gpu, &window.camera(on_path(2 * round + 1), *kind)?)?;
            samples.push(time);
        }
        progress.advance(1);
    }
    let [direct, boundary_curve, pn, orthographic, perspective] = samples.map(|samples| median(&samples));
    Ok(FrameTimes { direct, boundary_curve, pn, orthographic, perspective })
}

fn median(samples: &[FrameTime]) -> FrameTime {
    let of = |part: fn(&FrameTime) -> f64| {
        Range::of(samples.iter().map(part), "rounds").map_or(f64::NAN, |range| range.median)
    };
    FrameTime { prepare_ms: of(|time| time.prepare_ms), frame_ms: of(|time| time.frame_ms) }
}
