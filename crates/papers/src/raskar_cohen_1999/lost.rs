//! Section 4 of the paper: faces whose id is not read back are behind the first layer. Faces that cover no pixel's centre are
//! not read back either. How many front faces a picture loses so, and the ink that they get.

use super::variants::{UNORIENTED, Unoriented};
use crate::error::Cause;
use silhouette_compare::drawing::DrawError;
use silhouette_compare::metrics::Ink;
use silhouette_core::view::Camera;
use silhouette_core::{FaceFacings, FaceId, PreparedMesh, Progress};
use silhouette_gpu::MeshBuffers;
use silhouette_render::{FaceIdPass, Gpu};
use std::collections::HashSet;
use std::sync::Arc;

/// Sides of the pictures that lose faces, in pixels.
pub const SIZES_PX: [u32; 3] = [256, 512, 1024];
/// Side of the picture that shows which faces are visible.
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

/// Of the front faces that a picture of [`FINE_PX`] shows, the shares that pictures of [`SIZES_PX`] do not. Draws
/// all four: half a second in software.
///
/// # Errors
/// [`Cause`]: no camera, or a device that failed.
pub fn shares(gpu: &Gpu, mesh: &PreparedMesh, camera: &Camera) -> Result<[f64; 3], Cause> {
    let buffers = MeshBuffers::new(gpu.device(), gpu.queue(), mesh.mesh()).map_err(DrawError::from)?;
    let facings = FaceFacings::new(mesh.mesh(), &camera.viewpoint());
    // Which front faces a picture shows.
    let shown = |size_px: u32| -> Result<Vec<bool>, Cause> {
        let camera = camera.with_size([size_px; 2])?;
        // A pass keeps its target, of which the largest is a hundred megabytes.
        let mut pass = FaceIdPass::new(gpu).map_err(DrawError::from)?;
        let ids = pass.draw(gpu, &buffers, &camera, 1).map_err(DrawError::from)?;
        let mut shown = vec![false; mesh.mesh().face_count()];
        for stored in ids.values.into_iter().filter(|&stored| stored > 0) {
            shown[stored as usize - 1] = true;
        }
        for (face, shown) in shown.iter_mut().enumerate() {
            *shown &= facings.is_front(FaceId::from_usize(face));
        }
        Ok(shown)
    };
    let fine = shown(FINE_PX)?;
    let visible = fine.iter().filter(|&&shown| shown).count();
    let mut shares = [0.0; 3];
    for (share, size_px) in shares.iter_mut().zip(SIZES_PX) {
        let coarse = shown(size_px)?;
        let lost = fine.iter().zip(&coarse).filter(|&(&fine, &coarse)| fine && !coarse).count();
        *share = lost as f64 / visible.max(1) as f64;
    }
    Ok(shares)
}

/// Draws the ids of a mesh's faces at four sizes, and its lines at three.
///
/// # Errors
/// [`Cause`]: cancelled, no camera, or a device that failed.
pub fn measure(
    gpu: &Gpu,
    mesh: &Arc<PreparedMesh>,
    camera: &Camera,
    progress: &dyn Progress,
) -> Result<Vec<Lost>, Cause> {
    let mut all = Vec::new();
    for (size_px, share) in SIZES_PX.into_iter().zip(shares(gpu, mesh, camera)?) {
        let camera = camera.with_size([size_px; 2])?;
        let mut extra_px = [0; 2];
        for (extra, Unoriented { variant, oriented }) in extra_px.iter_mut().zip(UNORIENTED) {
            let found = variant.ink(gpu, mesh, &camera, progress)?;
            *extra = added(&found, &oriented.ink(gpu, mesh, &camera, progress)?);
        }
        all.push(Lost { size_px, share, extra_px });
    }
    Ok(all)
}

/// Number of pixels with ink in the first picture and none in the second.
pub fn added(found: &Ink, expected: &Ink) -> usize {
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
