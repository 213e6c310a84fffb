//! Frame times over plain rendering, in the same run.

use crate::table::Range;
use silhouette_compare::drawing::{DrawError, Drawing, FrameStyle, PAPER};
use silhouette_core::view::Camera;
use silhouette_core::{PreparedMesh, Progress};
use silhouette_gpu::MeshBuffers;
use silhouette_render::{Cull, DEFAULT_FORMATS, FillPass, FillStyle, Gpu, Load, PassView, Shade, Target};

/// A mesh drawn without silhouettes, in one colour.
pub struct Plain {
    buffers: MeshBuffers,
    fill: FillPass,
    target: Target,
}

impl Plain {
    /// All of its faces, those culled by `cull` omitted.
    ///
    /// # Errors
    /// [`DrawError`].
    pub fn new(gpu: &Gpu, mesh: &PreparedMesh, style: FrameStyle, cull: Cull) -> Result<Self, DrawError> {
        let fill = FillStyle { shade: Shade::Flat([1.0; 4]), cull };
        Ok(Self {
            buffers: MeshBuffers::new(gpu.device(), gpu.queue(), mesh.mesh())?,
            fill: FillPass::new(gpu, DEFAULT_FORMATS, fill)?,
            target: Target::new(gpu, style.size, DEFAULT_FORMATS)?,
        })
    }

    fn frame_ms(&self, gpu: &Gpu, camera: &Camera) -> Result<f64, DrawError> {
        let view = PassView::new(camera, self.buffers.bounds(), DEFAULT_FORMATS.depth_direction);
        let start = std::time::Instant::now();
        self.fill.prepare(gpu, &self.buffers, &view);
        gpu.draw(&self.target, Load::Clear(PAPER), |pass| self.fill.draw(pass, &self.buffers))?;
        Ok(start.elapsed().as_secs_f64() * 1e3)
    }
}

/// Median milliseconds of a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameTimes {
    /// Without silhouettes, both sides of every face.
    pub plain_ms: f64,
    /// Without silhouettes, front faces only.
    pub plain_culled_ms: f64,
    /// With them, one per drawing.
    pub variants_ms: Vec<f64>,
}

/// Times every drawing in turn, `rounds` times, so that a change of the machine's speed affects all alike; the first round
/// warms up and is left out. Each is drawn twice in a round and timed the second time: a frame of an application follows one
/// of the same drawing, which has left its buffers in the caches.
///
/// # Errors
/// [`DrawError`]; a cancelled run is [`DrawError::Prepare`].
pub fn time(
    gpu: &Gpu,
    camera: &Camera,
    plain: &[Plain; 2],
    drawings: &mut [Drawing],
    rounds: u32,
    progress: &dyn Progress,
) -> Result<FrameTimes, DrawError> {
    let mut samples = vec![Vec::new(); drawings.len() + 2];
    for round in 0..=rounds {
        progress.check().map_err(|cancelled| DrawError::Prepare(cancelled.into()))?;
        let mut times = Vec::with_capacity(samples.len());
        for plain in plain {
            plain.frame_ms(gpu, camera)?;
            times.push(plain.frame_ms(gpu, camera)?);
        }
        for drawing in drawings.iter_mut() {
            drawing.draw(gpu, camera)?;
            times.push(drawing.draw(gpu, camera)?.frame_ms);
        }
        if round > 0 {
            samples.iter_mut().zip(times).for_each(|(samples, time)| samples.push(time));
        }
        progress.advance(1);
    }
    let mut medians =
        samples.into_iter().map(|samples| Range::of(samples, "rounds").map_or(f64::NAN, |range| range.median));
    let mut median = || medians.next().unwrap_or(f64::NAN);
    Ok(FrameTimes { plain_ms: median(), plain_culled_ms: median(), variants_ms: medians.collect() })
}
