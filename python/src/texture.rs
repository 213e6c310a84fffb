//! `Texture`: silhouette textures, baked, saved, loaded and drawn.

use crate::errors::bad_input;
use crate::mesh::Mesh;
use crate::method;
use crate::progress;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyType};
use silhouette_core::MethodOptions;
use silhouette_texture::siltex::{self, Metadata};
use silhouette_texture::{SilhouetteTexture, TextureOptions};
use silhouettes::application::Failure;
use silhouettes::calls;
use std::path::PathBuf;
use std::sync::Arc;

/// A silhouette texture: a coarse hull that is drawn with the outlines of a finer mesh (Wu et al. 2006).
///
/// Made by `bake` or `Texture.load`.
#[pyclass(frozen, module = "silhouettes")]
pub struct Texture {
    texture: Arc<SilhouetteTexture>,
    metadata: Metadata,
    name: String,
}

#[pymethods]
impl Texture {
    /// Reads a .siltex file.
    #[classmethod]
    fn load(_class: &Bound<'_, PyType>, py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        let read = py.detach(|| siltex::read(&path)).map_err(bad_input)?;
        Ok(Self { texture: Arc::new(read.texture), metadata: read.metadata, name })
    }

    /// Writes a .siltex file, which appears whole or not at all.
    #[pyo3(signature = (path, *, progress = None))]
    fn save(&self, py: Python<'_>, path: PathBuf, progress: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
        progress::run(py, progress, |progress| {
            siltex::write(&path, &self.texture, &self.metadata, progress).map_err(Failure::input)
        })
    }

    /// The hull as a Mesh that the methods texture, texture-lines and normal-map-hull draw by this texture:
    /// `render(texture.hull, "texture")`.
    #[getter]
    fn hull(&self) -> Mesh {
        Mesh::from(calls::hull_of_texture(self.name.clone(), &self.texture, &self.metadata))
    }

    /// What its file says of where it comes from: words by words.
    #[getter]
    fn metadata(&self) -> Metadata {
        self.metadata.clone()
    }
}

/// Bakes a silhouette texture.
///
/// bake(mesh, hull=None, *, progress=None, **options)
///
/// hull: a Mesh that encloses the other [default: one of at most hull_vertices vertices is made].
/// options: those of the method texture, with underscores for hyphens, for example size=256.
///
/// Returns a Texture. Takes seconds to minutes; nothing is kept of a bake that was cancelled.
#[pyfunction]
#[pyo3(signature = (mesh, hull = None, *, progress = None, **options))]
pub fn bake<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, Mesh>,
    hull: Option<&Bound<'py, Mesh>>,
    progress: Option<&Bound<'py, PyAny>>,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<Texture> {
    let words = method::words(options)?;
    let (mesh, hull) = (mesh.get(), hull.map(|hull| hull.get().named()));
    progress::run(py, progress, |progress| {
        let options = TextureOptions::parse(words.iter().map(String::as_str))?;
        let baked = calls::baked(mesh.named(), hull, &options, None, progress)?;
        let metadata = calls::metadata(mesh.named(), &options)?;
        Ok(Texture { texture: Arc::new(baked.texture), metadata, name: mesh.named().name.clone() })
    })
}
