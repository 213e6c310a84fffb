//! The arrays of a mesh as numpy sees them: the mesh's own memory, which is not written to.
//!
//! numpy's array interface names memory by its address, so that no `unsafe` is needed here; what makes it sound is that the memory stays
//! where it is, unchanged, for as long as an array may read it. The array holds this object, this object holds the mesh, and a
//! [`TriangleMesh`] behind an [`Arc`] neither changes nor moves its rows. See decision 0018.

use numpy::{Element, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use silhouette_core::TriangleMesh;
use std::sync::Arc;

/// Rows of three numbers, and the mesh that holds them.
#[pyclass(frozen, module = "silhouettes")]
pub struct MeshMemory {
    /// Keeps the rows in their place.
    _mesh: Arc<TriangleMesh>,
    address: usize,
    rows: usize,
    /// The type of the numbers as numpy writes it.
    type_string: &'static str,
}

#[pymethods]
impl MeshMemory {
    /// numpy's array interface, version 3.
    #[getter]
    fn __array_interface__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        const IS_READ_ONLY: bool = true;
        let interface = PyDict::new(py);
        interface.set_item("version", 3)?;
        interface.set_item("typestr", self.type_string)?;
        interface.set_item("shape", (self.rows, 3))?;
        interface.set_item("data", (self.address, IS_READ_ONLY))?;
        Ok(interface)
    }
}

/// The positions of a mesh as an array that cannot be written to.
pub fn positions<'py>(py: Python<'py>, mesh: &Arc<TriangleMesh>) -> PyResult<Bound<'py, PyArray2<f32>>> {
    let rows = mesh.positions();
    array(py, mesh, rows.as_ptr() as usize, rows.len(), if cfg!(target_endian = "little") { "<f4" } else { ">f4" })
}

/// The vertex indices of its faces as an array that cannot be written to.
pub fn triangles<'py>(py: Python<'py>, mesh: &Arc<TriangleMesh>) -> PyResult<Bound<'py, PyArray2<u32>>> {
    let rows = mesh.triangles();
    array(py, mesh, rows.as_ptr() as usize, rows.len(), if cfg!(target_endian = "little") { "<u4" } else { ">u4" })
}

fn array<'py, T: Element>(
    py: Python<'py>,
    mesh: &Arc<TriangleMesh>,
    address: usize,
    rows: usize,
    type_string: &'static str,
) -> PyResult<Bound<'py, PyArray2<T>>> {
    let memory = Bound::new(py, MeshMemory { _mesh: Arc::clone(mesh), address, rows, type_string })?;
    Ok(py.import("numpy")?.call_method1("asarray", (memory,))?.cast_into()?)
}
