//! [`Bake`]: from an object and a hull to a [`SilhouetteTexture`].
//!
//! 1. `atlas.rs`: the hull is laid out in blocks of texels.
//! 2. `visibility_function.rs`: rays say whether a hull point shows the object in a direction.
//! 3. `centers.rs`, `tangents.rs`: a frame at each vertex of the hull, to be interpolated.
//! 4. `tile.rs`, with `border_search.rs` and `lobe.rs`: at each texel and azimuth, the angle from the middle of the lobe to its
//!    border.
//! 5. `correspondence.rs`: colours and normals.
//!
//! Departures from the paper, beside those of the steps:
//!
//! 1. Angles are baked about the frame that the renderer interpolates, not about the texel's own centre. Both mix in the paper as
//!    printed ([`CenterRule::AsPrinted`]), and its lobes are drawn turned by what their centres differ by.
//! 2. Texels in the gutter lie on the neighbour across an edge.
//!
//! The result is the same to the last bit for any number of threads, and after any number of interruptions. Time grows linearly
//! with samples and with the logarithm of faces; memory is that of the result, of both hierarchies, and 3 MB per thread.

use crate::atlas::{Atlas, AtlasError};
use crate::centers::centers;
use crate::checkpoint::{Checkpoint, CheckpointError};
use crate::correspondence::{ColorAt, Correspondence};
use crate::fingerprint::Fingerprint;
use crate::hull::Hull;
use crate::lobe::LobeRule;
use crate::silhouette_texture::{PartsError, SilhouetteTexture, VisibilityRule};
use crate::tangents::tangents;
use crate::target::Target;
use crate::tile::{Middle, Source, Tile};
use crate::tile_bytes;
use crate::visibility_function::VisibilityFunction;
use crate::volume_size::VolumeSize;
use glam::Vec3;
use rayon::prelude::*;
use silhouette_core::method::OptionChoice;
use silhouette_core::{Cancelled, FaceId, Progress, TriangleMesh, glam};
use std::f32::consts::PI;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

silhouette_core::option_choice! {
    /// Which centres of lobes are baked about, and drawn with.
    pub enum CenterRule {
        /// Those at vertices of the hull, interpolated: 24 bytes per vertex, and phi is right about them.
        Vertex = "vertex",
        /// Each texel's own, stored as a texture: 8 bytes per texel. For hulls so coarse that interpolated centres leave the lobe.
        Texel = "texel",
        /// Baked about each texel's own, drawn with those interpolated between vertices, as the paper's text and its shader say
        /// taken together. For comparison only.
        AsPrinted = "as-printed",
    }
}

silhouette_core::option_choice! {
    /// How an angle is stored.
    pub enum AngleFormat {
        /// 8 bits: steps of 0.7 degrees, as in the paper.
        Unorm8 = "unorm8",
        /// 16-bit floats: steps of at most 0.09 degrees.
        Float16 = "float16",
    }
}

/// What to bake.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BakeOptions {
    /// Texels and azimuths. 512 x 512 x 64 on one page, as in the paper, by default.
    pub size: VolumeSize,
    /// Texels around each block, 0 to 8. 1 by default: enough for bilinear filtering, multisampling included.
    pub gutter: u32,
    /// The visibility function.
    pub rule: VisibilityRule,
    /// The middles of lobes.
    pub centers: CenterRule,
    /// The angle for a meridian that a lobe meets more than once.
    pub lobe: LobeRule,
    /// How angles are stored.
    pub format: AngleFormat,
    /// Texels of colours and normals along a texel's side, 1 to 16. 2 by default.
    pub detail: u32,
    /// Edges of the object are drawn sharp where the normals of their faces differ by more, in degrees from 0 (all) to 180 (none).
    /// 60 by default.
    pub crease_deg: f64,
}

impl Default for BakeOptions {
    fn default() -> Self {
        Self {
            size: VolumeSize { width: 512, height: 512, azimuths: 64, pages: 1 },
            gutter: 1,
            rule: VisibilityRule::default(),
            centers: CenterRule::default(),
            lobe: LobeRule::default(),
            format: AngleFormat::default(),
            detail: 2,
            crease_deg: 60.0,
        }
    }
}

/// Most detail texels along a texel's side.
pub const MOST_DETAIL: u32 = 16;

/// An object, its hull and what to bake of them.
#[derive(Clone, Copy)]
pub struct Bake<'a> {
    mesh: &'a TriangleMesh,
    hull: &'a Hull,
    options: BakeOptions,
    colors: Option<&'a ColorAt<'a>>,
}

/// What a bake came to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BakeReport {
    /// Blocks of the atlas.
    pub blocks: usize,
    /// Texels along a block's side, gutter included.
    pub block_side: u32,
    /// Texels on the hull itself, as a share of all texels.
    pub utilisation: f64,
    /// Samples in blocks: those that were searched for.
    pub samples: u64,
    /// Rays cast at the object to find them. Those of centres, colours and normals are not counted.
    pub rays: u64,
    /// Samples whose meridian was scanned; all others followed a neighbour's.
    pub scans: u64,
    /// Texels in blocks.
    pub texels: u64,
    /// Texels at which the middle of the lobe does not itself show the object: there may be holes.
    pub hidden_centers: u64,
    /// Tiles that were taken from the checkpoint.
    pub restored_tiles: u64,
    /// All tiles.
    pub tiles: u64,
}

impl BakeReport {
    /// Rays at the object per sample.
    pub fn rays_per_sample(&self) -> f64 {
        self.rays as f64 / self.samples.max(1) as f64
    }
}

/// Why nothing was baked.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum BakeError {
    /// The hull does not fit the texture.
    #[error(transparent)]
    Atlas(#[from] AtlasError),
    /// The object has no face.
    #[error("the mesh has no face")]
    NoFaces,
    /// Detail texels out of range.
    #[error("{0} x {0} texels of colours and normals per texel are not supported: take 1 to {MOST_DETAIL}")]
    Detail(u32),
    /// The progress asked to stop. What is finished lies in the checkpoint, if there is one.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The checkpoint cannot be used.
    #[error("{}: {cause}", .path.display())]
    Checkpoint {
        /// The file.
        path: PathBuf,
        /// Why not.
        cause: CheckpointError,
    },
    /// The arrays do not fit each other, which is a mistake of this crate.
    #[error(transparent)]
    Parts(#[from] PartsError),
}

impl<'a> Bake<'a> {
    /// An object without colours and a hull around it. Where the hull does not enclose the object, outlines have holes.
    pub fn new(mesh: &'a TriangleMesh, hull: &'a Hull, options: BakeOptions) -> Self {
        Self { mesh, hull, options, colors: None }
    }

    pub(crate) fn hull(&self) -> &'a Hull {
        self.hull
    }

    pub(crate) fn options(&self) -> &BakeOptions {
        &self.options
    }

    /// With the object's colours.
    #[must_use]
    pub fn with_colors(self, colors: &'a ColorAt<'a>) -> Self {
        Self { colors: Some(colors), ..self }
    }

    /// Bakes on the current pool of threads. With a `checkpoint`, finished tiles are appended to that file, and those that it holds
    /// are not baked again; it is left in place, to be removed when the result is safe.
    ///
    /// # Errors
    /// [`BakeError`]. Nothing but the checkpoint is written.
    pub fn run(
        &self,
        progress: &dyn Progress,
        checkpoint: Option<&Path>,
    ) -> Result<(SilhouetteTexture, BakeReport), BakeError> {
        self.prepare(progress, |source, tiles, target| self.bake_tiles(source, tiles, target, progress, checkpoint))
    }

    /// Prepares what all tiles are baked from, and passes it to `work` with the tiles and the arrays to fill.
    pub(crate) fn prepare<T, E: From<BakeError>>(
        &self,
        progress: &dyn Progress,
        work: impl FnOnce(&Source<'_>, &[Tile], Target) -> Result<T, E>,
    ) -> Result<T, E> {
        let options = &self.options;
        if self.mesh.face_count() == 0 {
            return Err(BakeError::NoFaces.into());
        }
        if !(1..=MOST_DETAIL).contains(&options.detail) {
            return Err(BakeError::Detail(options.detail).into());
        }
        let atlas = Atlas::new(self.hull, options.size, options.gutter).map_err(BakeError::from)?;
        let tiles = Tile::all(&atlas);
        let visibility = VisibilityFunction::with_progress(self.mesh, self.hull, options.rule, progress);
        let visibility = visibility.map_err(BakeError::from)?;
        let centers = centers(self.hull, &visibility, progress).map_err(BakeError::from)?;
        let tangents = tangents(self.hull, &centers);
        let correspondence =
            Correspondence::new(self.mesh, visibility.object(), self.hull, options.crease_deg, self.colors, progress)
                .map_err(BakeError::from)?;
        let source = Source {
            atlas: &atlas,
            visibility: &visibility,
            triangles: self.hull.mesh().triangles(),
            centers: &centers,
            tangents: &tangents,
            correspondence: &correspondence,
            middle: if options.centers == CenterRule::Vertex { Middle::Interpolated } else { Middle::Own },
            lobe: options.lobe,
            tolerance: match options.format {
                AngleFormat::Unorm8 => PI / 512.0,
                AngleFormat::Float16 => PI / 4096.0,
            },
            detail: options.detail,
        };
        work(&source, &tiles, Target::new(self, &atlas, tiles.len(), &centers, &tangents))
    }

    fn bake_tiles(
        &self,
        source: &Source<'_>,
        tiles: &[Tile],
        mut target: Target,
        progress: &dyn Progress,
        checkpoint: Option<&Path>,
    ) -> Result<(SilhouetteTexture, BakeReport), BakeError> {
        let (atlas, options) = (source.atlas, &self.options);
        let checkpoint = checkpoint
            .map(|path| {
                let at = |cause| BakeError::Checkpoint { path: path.to_owned(), cause };
                let restore = |tile: u32, bytes: &[u8]| target.restore(atlas, tiles, tile, bytes);
                Checkpoint::open(path, self.fingerprint(), tiles.len() as u32, restore)
                    .map(|file| (file, at))
                    .map_err(at)
            })
            .transpose()?;
        let left: Vec<usize> = (0..tiles.len()).filter(|&tile| !target.is_done[tile]).collect();
        progress.stage("silhouette texture", tiles.len() as u64);
        progress.advance((tiles.len() - left.len()) as u64);
        let target = Mutex::new(target);
        left.into_par_iter().try_for_each(|index| {
            progress.check()?;
            let baked = tiles[index].bake(source);
            if let Some((file, at)) = &checkpoint {
                let bytes = tile_bytes::write(&baked, options.format);
                file.append(index as u32, &bytes).map_err(|error| at(CheckpointError::Io(error)))?;
            }
            // Tiles do not overlap: what a thread leaves behind when it panics is never read.
            let mut target = target.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            target.put(atlas, &tiles[index], &baked);
            progress.advance(1);
            Ok::<(), BakeError>(())
        })?;
        target.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner).finish()
    }

    /// A hash of all that the result depends on. Colours enter by their values at the middles and corners of faces.
    fn fingerprint(&self) -> u64 {
        let options = &self.options;
        let mut hash = Fingerprint::default().mesh(self.mesh).mesh(self.hull.mesh());
        let VolumeSize { width, height, azimuths, pages } = options.size;
        for number in [width, height, azimuths, pages, options.gutter, options.detail] {
            hash = hash.number(u64::from(number));
        }
        hash = hash.number(options.crease_deg.to_bits());
        for word in [options.rule.word(), options.centers.word(), options.lobe.word(), options.format.word()] {
            hash = hash.bytes(word.as_bytes()).number(0);
        }
        if let Some(colors) = self.colors {
            for face in (0..self.mesh.face_count()).map(FaceId::from_usize) {
                for weights in [Vec3::splat(1.0 / 3.0), Vec3::X, Vec3::Y, Vec3::Z] {
                    hash = hash.bytes(&colors(face, weights));
                }
            }
        }
        hash.finish()
    }
}
