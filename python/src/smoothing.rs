//! `smooth`: the triangles that stand for a coarse mesh in one view.

use crate::arrays::array_of_rows;
use crate::camera::CameraArgument;
use crate::errors::exception;
use crate::mesh::Mesh;
use crate::method;
use crate::progress;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use silhouettes::calls;

/// Smooths the outline of a coarse mesh in one view.
///
/// smooth(mesh, camera=None, method="smoothing", *, progress=None, **options)
///
/// method, options: a method that makes triangles of its own, and its options with underscores for hyphens, for example
///     tolerance=0.25.
///
/// Returns a dict: "vertices", (n, 3) float64 in the coordinates of the mesh's file; "normals", (n, 3) float32 of length 1, or 0 where
/// there is none; "faces", (m, 3) uint32. Where normals differ on both sides of an edge its vertices are there twice.
/// `render` draws the picture by the same methods.
#[pyfunction]
#[pyo3(signature = (mesh, camera = CameraArgument::DEFAULT, method = "smoothing", *, progress = None, **options))]
pub fn smooth<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, Mesh>,
    camera: CameraArgument<'py>,
    method: &str,
    progress: Option<&Bound<'py, PyAny>>,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyDict>> {
    let mesh = mesh.get();
    let camera = camera.get()?.of(mesh, None).map_err(|failure| exception(&failure))?;
    let words = method::words(options)?;
    let view_mesh = progress::run(py, progress, |progress| {
        calls::view_mesh((method, &words), mesh.named(), &camera, method::registry(), progress)
    })?;
    let origin = mesh.triangle_mesh().origin();
    let positions = view_mesh.positions.iter().map(|position| (origin + position.as_dvec3()).to_array());
    let dict = PyDict::new(py);
    dict.set_item("vertices", array_of_rows::<f64, _, 3>(py, positions.collect::<Vec<[f64; 3]>>())?)?;
    dict.set_item("normals", array_of_rows::<f32, _, 3>(py, view_mesh.normals)?)?;
    dict.set_item("faces", array_of_rows::<u32, _, 3>(py, view_mesh.triangles)?)?;
    Ok(dict)
}
