//! Pictures, drawn as an application draws them, against the truth of lines and of filled pictures.

use crate::cell::{Found, Outcome};
use crate::scene::Scene;
use crate::truth::Truth;
use silhouette_compare::metrics::{FillMetrics, FilledPicture, Ink, LineMetrics, TruePen, measure, measure_fill};
use silhouette_compare::registry::{Entry, Prepared};
use silhouette_core::mesh::Bounds;
use silhouette_core::{NoProgress, Topology};
use silhouette_gpu::{
    EdgeRenderer, FrameRenderer, MeshBuffers, Pen, PenPlacement, RendererError, StrokePipelines, StrokeRenderer,
    StrokeStyle,
};
use silhouette_render::{Gpu, GpuError, Image, Load, Target};
use silhouette_testing::prepare::artefact;
use std::sync::Arc;

/// What a device says: typed refusals are answers, anything else is a fault.
fn of_device(error: &GpuError) -> Found {
    let is_refusal = matches!(
        error,
        GpuError::Size { .. }
            | GpuError::OverBudget { .. }
            | GpuError::MeshTooLarge(_)
            | GpuError::Renderer(_)
            | GpuError::View(_)
    );
    if is_refusal { Found::refused(error) } else { Found::fault(error.to_string()) }
}

/// The bounds of what is drawn; of nothing, a ball about the camera's target.
fn bounds(scene: &Scene, placed: Option<Bounds>) -> Bounds {
    let (eye, target) = (scene.camera.eye().as_dvec3(), scene.camera.target().as_dvec3());
    placed.unwrap_or(Bounds { min: target, max: target, center: target, radius: 0.5 * eye.distance(target) })
}

fn stroke_renderer(gpu: &Gpu, scene: &Scene, prepared: Prepared, buffers: &Arc<MeshBuffers>) -> Box<dyn FrameRenderer> {
    let pen = Pen { width_px: scene.pen_px, placement: PenPlacement::Centred };
    let style = StrokeStyle { pen, ..StrokeStyle::default() };
    let pipelines = Arc::new(StrokePipelines::new(gpu.device(), scene.formats, style));
    let strokes = StrokeRenderer::new(gpu.device(), &pipelines, buffers);
    let topology: Arc<Topology> = artefact(&scene.mesh);
    let extractor = prepared.into_edges().expect("it extracts edges");
    Box::new(EdgeRenderer::new(Extractor(extractor), Arc::clone(scene.mesh.mesh()), topology, strokes))
}

/// A method behind its trait.
struct Extractor(Box<dyn silhouette_core::ExtractsEdges>);

impl silhouette_core::ExtractsEdges for Extractor {
    fn extract_edges(
        &mut self,
        viewpoint: &silhouette_core::Viewpoint,
        out: &mut silhouette_core::SilhouetteEdges,
    ) -> silhouette_core::method::ExtractionStats {
        self.0.extract_edges(viewpoint, out)
    }
}

/// A picture and on which side of the true line its ink lies.
fn drawn(gpu: &Gpu, entry: &Entry, truth: &Truth<'_>, fills: bool) -> Result<(Image, PenPlacement), Found> {
    let scene = truth.scene;
    let options = scene.options_of(entry.info().options).map_err(|error| Found::refused(&error))?;
    let prepared = entry.prepare(&scene.mesh, &options, &NoProgress).map_err(|error| Found::refused(&error))?;
    let target = Target::new(gpu, scene.camera.size(), scene.formats).map_err(|error| of_device(&error))?;
    let buffers = MeshBuffers::new(gpu.device(), gpu.queue(), scene.mesh.mesh());
    let buffers = Arc::new(buffers.map_err(|error| Found::refused(&error))?);
    let refused = |error: RendererError| Found::refused(&error);
    let (mut renderer, placement) = match (fills, prepared.lines()) {
        (true, _) => {
            let method = prepared.fill().expect("it fills");
            (method.renderer(gpu, scene.formats, &buffers).map_err(refused)?, PenPlacement::Centred)
        }
        (false, Some(method)) => {
            (method.renderer(gpu, scene.formats, &buffers).map_err(refused)?, method.pen_placement())
        }
        (false, None) => (stroke_renderer(gpu, scene, prepared, &buffers), PenPlacement::Centred),
    };
    gpu.check().map_err(|error| of_device(&error))?;
    let range = scene.camera.clip_range(&bounds(scene, truth.placed.mesh().bounds()));
    let range = renderer.clip_range(&scene.camera, range);
    let view = scene.view(range).map_err(|error| Found::refused(&error))?;
    renderer.prepare(gpu.device(), gpu.queue(), &view).map_err(refused)?;
    let ground = if fills { [0.0; 4] } else { [1.0; 4] };
    let encode = |encoder: &mut wgpu::CommandEncoder| renderer.encode(encoder);
    gpu.draw_after(&target, Load::Clear(ground), encode, |pass| renderer.draw(pass))
        .map_err(|error| of_device(&error))?;
    let image = target.read_color(gpu).map_err(|error| of_device(&error))?;
    Ok((image, placement))
}

/// What a method draws.
///
/// # Errors
/// A refusal or a fault.
pub fn picture(gpu: &Gpu, entry: &Entry, truth: &Truth<'_>, fills: bool) -> Result<Image, Found> {
    Ok(drawn(gpu, entry, truth, fills)?.0)
}

/// What a picture of lines scores.
///
/// # Errors
/// A refusal, a fault, or that there is no ink.
pub fn line_metrics(gpu: &Gpu, entry: &Entry, truth: &Truth<'_>) -> Result<LineMetrics, Found> {
    let (image, placement) = drawn(gpu, entry, truth, false)?;
    let ink = Ink::from_picture(&image);
    let lines = truth.lines().map_err(Found::fault)?;
    if ink.ink_pixels().next().is_none() {
        return Err(Found::new(Outcome::Empty, format!("of {:.0} px", lines.total_length_px().abs())));
    }
    let picture = truth.pen(placement).map_err(Found::fault)?;
    let pen = TruePen { picture: &picture, width_px: truth.scene.pen_px };
    Ok(measure(&ink, lines, pen))
}

/// What a filled picture scores.
///
/// # Errors
/// A refusal, a fault, or that nothing is covered.
pub fn fill_metrics(gpu: &Gpu, entry: &Entry, truth: &Truth<'_>) -> Result<FillMetrics, Found> {
    let drawn = FilledPicture::new(drawn(gpu, entry, truth, true)?.0);
    let truth = truth.fill(gpu).map_err(Found::fault)?;
    if drawn.coverage().ink_pixels().next().is_none() {
        let area: f64 = truth.coverage().coverages().iter().map(|&share| f64::from(share)).sum();
        return Err(Found::new(Outcome::Empty, format!("of {area:.0} px²")));
    }
    Ok(measure_fill(&drawn, truth))
}
