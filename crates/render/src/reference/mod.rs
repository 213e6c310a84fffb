//! [`ReferenceRenderer`]: pictures at many samples a pixel, in tiles.

mod box_downsample;
mod depth;
mod tiles;

pub use depth::ReferenceDepth;

use crate::error::GpuError;
use crate::fill::{Cull, FillPass, FillStyle, Shade};
use crate::gpu::Gpu;
use crate::image::{DepthImage, Image};
use crate::lines::line_visibility::DepthScale;
use crate::lines::{Join, LinePass, LineStyle, Polylines};
use crate::pass_view::PassView;
use crate::submit::Load;
use crate::target::{DEFAULT_FORMATS, Target};
use box_downsample::BoxDownsample;
use silhouette_core::view::Camera;
use silhouette_gpu::MeshBuffers;
use tiles::Tiling;

/// Samples along each side of a pixel: 16 a pixel, an edge's coverage to 0.024 rms.
pub const DEFAULT_SUPERSAMPLING: u32 = 4;

/// Most samples along each side of a pixel.
const MAX_SUPERSAMPLING: u32 = 16;

/// What a reference image shows.
#[derive(Debug, Clone, Copy)]
pub struct Scene<'a> {
    /// The mesh.
    pub mesh: &'a MeshBuffers,
    /// How it is filled. It hides lines whatever its style; with culling, only by the faces drawn.
    pub fill: FillStyle,
    /// The lines over it.
    pub lines: &'a Polylines,
    /// How they are drawn; widths are pixels of the image.
    pub style: LineStyle,
    /// The view; its viewport is the image.
    pub camera: Camera,
    /// Colour of the background, as stored.
    pub paper: [f64; 4],
}

/// Draws [`Scene`]s at n x n samples a pixel, averaged by a box filter over the bytes as stored: of black ink on white
/// paper, a pixel's darkness is the covered share of its area.
///
/// Tiles of at most 2048 x 2048 samples keep the memory bounded for any image size. Cost: each tile draws the whole
/// mesh. Targets and pipelines are kept for the next image of the same size and style.
#[derive(Debug)]
pub struct ReferenceRenderer {
    lines: LinePass,
    downsample: BoxDownsample,
    depth_fill: FillPass,
    fill: Option<(FillStyle, FillPass)>,
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
        let depth_style = FillStyle { shade: Shade::DepthOnly, cull: Cull::None };
        Ok(Self {
            lines: LinePass::new(gpu, DEFAULT_FORMATS.color, 1)?,
            downsample: BoxDownsample::new(gpu)?,
            depth_fill: FillPass::new(gpu, DEFAULT_FORMATS, depth_style)?,
            fill: None,
            targets: None,
        })
    }

    /// The scene with `n` x `n` samples a pixel, n from 1 to 16.
    ///
    /// # Errors
    /// [`GpuError::Samples`], [`GpuError::OverBudget`], [`GpuError::Size`]; what the device reports.
    pub fn image(&mut self, gpu: &Gpu, scene: &Scene<'_>, n: u32) -> Result<Image, GpuError> {
        check_supersampling(n)?;
        let [width, height] = scene.camera.size();
        gpu.check_budget(4 * u64::from(width) * u64::from(height))?;
        let limit = match scene.style.join {
            Join::Miter { limit } => f64::from(limit.max(1.0)),
            Join::Round | Join::Bevel => 1.0,
        };
        let tiling = Tiling::new([width, height], n, scene.style.pen.width_px * limit);
        let TileTargets { samples, pixels } = match self.targets.take() {
            Some(kept) if kept.samples.size() == tiling.target_px() && kept.pixels.size() == tiling.tile_px() => kept,
            _ => TileTargets {
                samples: Target::new(gpu, tiling.target_px(), DEFAULT_FORMATS)?,
                pixels: Target::new(gpu, tiling.tile_px(), DEFAULT_FORMATS)?,
            },
        };
        let fill = match self.fill.take() {
            Some((style, kept)) if style == scene.fill => kept,
            _ => FillPass::new(gpu, DEFAULT_FORMATS, scene.fill)?,
        };
        let whole = PassView::new(&scene.camera, scene.mesh.bounds(), DEFAULT_FORMATS.depth_direction);
        let mut image = Image { width, height, rgba: vec![0; 4 * width as usize * height as usize] };
        for placed in tiling.tiles() {
            let view = whole.with_tile(placed.tile);
            fill.prepare(gpu, scene.mesh, &view);
            gpu.draw(&samples, Load::Clear(scene.paper), |pass| fill.draw(pass, scene.mesh))?;
            self.lines.prepare(gpu, &view, scene.lines, &scene.style, &samples)?;
            gpu.draw_over(&samples, |pass| self.lines.draw(pass))?;
            self.downsample.run(gpu, &samples, n, &pixels)?;
            let tile = pixels.read_color(gpu)?;
            placed.copy_rows(&mut image.rgba, width, 1, 4, &tile.rgba, tile.width);
        }
        self.fill = Some((scene.fill, fill));
        self.targets = Some(TileTargets { samples, pixels });
        Ok(image)
    }

    /// The depth of `mesh` at `n` x `n` samples a pixel of the camera's viewport, both sides of every face.
    ///
    /// # Errors
    /// As [`image`](Self::image); the budget has to hold 4 bytes a sample.
    pub fn depth(&self, gpu: &Gpu, mesh: &MeshBuffers, camera: &Camera, n: u32) -> Result<ReferenceDepth, GpuError> {
        check_supersampling(n)?;
        let size = camera.size();
        let [width, height] = size.map(|side| side * n);
        gpu.check_budget(4 * u64::from(width) * u64::from(height))?;
        let tiling = Tiling::new(size, n, 0.0);
        let target = Target::new(gpu, tiling.target_px(), DEFAULT_FORMATS)?;
        let whole = PassView::new(camera, mesh.bounds(), DEFAULT_FORMATS.depth_direction);
        let mut values = vec![0.0; width as usize * height as usize];
        for placed in tiling.tiles() {
            self.depth_fill.prepare(gpu, mesh, &whole.with_tile(placed.tile));
            gpu.draw(&target, Load::Clear([1.0; 4]), |pass| self.depth_fill.draw(pass, mesh))?;
            let tile = target.read_depth(gpu)?;
            placed.copy_rows(&mut values, width, n, 1, &tile.values, tile.width);
        }
        let image = DepthImage { width, height, values };
        let view = whole.with_tile(crate::pass_view::Tile { scale: n, ..whole.tile });
        Ok(ReferenceDepth { image, view, scale: DepthScale::new(&view, DEFAULT_FORMATS.depth) })
    }
}

fn check_supersampling(n: u32) -> Result<(), GpuError> {
    if (1..=MAX_SUPERSAMPLING).contains(&n) {
        Ok(())
    } else {
        Err(GpuError::Samples { samples: n, possible: "1 to 16 along each side of a pixel" })
    }
}
