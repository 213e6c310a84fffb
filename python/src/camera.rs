//! `Camera`: from where a mesh is seen, in the command line's terms.

use crate::errors::{bad_input, exception};
use crate::mesh::Mesh;
use pyo3::prelude::*;
use silhouette_core::mesh::Bounds;
use silhouette_core::{Camera as CoreCamera, Viewpoint};
use silhouettes::application::{CameraArguments, Failure};

/// From where a mesh is seen.
///
/// Camera(*, view=None, eye=None, target=None, up=None, fov=None, ortho=None, up_axis="y", size=(1024, 1024))
///
/// view: a named view: "three-quarter" (the default), "front", "back", "left", "right", "top", "bottom" or "iso".
/// eye, target, up: three numbers each, in the coordinates of the mesh's file. Without them the view frames the mesh.
/// fov: vertical field of view in degrees, 40 by default.
/// ortho: for an orthographic view, its height in units of the mesh, or "fit".
/// up_axis: which axis of the mesh points up in named views, "y" or "z".
/// size: width and height of the picture in pixels.
///
/// A camera stands for itself: what it leaves open is decided for each mesh that it sees.
#[pyclass(frozen, module = "silhouettes")]
#[derive(Clone)]
pub struct Camera {
    arguments: CameraArguments,
    words: Vec<String>,
}

impl Camera {
    fn of_words(words: Vec<String>) -> PyResult<Self> {
        let arguments = CameraArguments::of_words(words.iter().map(String::as_str));
        Ok(Self { arguments: arguments.map_err(|failure| exception(&failure))?, words })
    }

    /// The words by which the command line makes this camera.
    pub fn words(&self) -> &[String] {
        &self.words
    }

    /// The camera for a mesh, whose faces are there.
    pub fn of(&self, mesh: &Mesh, size: Option<[u32; 2]>) -> Result<CoreCamera, Failure> {
        let (bounds, origin) = (bounds(mesh)?, mesh.triangle_mesh().origin());
        match size {
            Some(size) => self.arguments.with_size(size).camera(&bounds, origin),
            None => self.arguments.camera(&bounds, origin),
        }
    }

    /// What facing depends on, for a mesh whose faces are there.
    pub fn viewpoint(&self, mesh: &Mesh) -> Result<Viewpoint, Failure> {
        self.arguments.viewpoint(&bounds(mesh)?, mesh.triangle_mesh().origin())
    }
}

fn bounds(mesh: &Mesh) -> Result<Bounds, Failure> {
    mesh.bounds().ok_or_else(|| Failure::Input(format!("{}: has no face", mesh.named().name)))
}

/// Three numbers as the command line takes them.
fn point([x, y, z]: [f64; 3]) -> String {
    format!("{x:?},{y:?},{z:?}")
}

#[pymethods]
impl Camera {
    #[new]
    #[pyo3(signature = (*, view = None, eye = None, target = None, up = None, fov = None, ortho = None, up_axis = "y", size = None))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
    fn new(
        view: Option<&str>,
        eye: Option<[f64; 3]>,
        target: Option<[f64; 3]>,
        up: Option<[f64; 3]>,
        fov: Option<f64>,
        ortho: Option<Bound<'_, PyAny>>,
        up_axis: &str,
        size: Option<[u32; 2]>,
    ) -> PyResult<Self> {
        let ortho = ortho.map(|height| match height.extract::<f64>() {
            Ok(height) => format!("{height:?}"),
            Err(_) => height.to_string(),
        });
        let [width, height] = size.unwrap_or([1024, 1024]);
        let options = [
            ("view", view.map(str::to_owned)),
            ("eye", eye.map(point)),
            ("target", target.map(point)),
            ("up", up.map(point)),
            ("fov", fov.map(|degrees| format!("{degrees:?}"))),
            ("ortho", ortho),
            ("up-axis", Some(up_axis.to_owned())),
            ("size", Some(format!("{width}x{height}"))),
        ];
        Self::of_words(options.into_iter().filter_map(|(name, word)| Some(format!("--{name}={}", word?))).collect())
    }

    /// Width and height of the picture in pixels.
    #[getter]
    fn size(&self) -> [u32; 2] {
        self.arguments.size()
    }

    fn __repr__(&self) -> String {
        format!("<silhouettes.Camera {}>", self.words.join(" "))
    }
}

/// The camera that an argument stands for: a `Camera`, None for the default view, or an object that the package knows how to read.
pub struct CameraArgument<'py>(Option<Bound<'py, Camera>>);

impl<'a, 'py> FromPyObject<'a, 'py> for CameraArgument<'py> {
    type Error = PyErr;

    fn extract(given: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        if given.is_none() {
            return Ok(Self(None));
        }
        if let Ok(camera) = given.cast::<Camera>() {
            return Ok(Self(Some(camera.to_owned())));
        }
        let made = given.py().import("silhouettes.cameras")?.call_method1("camera", (given,))?;
        Ok(Self(Some(made.cast_into::<Camera>().map_err(|_| bad_input("camera: not a camera"))?)))
    }
}

impl CameraArgument<'_> {
    /// The default view.
    pub const DEFAULT: Self = Self(None);

    /// The camera, or that of the default view.
    pub fn get(&self) -> PyResult<Camera> {
        match &self.0 {
            Some(camera) => Ok(camera.get().clone()),
            None => Camera::of_words(Vec::new()),
        }
    }
}
