//! [`Textures`]: the silhouette textures of a mesh.

use super::options::BakeChoice;
use crate::bake::{Bake, BakeError, BakeReport};
use crate::compression::{CompressionError, compress};
use crate::hull::{Hull, HullError};
use crate::silhouette_texture::{Angles, Parts, PartsError, SilhouetteTexture};
use crate::volume_size::VolumeSize;
use crate::{BakeOptions, atlas::Atlas};
use silhouette_core::method::PrepareError;
use silhouette_core::prepared::Artefact;
use silhouette_core::{Cancelled, PreparedMesh, Progress, TriangleMesh};
use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// The silhouette textures of a mesh: the one that the caller has, or those that methods asked for, each baked once.
///
/// A caller with a texture, read from a file for example, gives it to the mesh. Methods then draw that one, whatever their
/// options ask to be baked:
///
/// ```no_run
/// use silhouette_core::PreparedMesh;
/// use silhouette_texture::{method::Textures, siltex};
///
/// let texture = siltex::read("bunny.siltex".as_ref())?.texture;
/// let mesh = PreparedMesh::new(texture.parts().hull.mesh().clone()).with_artefact(Textures::given(texture));
/// # Ok::<(), silhouette_texture::siltex::SiltexError>(())
/// ```
#[derive(Debug, Default)]
pub struct Textures {
    given: Option<Arc<SilhouetteTexture>>,
    made: Mutex<Made>,
}

#[derive(Debug, Default)]
struct Made {
    hulls: Vec<(u32, Hull)>,
    textures: Vec<(BakeChoice, Arc<SilhouetteTexture>)>,
}

/// Why there is no texture of a mesh.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TextureError {
    /// No hull was found.
    #[error(transparent)]
    Hull(#[from] HullError),
    /// The bake failed.
    #[error(transparent)]
    Bake(#[from] BakeError),
    /// The texture cannot be compressed as asked.
    #[error(transparent)]
    Compression(#[from] CompressionError),
    /// An empty texture that does not fit itself, which is a mistake of this crate.
    #[error(transparent)]
    Parts(#[from] PartsError),
    /// This package is built without the feature `simplify`.
    #[error("this build makes no hulls; build it with the cargo feature `simplify`, which needs a C++ compiler")]
    FeatureOff,
}

impl From<TextureError> for PrepareError {
    fn from(error: TextureError) -> Self {
        match error {
            TextureError::Hull(HullError::Cancelled(cancelled))
            | TextureError::Bake(BakeError::Cancelled(cancelled)) => cancelled.into(),
            error => Self::Mesh(Box::new(error)),
        }
    }
}

impl Artefact for Textures {
    const NAME: &'static str = "silhouette-textures";

    /// None; they are baked when methods ask for them.
    fn build(_mesh: &PreparedMesh, _progress: &dyn Progress) -> Result<Self, Cancelled> {
        Ok(Self::default())
    }

    /// 0: methods count the texture that they draw.
    fn bytes(&self) -> usize {
        0
    }
}

impl Textures {
    /// A texture that the caller has.
    pub fn given(texture: impl Into<Arc<SilhouetteTexture>>) -> Self {
        Self { given: Some(texture.into()), made: Mutex::default() }
    }

    /// The texture of `mesh` that was given, or else one baked as `choice` says. Of a mesh without faces, one without texels in
    /// use.
    ///
    /// # Errors
    /// [`TextureError`].
    pub fn get(
        &self,
        mesh: &TriangleMesh,
        choice: &BakeChoice,
        progress: &dyn Progress,
    ) -> Result<Arc<SilhouetteTexture>, TextureError> {
        if let Some(given) = &self.given {
            return Ok(Arc::clone(given));
        }
        let mut made = lock(&self.made);
        if let Some((_, texture)) = made.textures.iter().find(|(other, _)| other == choice) {
            return Ok(Arc::clone(texture));
        }
        let texture = if mesh.face_count() == 0 {
            empty(mesh, choice.options)?
        } else {
            let hull = made.hull(mesh, choice.hull_vertices, progress)?;
            bake(mesh, &hull, choice.options, choice.terms, progress, None)?.0
        };
        let texture = Arc::new(texture);
        made.textures.push((*choice, Arc::clone(&texture)));
        Ok(texture)
    }
}

impl Made {
    fn hull(&mut self, mesh: &TriangleMesh, vertices: u32, progress: &dyn Progress) -> Result<Hull, TextureError> {
        if let Some((_, hull)) = self.hulls.iter().find(|(other, _)| *other == vertices) {
            return Ok(hull.clone());
        }
        let hull = hull(mesh, vertices, progress)?;
        self.hulls.push((vertices, hull.clone()));
        Ok(hull)
    }
}

/// A hull of at most so many vertices, as close as it gets.
///
/// # Errors
/// [`TextureError`]: none encloses the mesh.
#[cfg(feature = "simplify")]
pub fn hull(mesh: &TriangleMesh, vertices: u32, progress: &dyn Progress) -> Result<Hull, TextureError> {
    Ok(Hull::enclosing(
        mesh,
        &crate::hull::HullOptions { vertices: vertices as usize, ..Default::default() },
        progress,
    )?)
}

/// Refuses, as this package is built without the feature `simplify`.
///
/// # Errors
/// [`TextureError::FeatureOff`].
#[cfg(not(feature = "simplify"))]
pub fn hull(_mesh: &TriangleMesh, _vertices: u32, _progress: &dyn Progress) -> Result<Hull, TextureError> {
    Err(TextureError::FeatureOff)
}

/// Bakes a mesh on a hull and compresses the result to `terms`, or not at all if that is 0. With a `checkpoint`, an interrupted bake
/// goes on where it was; see [`Bake::run`].
///
/// # Errors
/// [`TextureError`].
pub fn bake(
    mesh: &TriangleMesh,
    hull: &Hull,
    options: BakeOptions,
    terms: u32,
    progress: &dyn Progress,
    checkpoint: Option<&Path>,
) -> Result<(SilhouetteTexture, BakeReport), TextureError> {
    let (texture, report) = Bake::new(mesh, hull, options).run(progress, checkpoint)?;
    if terms == 0 {
        return Ok((texture, report));
    }
    let atlas = Atlas::new(hull, options.size, options.gutter).map_err(BakeError::from)?;
    Ok((compress(&texture, terms, Some(&atlas.used_texels()))?, report))
}

/// A texture of a mesh without faces: one texel, of which nothing is drawn.
fn empty(mesh: &TriangleMesh, options: BakeOptions) -> Result<SilhouetteTexture, PartsError> {
    let size = VolumeSize { width: 1, height: 1, azimuths: 3, pages: 1 };
    let vertices = mesh.positions().len();
    SilhouetteTexture::new(Parts {
        hull: Hull::trusted(mesh.clone()),
        centers: vec![silhouette_core::glam::Vec3::Z; vertices],
        tangents: vec![silhouette_core::glam::Vec3::X; vertices],
        places: Vec::new(),
        size,
        rule: options.rule,
        angles: Angles::Unorm8(vec![0; 3]),
        texel_centers: None,
        gaps: vec![half::f16::ZERO],
        detail: 1,
        colors: vec![[0; 4]],
        normals: vec![[half::f16::ZERO; 4]],
    })
}

/// A bake that panicked has put nothing in the lists.
fn lock(made: &Mutex<Made>) -> MutexGuard<'_, Made> {
    made.lock().unwrap_or_else(PoisonError::into_inner)
}
