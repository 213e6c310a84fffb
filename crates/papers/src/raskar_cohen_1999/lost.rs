//! Section 4 of the paper: faces whose id is not read back are behind the first layer. Faces that cover no pixel's centre are
//! not read back either. How many front faces a picture loses so, and what becomes of its ink where the winding says nothing.

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
    /// What each of [`UNORIENTED`] draws of the soup, beside what its oriented counterpart draws of the mesh.
    pub inks: [InkOfSoup; 2],
}

/// The ink of a soup beside that of the oriented mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InkOfSoup {
    /// Share of the soup's ink that the mesh does not have.
    pub false_share: f64,
    /// Share of the mesh's ink that the soup lacks.
    pub lacking_share: f64,
}

impl InkOfSoup {
    fn of(soup: &Ink, mesh: &Ink) -> Self {
        let [of_soup, of_mesh] = [soup, mesh].map(|ink| ink.ink_pixels().collect::<HashSet<_>>());
        let share = |one: &HashSet<_>, other| one.difference(other).count() as f64 / one.len().max(1) as f64;
        Self { false_share: share(&of_soup, &of_mesh), lacking_share: share(&of_mesh, &of_soup) }
    }
}

/// Of the front faces that a picture of [`FINE_PX`] shows, the shares that pictures of [`SIZES_PX`] do not. Draws
/// all four: half a second in software.
///
/// # Errors
/// [`Cause`]: no camera, or a device that failed.
fn shares(gpu: &Gpu, mesh: &PreparedMesh, camera: &Camera) -> Result<[f64; 3], Cause> {
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

/// Draws the ids of a mesh's faces at four sizes, and lines of the mesh and its soup at three.
///
/// # Errors
/// [`Cause`]: cancelled, no camera, or a device that failed.
pub fn measure(
    gpu: &Gpu,
    [mesh, soup]: [&Arc<PreparedMesh>; 2],
    camera: &Camera,
    progress: &dyn Progress,
) -> Result<Vec<Lost>, Cause> {
    let mut all = Vec::new();
    for (size_px, share) in SIZES_PX.into_iter().zip(shares(gpu, mesh, camera)?) {
        let camera = camera.with_size([size_px; 2])?;
        let ink = |Unoriented { variant, oriented }: &Unoriented| -> Result<InkOfSoup, Cause> {
            let found = variant.ink(gpu, soup, &camera, progress)?;
            Ok(InkOfSoup::of(&found, &oriented.ink(gpu, mesh, &camera, progress)?))
        };
        all.push(Lost { size_px, share, inks: [ink(&UNORIENTED[0])?, ink(&UNORIENTED[1])?] });
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn false_ink_is_what_the_mesh_lacks_and_the_reverse() {
        let row = |inked: &[u32]| Ink::from_fn(4, 1, |x, _| f32::from(u8::from(inked.contains(&x))));
        let ink = InkOfSoup::of(&row(&[0, 1, 3]), &row(&[1, 2]));
        assert_eq!((ink.false_share, ink.lacking_share), (2.0 / 3.0, 0.5));
        let blank = InkOfSoup::of(&row(&[]), &row(&[1]));
        assert_eq!((blank.false_share, blank.lacking_share), (0.0, 1.0));
    }
}
