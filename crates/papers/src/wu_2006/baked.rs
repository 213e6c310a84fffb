//! A subject with its hull and texture.

use super::subjects::Subject;
use crate::error::Cause;
use silhouette_core::method::PrepareError;
use silhouette_core::{PreparedMesh, Progress};
use silhouette_texture::atlas::Atlas;
use silhouette_texture::bake::BakeError;
use silhouette_texture::method::{TextureError, Textures, bake, hull};
use silhouette_texture::{BakeOptions, BakeReport, Hull, SilhouetteTexture, VolumeSize};
use std::sync::Arc;
use std::time::Instant;

/// A subject's hull.
#[derive(Debug, Clone)]
pub struct Hulled {
    /// What it encloses.
    pub subject: Subject,
    /// The hull.
    pub hull: Hull,
    /// Seconds that it took to find.
    pub seconds: f64,
}

/// What was baked on a hull.
#[derive(Debug, Clone)]
pub struct Baked {
    /// The hull, and what it encloses.
    pub of: Hulled,
    /// The texture.
    pub texture: Arc<SilhouetteTexture>,
    /// What it came to.
    pub report: BakeReport,
    /// Seconds that it took.
    pub seconds: f64,
}

/// A square texture of one page.
pub fn size(side: u32, azimuths: u32) -> VolumeSize {
    VolumeSize { width: side, height: side, azimuths, pages: 1 }
}

fn refused(error: impl Into<TextureError>) -> Cause {
    PrepareError::from(error.into()).into()
}

impl Hulled {
    /// Finds the hull of a subject, of `vertices` vertices.
    ///
    /// # Errors
    /// [`Cause`]: cancelled, or there is no such hull.
    pub fn new(subject: &Subject, vertices: u32, progress: &dyn Progress) -> Result<Self, Cause> {
        let start = Instant::now();
        let hull = hull(subject.mesh.mesh(), vertices, progress).map_err(refused)?;
        Ok(Self { subject: subject.clone(), hull, seconds: start.elapsed().as_secs_f64() })
    }

    /// Bakes a texture on it.
    ///
    /// # Errors
    /// [`Cause`]: cancelled, or a size that does not fit the hull.
    pub fn bake(&self, options: BakeOptions, progress: &dyn Progress) -> Result<Baked, Cause> {
        let start = Instant::now();
        let baked = bake(self.subject.mesh.mesh(), &self.hull, options, 0, progress, None);
        let (texture, report) = baked.map_err(refused)?;
        let seconds = start.elapsed().as_secs_f64();
        Ok(Baked { of: self.clone(), texture: Arc::new(texture), report, seconds })
    }

    /// Its distance from the object as a share of the object's bounding radius, in percent.
    pub fn offset_percent(&self) -> f64 {
        let radius = self.subject.mesh.mesh().bounds().map_or(f64::NAN, |bounds| bounds.radius);
        100.0 * self.hull.offset().unwrap_or(f64::NAN) / radius
    }
}

impl Baked {
    /// The fine mesh, with this texture for the methods that draw one.
    pub fn drawable(&self) -> Arc<PreparedMesh> {
        drawable(&self.of.subject, &self.texture)
    }

    /// The same with the texture compressed to `terms`.
    ///
    /// # Errors
    /// [`Cause`]: more terms than azimuths.
    pub fn compressed(&self, terms: u32) -> Result<Arc<PreparedMesh>, Cause> {
        let compressed = silhouette_texture::compression::compress(&self.texture, terms, Some(&self.used()?));
        Ok(drawable(&self.of.subject, &Arc::new(compressed.map_err(refused)?)))
    }

    /// Of each texel, whether it lies in a block.
    ///
    /// # Errors
    /// [`Cause`], which cannot be of a texture that was baked.
    pub fn used(&self) -> Result<Vec<bool>, Cause> {
        let gutter = BakeOptions::default().gutter;
        let atlas = Atlas::new(&self.of.hull, self.texture.parts().size, gutter);
        Ok(atlas.map_err(|error| refused(BakeError::from(error)))?.used_texels())
    }
}

fn drawable(subject: &Subject, texture: &Arc<SilhouetteTexture>) -> Arc<PreparedMesh> {
    let mesh = PreparedMesh::new(Arc::clone(subject.mesh.mesh()));
    Arc::new(mesh.with_artefact(Textures::given(Arc::clone(texture))))
}
