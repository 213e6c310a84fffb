//! Frames of a prepared method, whatever it yields: edges are drawn by the line pass, lines draw themselves.

use crate::cost::{ExtractionSample, FrameSample};
use crate::registry::{EdgeMethod, Entry, LineMethod, Prepared};
use silhouette_core::method::{OptionValues, PrepareError};
use silhouette_core::view::Camera;
use silhouette_core::{NoProgress, PreparedMesh, Progress, SilhouetteEdges, Topology, TriangleMesh, VertexId};
use silhouette_gpu::{LineRenderer, MeshBuffers, MeshTooLarge, Pen, PenPlacement, RendererError, TargetFormats};
use silhouette_render::{
    DEFAULT_FORMATS, FillPass, FillStyle, Gpu, GpuError, Image, LinePass, LineStyle, Load, PassTime, PassView,
    Polylines, Target,
};
use std::sync::Arc;
use std::time::Instant;

/// Colour of the paper.
pub const PAPER: [f64; 4] = [1.0; 4];

/// Why a frame cannot be drawn.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DrawError {
    /// The method could not be prepared.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The device's buffers cannot hold the mesh.
    #[error(transparent)]
    MeshTooLarge(#[from] MeshTooLarge),
    /// The method's renderer cannot be made on this device.
    #[error(transparent)]
    Renderer(#[from] RendererError),
    /// The device failed.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

/// How frames are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameStyle {
    /// Viewport in pixels.
    pub size: [u32; 2],
    /// Width of the pen in pixels, for methods that do not bring their own.
    pub pen_width_px: f64,
    /// Samples a pixel, 1 or 4.
    pub samples: u32,
}

/// A prepared method with everything it needs to draw frames.
pub struct Drawing {
    target: Target,
    style: FrameStyle,
    source: Source,
}

enum Source {
    Edges(Box<EdgeSource>),
    Lines { method: Box<dyn LineMethod>, renderer: Box<dyn LineRenderer> },
}

/// What the edges of a method are drawn with.
struct EdgeSource {
    method: Box<dyn EdgeMethod>,
    edges: SilhouetteEdges,
    mesh: Arc<TriangleMesh>,
    topology: Arc<Topology>,
    buffers: MeshBuffers,
    fill: FillPass,
    lines: LinePass,
    polylines: Polylines,
    /// Scene depth, where the target cannot be read because it has several samples a pixel.
    depth: Option<Target>,
}

impl Drawing {
    /// Sets up buffers, pipelines and targets.
    ///
    /// # Errors
    /// [`DrawError::MeshTooLarge`] or [`DrawError::Gpu`].
    pub fn new(gpu: &Gpu, mesh: &Arc<PreparedMesh>, prepared: Prepared, style: FrameStyle) -> Result<Self, DrawError> {
        let formats = TargetFormats { samples: style.samples, ..DEFAULT_FORMATS };
        let source = match prepared {
            Prepared::Edges(method) => Source::Edges(Box::new(EdgeSource::new(gpu, mesh, method, formats, style)?)),
            Prepared::Lines(method) => {
                let renderer = method.renderer(gpu, formats)?;
                Source::Lines { method, renderer }
            }
        };
        Ok(Self { target: Target::new(gpu, style.size, formats)?, style, source })
    }

    /// The pen that frames are drawn with: for a method with a pen of its own, its placement and the style's width.
    pub fn pen(&self) -> Pen {
        let placement = match &self.source {
            Source::Edges(_) => PenPlacement::Centred,
            Source::Lines { method, .. } => method.pen_placement(),
        };
        Pen { width_px: self.style.pen_width_px, placement }
    }

    /// Draws a frame and waits for it.
    ///
    /// # Errors
    /// [`DrawError::Gpu`].
    pub fn draw(&mut self, gpu: &Gpu, camera: &Camera) -> Result<FrameSample, DrawError> {
        let start = Instant::now();
        let (passes, extraction) = match &mut self.source {
            Source::Edges(source) => source.draw(gpu, camera, &self.target, self.style.pen_width_px)?,
            Source::Lines { renderer, .. } => {
                renderer.prepare(gpu.device(), gpu.queue(), camera);
                let pass = gpu.draw_after(
                    &self.target,
                    Load::Clear(PAPER),
                    |encoder| renderer.encode(encoder),
                    |pass| renderer.draw(pass),
                )?;
                (vec![pass], None)
            }
        };
        let frame_ms = start.elapsed().as_secs_f64() * 1000.0;
        let gpu_ms = passes.iter().map(|pass| pass.gpu_ms).sum();
        Ok(FrameSample { frame_ms, gpu_ms, extraction })
    }

    /// The frame drawn last.
    ///
    /// # Errors
    /// [`DrawError::Gpu`].
    pub fn picture(&self, gpu: &Gpu) -> Result<Image, DrawError> {
        Ok(self.target.read_color(gpu)?)
    }

    /// What the user should know of the frame drawn last; see [`LineRenderer::warning`].
    pub fn warning(&self) -> Option<String> {
        match &self.source {
            Source::Edges(_) => None,
            Source::Lines { renderer, .. } => renderer.warning(),
        }
    }

    /// The edges of the frame drawn last, for a method that extracts edges.
    pub fn edges(&self) -> Option<&SilhouetteEdges> {
        match &self.source {
            Source::Edges(source) => Some(&source.edges),
            Source::Lines { .. } => None,
        }
    }
}

impl EdgeSource {
    fn new(
        gpu: &Gpu,
        mesh: &Arc<PreparedMesh>,
        method: Box<dyn EdgeMethod>,
        formats: TargetFormats,
        style: FrameStyle,
    ) -> Result<Self, DrawError> {
        let single = TargetFormats { samples: 1, ..formats };
        let topology = mesh.artefact("drawing of edges", &NoProgress).map_err(PrepareError::from)?;
        let depth = (formats.samples > 1).then(|| Target::new(gpu, style.size, single)).transpose()?;
        Ok(Self {
            method,
            edges: SilhouetteEdges::default(),
            mesh: Arc::clone(mesh.mesh()),
            topology,
            buffers: MeshBuffers::new(gpu.device(), gpu.queue(), mesh.mesh())?,
            fill: FillPass::new(gpu, single, FillStyle::PAPER)?,
            lines: LinePass::new(gpu, formats.color, formats.samples)?,
            polylines: Polylines::default(),
            depth,
        })
    }

    fn draw(
        &mut self,
        gpu: &Gpu,
        camera: &Camera,
        target: &Target,
        width_px: f64,
    ) -> Result<(Vec<PassTime>, Option<ExtractionSample>), DrawError> {
        let start = Instant::now();
        let stats = self.method.extract_edges(&camera.viewpoint(), &mut self.edges);
        let extract_ms = start.elapsed().as_secs_f64() * 1000.0;

        self.polylines.clear();
        for edge in self.edges.iter() {
            let position = |vertex: VertexId| self.mesh.positions()[vertex.index()].as_dvec3();
            self.polylines.push(self.topology.end_points(edge).map(position), false);
        }

        let mut passes = Vec::new();
        let view = PassView::new(camera, self.buffers.bounds(), target.formats().depth_direction);
        self.fill.prepare(gpu, &self.buffers, &view);
        let scene_depth = self.depth.as_ref().unwrap_or(target);
        passes.push(gpu.draw(scene_depth, Load::Clear(PAPER), |pass| self.fill.draw(pass, &self.buffers))?);
        if self.depth.is_some() {
            passes.push(gpu.draw(target, Load::Clear(PAPER), |_| {})?);
        }
        let pen = Pen { width_px, placement: PenPlacement::Centred };
        let style = LineStyle { pen, ..LineStyle::default() };
        self.lines.prepare(gpu, &view, &self.polylines, &style, scene_depth)?;
        passes.push(gpu.draw_over(target, |pass| self.lines.draw(pass))?);
        Ok((passes, Some(ExtractionSample { extract_ms, stats })))
    }
}

/// A picture, with what its user should know.
#[derive(Debug, Clone, PartialEq)]
pub struct Rendered {
    /// The picture.
    pub image: Image,
    /// Why its lines may be wrong, and what to choose instead; see [`LineRenderer::warning`].
    pub warning: Option<String>,
}

/// Draws one view by one method: what a user who only wants the picture needs.
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
    let prepared = entry.prepare(mesh, options, progress)?;
    let mut drawing = Drawing::new(gpu, mesh, prepared, style)?;
    drawing.draw(gpu, camera)?;
    Ok(Rendered { image: drawing.picture(gpu)?, warning: drawing.warning() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::Ink;
    use crate::registry;
    use silhouette_core::shapes;
    use silhouette_core::view::{Framing, ViewPreset};
    use silhouette_render::testing::gpu_or_skip;

    #[test]
    fn every_method_draws_with_and_without_antialiasing() {
        let Some(gpu) = gpu_or_skip("every_method_draws_with_and_without_antialiasing") else { return };
        let mesh = Arc::new(PreparedMesh::new(shapes::by_name("cube").unwrap()));
        let (direction, up) = ViewPreset::default().directions();
        let framing = Framing::Perspective { fov_y_rad: 0.8 };
        let bounds = mesh.mesh().bounds().unwrap();
        let camera = Camera::framing(&bounds, direction, up, framing, [128, 96]).unwrap();
        for entry in registry::all() {
            let options = OptionValues::defaults(entry.info.options);
            let [sharp, smooth] = [1, 4].map(|samples| {
                let style = FrameStyle { size: camera.size(), pen_width_px: 2.0, samples };
                render_method(gpu, entry, &options, &mesh, &camera, style, &NoProgress).unwrap().image
            });
            let name = entry.info.name;
            let is_grey = |image: &Image| image.rgba.chunks(4).any(|pixel| !matches!(pixel[0], 0 | 255));
            assert!(!is_grey(&sharp) && is_grey(&smooth), "{name}");
            let inked = |image: &Image| {
                let ink = Ink::from_picture(image);
                let pixels =
                    (0..i64::from(image.height)).flat_map(|y| (0..i64::from(image.width)).map(move |x| (x, y)));
                pixels.map(|(x, y)| f64::from(ink.coverage(x, y))).sum::<f64>()
            };
            let area = [inked(&sharp), inked(&smooth)];
            assert!(area[0] > 50.0 && (area[0] / area[1] - 1.0).abs() < 0.25, "{name}: {area:?}");
        }
    }
}
