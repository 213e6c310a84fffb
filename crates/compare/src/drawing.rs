//! Frames of a prepared method, whatever it yields: edges are drawn as strokes, other methods draw themselves.

pub mod afresh;
mod timed;

use crate::cost::{ExtractionSample, FrameSample};
use crate::metrics::PictureKind;
use crate::registry::{Capabilities, Entry, Prepared};
use silhouette_core::glam::Vec3;
use silhouette_core::method::{ExtractsMovingEdges, OptionValues, PrepareError};
use silhouette_core::view::Camera;
use silhouette_core::{Cancelled, ExtractsEdges, NoProgress, PreparedMesh, Progress, SilhouetteEdges, Topology};
use silhouette_gpu::{
    EdgeRenderer, FrameRenderer, FrameView, FrameViewError, MeshBuffers, MeshTooLarge, Pen, PenPlacement,
    RendererError, StrokePipelines, StrokeRenderer, StrokeStyle, TargetFormats,
};
use silhouette_render::{DEFAULT_FORMATS, Gpu, GpuError, Image, Load, Target};
use std::sync::Arc;
use std::time::Instant;
use timed::Timed;

/// Why a frame cannot be drawn.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DrawError {
    /// The method could not be prepared.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The method yields nothing that could be drawn as this kind of picture.
    #[error("the method yields no {0:?}")]
    Kind(PictureKind),
    /// There is nothing to draw.
    #[error("the mesh has no faces")]
    NoFaces,
    /// The device's buffers cannot hold the mesh.
    #[error(transparent)]
    MeshTooLarge(#[from] MeshTooLarge),
    /// The method's renderer cannot be made on this device.
    #[error(transparent)]
    Renderer(#[from] RendererError),
    /// The camera sees no depths in which the mesh could lie.
    #[error(transparent)]
    View(#[from] FrameViewError),
    /// The device failed.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

impl From<Cancelled> for DrawError {
    fn from(cancelled: Cancelled) -> Self {
        Self::Prepare(cancelled.into())
    }
}

/// How frames are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameStyle {
    /// Viewport in pixels.
    pub size: [u32; 2],
    /// Width of the pen in pixels, for methods that do not bring their own.
    pub pen_width_px: f64,
    /// Samples per pixel, 1 or 4.
    pub samples: u32,
    /// What lies behind the mesh.
    pub ground: Ground,
}

/// What lies behind the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Ground {
    /// White paper.
    #[default]
    Paper,
    /// Nothing: pixels without ink have an alpha of 0.
    Transparent,
}

impl Ground {
    /// What pictures of a kind are measured on.
    pub fn measured(kind: PictureKind) -> Self {
        match kind {
            PictureKind::Lines => Self::Paper,
            PictureKind::Fill => Self::Transparent,
        }
    }

    /// The colour that the target is cleared to.
    fn color(self) -> [f64; 4] {
        match self {
            Self::Paper => [1.0; 4],
            Self::Transparent => [0.0; 4],
        }
    }
}

/// A prepared method with everything it needs to draw frames.
pub struct Drawing {
    target: Target,
    style: FrameStyle,
    kind: PictureKind,
    mesh: Arc<MeshBuffers>,
    below: Vec<Box<dyn FrameRenderer>>,
    source: Source,
    above: Vec<Box<dyn FrameRenderer>>,
}

enum Source {
    Edges(Box<EdgeRenderer<Timed<dyn ExtractsEdges>>>),
    MovingEdges(Box<EdgeRenderer<Timed<dyn ExtractsMovingEdges>>>),
    Own { renderer: Box<dyn FrameRenderer>, placement: PenPlacement },
}

impl Source {
    fn renderer(&mut self) -> &mut dyn FrameRenderer {
        match self {
            Self::Edges(renderer) => &mut **renderer,
            Self::MovingEdges(renderer) => &mut **renderer,
            Self::Own { renderer, .. } => &mut **renderer,
        }
    }
}

impl Drawing {
    /// Sets up buffers, pipelines and targets. Of a method that both draws lines and extracts edges its own lines are drawn.
    ///
    /// # Errors
    /// [`DrawError`], [`DrawError::Kind`] where the method yields no such picture.
    pub fn new(
        gpu: &Gpu,
        mesh: &Arc<PreparedMesh>,
        prepared: Prepared,
        kind: PictureKind,
        style: FrameStyle,
    ) -> Result<Self, DrawError> {
        let formats = TargetFormats { samples: style.samples, ..DEFAULT_FORMATS };
        let buffers = Arc::new(MeshBuffers::new(gpu.device(), gpu.queue(), mesh.mesh())?);
        let own = match kind {
            PictureKind::Lines => {
                prepared.lines().map(|method| Ok((method.renderer(gpu, formats, &buffers)?, method.pen_placement())))
            }
            PictureKind::Fill => {
                prepared.fill().map(|method| Ok((method.renderer(gpu, formats, &buffers)?, PenPlacement::Centred)))
            }
        };
        let source = match own.transpose().map_err(DrawError::Renderer)? {
            Some((renderer, placement)) => Source::Own { renderer, placement },
            None if kind == PictureKind::Lines => {
                let pen = Pen { width_px: style.pen_width_px, placement: PenPlacement::Centred };
                let strokes = StrokeStyle { pen, ..StrokeStyle::default() };
                let pipelines = Arc::new(StrokePipelines::new(gpu.device(), formats, strokes));
                let strokes = StrokeRenderer::new(gpu.device(), &pipelines, &buffers);
                let topology = mesh.artefact::<Topology>("drawing of edges", &NoProgress)?;
                let mesh = Arc::clone(mesh.mesh());
                match prepared.into_moving_edges() {
                    Ok(method) => {
                        let renderer = EdgeRenderer::new(Timed::new(method), mesh, topology, strokes);
                        Source::MovingEdges(Box::new(renderer))
                    }
                    Err(prepared) => {
                        let method = prepared.into_edges().ok_or(DrawError::Kind(kind))?;
                        Source::Edges(Box::new(EdgeRenderer::new(Timed::new(method), mesh, topology, strokes)))
                    }
                }
            }
            None => return Err(DrawError::Kind(kind)),
        };
        gpu.check()?;
        let target = Target::new(gpu, style.size, formats)?;
        Ok(Self { target, style, kind, mesh: buffers, below: Vec::new(), source, above: Vec::new() })
    }

    /// What frames are drawn to.
    pub fn target(&self) -> &Target {
        &self.target
    }

    /// Has the frames to come drawn at another size, in pixels.
    ///
    /// # Errors
    /// [`DrawError::Gpu`]; frames then keep their size.
    pub fn resize(&mut self, gpu: &Gpu, size: [u32; 2]) -> Result<(), DrawError> {
        self.target = Target::new(gpu, size, self.target.formats())?;
        self.style.size = size;
        Ok(())
    }

    /// Has the frames to come drawn with more than the method, in the same pass: `below` before it and `above` after it. Renderers
    /// are made for the [target's formats](Self::target) and the [same mesh](Self::mesh).
    pub fn surround(&mut self, below: Vec<Box<dyn FrameRenderer>>, above: Vec<Box<dyn FrameRenderer>>) {
        (self.below, self.above) = (below, above);
    }

    /// The mesh on the device.
    pub fn mesh(&self) -> &Arc<MeshBuffers> {
        &self.mesh
    }

    /// What the pictures show.
    pub fn kind(&self) -> PictureKind {
        self.kind
    }

    /// The pen that lines are drawn with: for a method with a pen of its own, its placement and the style's width.
    pub fn pen(&self) -> Pen {
        let placement = match &self.source {
            Source::Edges(_) | Source::MovingEdges(_) => PenPlacement::Centred,
            Source::Own { placement, .. } => *placement,
        };
        Pen { width_px: self.style.pen_width_px, placement }
    }

    /// Has a method that extracts edges see a frame that is not drawn, as what it keeps from frame to frame depends on it. Of a
    /// method that draws by itself each frame stands for itself, and nothing is done.
    ///
    /// # Errors
    /// [`DrawError`].
    pub fn pass_by(&mut self, gpu: &Gpu, camera: &Camera) -> Result<(), DrawError> {
        match &self.source {
            Source::Edges(_) | Source::MovingEdges(_) => self.prepare(gpu, camera),
            Source::Own { .. } => Ok(()),
        }
    }

    fn prepare(&mut self, gpu: &Gpu, camera: &Camera) -> Result<(), DrawError> {
        let Some(bounds) = self.mesh.bounds() else { return Err(DrawError::NoFaces) };
        let renderer = self.source.renderer();
        let range = renderer.clip_range(camera, camera.clip_range(&bounds));
        let view = FrameView::from_camera(camera, range, DEFAULT_FORMATS.depth_direction)?;
        for renderer in self.below.iter_mut().chain(&mut self.above) {
            renderer.prepare(gpu.device(), gpu.queue(), &view)?;
        }
        Ok(self.source.renderer().prepare(gpu.device(), gpu.queue(), &view)?)
    }

    /// Draws a frame in one submission and waits for it. The frame's time is that of preparing, encoding, submitting and
    /// waiting; nothing is read back meanwhile.
    ///
    /// # Errors
    /// [`DrawError`].
    pub fn draw(&mut self, gpu: &Gpu, camera: &Camera) -> Result<FrameSample, DrawError> {
        let start = Instant::now();
        self.prepare(gpu, camera)?;
        let prepare_ms = start.elapsed().as_secs_f64() * 1000.0;
        let (renderer, below, above) = (self.source.renderer(), &self.below, &self.above);
        let pass = gpu.draw_after(
            &self.target,
            Load::Clear(self.style.ground.color()),
            |encoder| {
                below.iter().chain(above).for_each(|renderer| renderer.encode(encoder));
                renderer.encode(encoder);
            },
            |pass| {
                below.iter().for_each(|renderer| renderer.draw(pass));
                renderer.draw(pass);
                above.iter().for_each(|renderer| renderer.draw(pass));
            },
        )?;
        let extraction = match &self.source {
            Source::Edges(renderer) => {
                Some(ExtractionSample { extract_ms: renderer.extractor().extract_ms(), stats: renderer.stats() })
            }
            Source::MovingEdges(renderer) => {
                Some(ExtractionSample { extract_ms: renderer.extractor().extract_ms(), stats: renderer.stats() })
            }
            Source::Own { .. } => None,
        };
        Ok(FrameSample { frame_ms: prepare_ms + pass.wall_ms, gpu_ms: pass.gpu_ms, extraction })
    }

    /// The frame drawn last.
    ///
    /// # Errors
    /// [`DrawError::Gpu`].
    pub fn picture(&self, gpu: &Gpu) -> Result<Image, DrawError> {
        Ok(self.target.read_color(gpu)?)
    }

    /// What the user should know of the frame drawn last; see [`FrameRenderer::warning`].
    pub fn warning(&self) -> Option<String> {
        match &self.source {
            Source::Edges(_) | Source::MovingEdges(_) => None,
            Source::Own { renderer, .. } => renderer.warning(),
        }
    }

    /// The edges of the frame drawn last, for a method that extracts edges.
    pub fn edges(&self) -> Option<&SilhouetteEdges> {
        match &self.source {
            Source::Edges(renderer) => Some(renderer.edges()),
            Source::MovingEdges(renderer) => Some(renderer.edges()),
            Source::Own { .. } => None,
        }
    }

    /// Moves the vertices to `positions`, one per vertex, for the frames to come. `false`, and nothing moves, where the method
    /// extracts edges of a mesh at rest only, or positions do not fit. A method that draws by itself may go on to draw the mesh
    /// at rest; its [warning](Self::warning) then says so.
    pub fn move_to(&mut self, gpu: &Gpu, positions: &[Vec3]) -> bool {
        match &mut self.source {
            Source::Edges(_) => false,
            Source::MovingEdges(renderer) => renderer.set_positions(gpu.queue(), positions).is_ok(),
            Source::Own { .. } => self.mesh.set_positions(gpu.queue(), positions).is_ok(),
        }
    }
}

/// The kinds of picture that a method with these capabilities yields, lines first.
pub fn pictures_of(can: Capabilities) -> impl Iterator<Item = PictureKind> {
    let kinds = [(can.lines || can.edges, PictureKind::Lines), (can.fill, PictureKind::Fill)];
    kinds.into_iter().filter_map(|(yields, kind)| yields.then_some(kind))
}

/// A picture, with what its user should know.
#[derive(Debug, Clone, PartialEq)]
pub struct Rendered {
    /// The picture; with a transparent ground premultiplied by alpha.
    pub image: Image,
    /// Why its lines may be wrong, and what to choose instead; see [`FrameRenderer::warning`].
    pub warning: Option<String>,
}

/// Draws one view by one method, its lines where it yields any: what a user who only wants the picture needs.
///
/// # Errors
/// [`DrawError`].
pub fn render_method(
    gpu: &Gpu,
    entry: &Entry,
    options: &OptionValues,
    mesh: &Arc<PreparedMesh>,
    camera: &Camera,
    style: FrameStyle,
    progress: &dyn Progress,
) -> Result<Rendered, DrawError> {
    let kind = pictures_of(entry.capabilities()).next().unwrap_or(PictureKind::Lines);
    let prepared = entry.prepare(mesh, options, progress)?;
    let mut drawing = Drawing::new(gpu, mesh, prepared, kind, style)?;
    drawing.draw(gpu, camera)?;
    Ok(Rendered { image: drawing.picture(gpu)?, warning: drawing.warning() })
}

#[cfg(test)]
mod tests;
