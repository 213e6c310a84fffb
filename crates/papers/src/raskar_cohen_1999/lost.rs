//! Section 4 of the paper: faces whose number is not read back are behind the first layer. Faces too small to cover the middle
//! of a pixel are not read back either. How many front faces a picture loses so, and the ink that they get.

use super::variants::{UNORIENTED, UNORIENTED_LIKE, Variant};
use silhouette_compare::drawing::{DrawError, Drawing, FrameStyle};
use silhouette_compare::metrics::Ink;
use silhouette_compare::registry::{self, Entry};
use silhouette_core::method::OptionError;
use silhouette_core::view::Camera;
use silhouette_core::{FaceFacings, FaceId, PreparedMesh, Progress};
use silhouette_gpu::MeshBuffers;
use silhouette_render::{FaceIdPass, Gpu};
use std::collections::HashSet;
use std::sync::Arc;

/// Sides of the pictures that lose faces, in pixels.
pub const SIZES_PX: [u32; 3] = [256, 512, 1024];
/// Side of the picture that tells which faces can be seen.
pub const FINE_PX: u32 = 4096;

/// What a picture of one size loses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lost {
    /// Its side in pixels.
    pub size_px: u32,
    /// Share of the front faces in a picture of [`FINE_PX`] that it lacks.
    pub share: f64,
    /// Pixels that each of [`UNORIENTED`] inks and its oriented counterpart does not.
    pub extra_px: [usize; 2],
}

/// Why nothing was measured.
#[derive(Debug, thiserror::Error)]
pub(super) enum LostError {
    #[error(transparent)]
    Draw(#[from] DrawError),
    #[error(transparent)]
    Option(#[from] OptionError),
    #[error(transparent)]
    Method(#[from] registry::UnknownMethod),
    #[error(transparent)]
    View(#[from] silhouette_core::view::ViewError),
}

/// Of the front faces that a picture of [`FINE_PX`] shows, the shares that pictures of [`SIZES_PX`] do not. Draws
/// all four.
pub(super) fn shares(gpu: &Gpu, mesh: &PreparedMesh, camera: &Camera) -> Result<[f64; 3], LostError> {
    let buffers = MeshBuffers::new(gpu.device(), gpu.queue(), mesh.mesh()).map_err(DrawError::from)?;
    let facings = FaceFacings::new(mesh.mesh(), &camera.viewpoint());
    // Which front faces a picture shows.
    let seen = |size_px: u32| -> Result<Vec<bool>, LostError> {
        let camera = camera.with_size([size_px; 2])?;
        // A pass keeps its target, of which the largest is a hundred megabytes.
        let mut pass = FaceIdPass::new(gpu).map_err(DrawError::from)?;
        let ids = pass.draw(gpu, &buffers, &camera, 1).map_err(DrawError::from)?;
        let mut shown = vec![false; mesh.mesh().face_count()];
        for number in ids.values.into_iter().filter(|&number| number > 0) {
            shown[number as usize - 1] = true;
        }
        for (face, shown) in shown.iter_mut().enumerate() {
            *shown &= facings.is_front(FaceId::from_usize(face));
        }
        Ok(shown)
    };
    let fine = seen(FINE_PX)?;
    let visible = fine.iter().filter(|&&shown| shown).count();
    let mut shares = [0.0; 3];
    for (share, size_px) in shares.iter_mut().zip(SIZES_PX) {
        let coarse = seen(size_px)?;
        let lost = fine.iter().zip(&coarse).filter(|&(&fine, &coarse)| fine && !coarse).count();
        *share = lost as f64 / visible.max(1) as f64;
    }
    Ok(shares)
}

/// Draws the numbers of a mesh's faces at four sizes, and its lines at three.
pub(super) fn measure(
    gpu: &Gpu,
    mesh: &Arc<PreparedMesh>,
    camera: &Camera,
    progress: &dyn Progress,
) -> Result<Vec<Lost>, LostError> {
    let shares = shares(gpu, mesh, camera)?;
    let entry = registry::find("image-precision")?;
    let mut all = Vec::new();
    for (size_px, share) in SIZES_PX.into_iter().zip(shares) {
        let camera = camera.with_size([size_px; 2])?;
        let mut extra_px = [0; 2];
        for ((extra, unoriented), oriented) in extra_px.iter_mut().zip(&UNORIENTED).zip(&UNORIENTED_LIKE) {
            let found = draw(gpu, mesh, entry, unoriented, &camera, progress)?;
            *extra = added(&found, &draw(gpu, mesh, entry, oriented, &camera, progress)?);
        }
        all.push(Lost { size_px, share, extra_px });
    }
    Ok(all)
}

/// The ink of a variant, one sample a pixel.
pub(super) fn draw(
    gpu: &Gpu,
    mesh: &Arc<PreparedMesh>,
    entry: &Entry,
    variant: &Variant,
    camera: &Camera,
    progress: &dyn Progress,
) -> Result<Ink, LostError> {
    let prepared = entry.prepare(mesh, &variant.options()?, progress).map_err(DrawError::from)?;
    let style =
        FrameStyle { size: camera.size(), pen_width_px: silhouette_compare::runner::DEFAULT_PEN_WIDTH_PX, samples: 1 };
    let mut drawing = Drawing::new(gpu, mesh, prepared, style)?;
    drawing.draw(gpu, camera)?;
    Ok(Ink::from_picture(&drawing.picture(gpu)?))
}

/// Pixels with ink in the first picture and none in the second.
pub(super) fn added(found: &Ink, expected: &Ink) -> usize {
    let expected: HashSet<_> = expected.ink_pixels().collect();
    found.ink_pixels().filter(|pixel| !expected.contains(pixel)).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn added_ink_is_what_the_other_picture_lacks() {
        let row = |inked: &[u32]| Ink::from_fn(4, 1, |x, _| f32::from(u8::from(inked.contains(&x))));
        assert_eq!(added(&row(&[0, 1, 3]), &row(&[1])), 2);
        assert_eq!(added(&row(&[1]), &row(&[0, 1, 3])), 0);
    }
}
