//! [`ReferenceRenderer`]: pictures at many samples per pixel, in tiles.

mod box_downsample;
mod depth;
mod tiles;

pub use depth::ReferenceDepth;

use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::image::{DepthImage, Image};
use crate::submit::Load;
use crate::target::{DEFAULT_FORMATS, Target};
use crate::view::view_of_mesh;
use box_downsample::BoxDownsample;
use silhouette_core::view::Camera;
use silhouette_gpu::{
    Color, FillPipelines, FillRenderer, FillStyle, FrameRenderer, Interior, Join, MeshBuffers, Pen, Polylines,
    StrokePipelines, StrokeRenderer, StrokeStyle,
};
use std::sync::Arc;
use tiles::Tiling;

/// Samples along each side of a pixel: 16 per pixel, an edge's coverage to 0.024 rms.
pub const DEFAULT_SUPERSAMPLING: u32 = 4;

/// Most samples along each side of a pixel.
const MAX_SUPERSAMPLING: u32 = 16;

/// What a reference image shows.
#[derive(Debug, Clone, Copy)]
pub struct ReferencePicture<'a> {
    /// The mesh.
    pub mesh: &'a Arc<MeshBuffers>,
    /// How it is filled. It hides lines whatever its style; with culling, only by the faces drawn.
    pub fill: FillStyle,
    /// The lines over it.
    pub lines: &'a Polylines,
    /// How they are drawn; widths are pixels of the image. The interior is that of `fill`.
    pub style: StrokeStyle,
    /// The view; its viewport is the image.
    pub camera: Camera,
    /// Colour of the background.
    pub ground: Color,
}

/// Draws [`ReferencePicture`]s at n x n samples per pixel, averaged by a box filter over the bytes as stored: of black
/// ink on white paper, a pixel's darkness is the covered share of its area.
///
/// Tiles of at most 2048 x 2048 samples keep the memory bounded for any image size. Cost: each tile draws the whole
/// mesh, in one submission and one more for the average. Targets and pipelines are kept for the next image of the same size and
/// style.
#[derive(Debug)]
pub struct ReferenceRenderer {
    downsample: BoxDownsample,
    depth_fill: Arc<FillPipelines>,
    fill: Option<(FillStyle, Arc<FillPipelines>)>,
    strokes: Option<(StrokeStyle, Arc<StrokePipelines>)>,
    targets: Option<TileTargets>,
}

/// What the samples and the pixels of a tile are drawn to.
#[derive(Debug)]
struct TileTargets {
    samples: Target,
    pixels: Target,
}

impl ReferenceRenderer {
    /// Builds the pipelines.
    ///
    /// # Errors
    /// What the device reports.
    pub fn new(gpu: &Gpu) -> Result<Self, GpuError> {
        Ok(Self {
            downsample: BoxDownsample::new(gpu)?,
            depth_fill: fill_pipelines(gpu, FillStyle::DEPTH)?,
            fill: None,
            strokes: None,
            targets: None,
        })
    }

    /// The picture with `n` x `n` samples per pixel, n from 1 to 16. Colours are premultiplied by alpha.
    ///
    /// # Errors
    /// [`GpuError::Samples`], [`GpuError::OverBudget`], [`GpuError::Size`]; what the device reports.
    pub fn image(&mut self, gpu: &Gpu, picture: &ReferencePicture<'_>, n: u32) -> Result<Image, GpuError> {
        check_supersampling(n)?;
        let [width, height] = picture.camera.size();
        gpu.check_budget(4 * u64::from(width) * u64::from(height))?;
        let limit = match picture.style.join {
            Join::Miter { limit } => f64::from(limit.max(1.0)),
            Join::Round | Join::Bevel => 1.0,
        };
        let tiling = Tiling::new([width, height], n, picture.style.pen.width_px * limit);
        let TileTargets { samples, pixels } = match self.targets.take() {
            Some(kept) if kept.samples.size() == tiling.target_px() && kept.pixels.size() == tiling.tile_px() => kept,
            _ => TileTargets {
                samples: Target::new(gpu, tiling.target_px(), DEFAULT_FORMATS)?,
                pixels: Target::new(gpu, tiling.tile_px(), DEFAULT_FORMATS)?,
            },
        };
        let mut fill = FillRenderer::new(gpu.device(), &self.fill_of(gpu, picture.fill)?, picture.mesh);
        let mut strokes = StrokeRenderer::new(gpu.device(), &self.strokes_of(gpu, picture.style, n)?, picture.mesh);
        strokes.lines_mut().clone_from(picture.lines);
        let whole = view_of_mesh(&picture.camera, picture.mesh)?;
        let ground = picture.ground.for_target(&DEFAULT_FORMATS).map(f64::from);
        let mut image = Image { width, height, rgba: vec![0; 4 * width as usize * height as usize] };
        for placed in tiling.tiles() {
            let view = placed.view(&whole)?;
            fill.prepare(gpu.device(), gpu.queue(), &view)?;
            strokes.prepare(gpu.device(), gpu.queue(), &view)?;
            let encode = |encoder: &mut wgpu::CommandEncoder| strokes.encode(encoder);
            gpu.draw_after(&samples, Load::Clear(ground), encode, |pass| {
                fill.draw(pass);
                strokes.draw(pass);
            })?;
            self.downsample.run(gpu, &samples, n, &pixels)?;
            let tile = pixels.read_color(gpu)?;
            placed.copy_rows(&mut image.rgba, width, 1, 4, &tile.rgba, tile.width);
        }
        self.targets = Some(TileTargets { samples, pixels });
        Ok(image)
    }

    /// The depth of `mesh` at `n` x `n` samples per pixel of the camera's viewport, both sides of every face.
    ///
    /// # Errors
    /// As [`image`](Self::image); the budget has to hold 4 bytes per sample.
    pub fn depth(
        &mut self,
        gpu: &Gpu,
        mesh: &Arc<MeshBuffers>,
        camera: &Camera,
        n: u32,
    ) -> Result<ReferenceDepth, GpuError> {
        check_supersampling(n)?;
        let size = camera.size();
        let [width, height] = size.map(|side| side * n);
        gpu.check_budget(4 * u64::from(width) * u64::from(height))?;
        let tiling = Tiling::new(size, n, 0.0);
        let target = Target::new(gpu, tiling.target_px(), DEFAULT_FORMATS)?;
        let whole = view_of_mesh(camera, mesh)?;
        let mut fill = FillRenderer::new(gpu.device(), &self.depth_fill, mesh);
        let mut values = vec![0.0; width as usize * height as usize];
        for placed in tiling.tiles() {
            fill.prepare(gpu.device(), gpu.queue(), &placed.view(&whole)?)?;
            gpu.draw(&target, Load::Clear([1.0; 4]), |pass| fill.draw(pass))?;
            let tile = target.read_depth(gpu)?;
            placed.copy_rows(&mut values, width, n, 1, &tile.values, tile.width);
        }
        Ok(ReferenceDepth::new(DepthImage { width, height, values }, whole.tile([0; 2], size, n)?, n))
    }

    /// The pipelines of a fill, those of the last image where the style is the same.
    fn fill_of(&mut self, gpu: &Gpu, style: FillStyle) -> Result<Arc<FillPipelines>, GpuError> {
        if let Some((_, kept)) = self.fill.as_ref().filter(|(kept, _)| *kept == style) {
            return Ok(Arc::clone(kept));
        }
        let made = fill_pipelines(gpu, style)?;
        self.fill = Some((style, Arc::clone(&made)));
        Ok(made)
    }

    /// The pipelines of strokes that are `n` times as wide as `style` says.
    fn strokes_of(&mut self, gpu: &Gpu, style: StrokeStyle, n: u32) -> Result<Arc<StrokePipelines>, GpuError> {
        let pen = Pen { width_px: style.pen.width_px * f64::from(n), ..style.pen };
        let style = StrokeStyle { pen, interior: Interior::None, ..style };
        if let Some((_, kept)) = self.strokes.as_ref().filter(|(kept, _)| *kept == style) {
            return Ok(Arc::clone(kept));
        }
        let made = Arc::new(gpu.scoped(|| StrokePipelines::new(gpu.device(), DEFAULT_FORMATS, style))?);
        self.strokes = Some((style, Arc::clone(&made)));
        Ok(made)
    }
}

fn fill_pipelines(gpu: &Gpu, style: FillStyle) -> Result<Arc<FillPipelines>, GpuError> {
    Ok(Arc::new(gpu.scoped(|| FillPipelines::new(gpu.device(), DEFAULT_FORMATS, style))?))
}

fn check_supersampling(n: u32) -> Result<(), GpuError> {
    if (1..=MAX_SUPERSAMPLING).contains(&n) {
        Ok(())
    } else {
        Err(GpuError::Samples { samples: n, possible: "1 to 16 along each side of a pixel" })
    }
}
