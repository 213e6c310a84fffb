//! Frame times over plain rendering, in the same run.

use crate::table::Range;
use silhouette_compare::drawing::{DrawError, Drawing, FrameStyle};
use silhouette_core::view::Camera;
use silhouette_core::{PreparedMesh, Progress};
use silhouette_gpu::{Cull, FillPipelines, FillRenderer, FillStyle, FrameRenderer, MeshBuffers};
use silhouette_render::{DEFAULT_FORMATS, Gpu, Load, Target, view_of_mesh};
use std::sync::Arc;

/// A mesh drawn without silhouettes, in one colour.
pub struct Plain {
    mesh: Arc<MeshBuffers>,
    fill: FillRenderer,
    target: Target,
}

impl Plain {
    /// All of its faces, those culled by `cull` omitted.
    ///
    /// # Errors
    /// [`DrawError`].
    pub fn new(gpu: &Gpu, mesh: &PreparedMesh, style: FrameStyle, cull: Cull) -> Result<Self, DrawError> {
        let style_of_fill = FillStyle { cull, ..FillStyle::PAPER };
        let mesh = Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh.mesh())?);
        let pipelines = gpu.scoped(|| FillPipelines::new(gpu.device(), DEFAULT_FORMATS, style_of_fill))?;
        Ok(Self {
            fill: FillRenderer::new(gpu.device(), &Arc::new(pipelines), &mesh),
            mesh,
            target: Target::new(gpu, style.size, DEFAULT_FORMATS)?,
        })
    }

    fn frame_ms(&mut self, gpu: &Gpu, camera: &Camera) -> Result<f64, DrawError> {
        let start = std::time::Instant::now();
        let view = view_of_mesh(camera, &self.mesh)?;
        self.fill.prepare(gpu.device(), gpu.queue(), &view)?;
        let prepare_ms = start.elapsed().as_secs_f64() * 1e3;
        let pass = gpu.draw(&self.target, Load::Clear([1.0; 4]), |pass| self.fill.draw(pass))?;
        Ok(prepare_ms + pass.wall_ms)
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
    plain: &mut [Plain; 2],
    drawings: &mut [Drawing],
    rounds: u32,
    progress: &dyn Progress,
) -> Result<FrameTimes, DrawError> {
    let mut samples = vec![Vec::new(); drawings.len() + 2];
    for round in 0..=rounds {
        progress.check().map_err(|cancelled| DrawError::Prepare(cancelled.into()))?;
        let mut times = Vec::with_capacity(samples.len());
        for plain in plain.iter_mut() {
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
