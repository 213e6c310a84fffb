//! Arrays of Python and vectors of Rust.

use crate::errors::bad_input;
use glam::{DVec3, Vec3};
use numpy::{Element, PyUntypedArrayMethods};
use numpy::{PyArray1, PyArray2, PyArrayDescrMethods, PyArrayMethods, PyReadonlyArray2, PyUntypedArray};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Coordinates as they were given: of 32 bits, which are positions, or of 64.
pub enum Coordinates {
    /// float32.
    Narrow(Vec<Vec3>),
    /// float64.
    Wide(Vec<DVec3>),
}

/// An array of `n` rows of three, from anything that numpy makes one of.
fn rows_of_three<'py>(what: &str, given: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyUntypedArray>> {
    let array = match given.cast::<PyUntypedArray>() {
        Ok(array) => array.clone(),
        Err(_) => {
            let made = given.py().import("numpy")?.call_method1("asarray", (given,));
            made.map_err(|error| bad_input(format_args!("{what}: not an array ({error})")))?.cast_into()?
        }
    };
    match array.shape() {
        [_, 3] => Ok(array),
        // What `numpy.empty(0)` and an empty list are.
        [0] => Ok(array.call_method1("reshape", ((0, 3),))?.cast_into()?),
        shape => {
            let shape = shape.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
            Err(bad_input(format_args!("{what}: an array of shape ({shape}); give one of shape (n, 3)")))
        }
    }
}

/// The rows of an array that has these elements, in one copy if it is C-contiguous.
fn typed<'py, T: Element>(array: &Bound<'py, PyUntypedArray>) -> PyResult<PyReadonlyArray2<'py, T>> {
    let options = PyDict::new(array.py());
    options.set_item("dtype", T::get_dtype(array.py()))?;
    let array = array.py().import("numpy")?.call_method("ascontiguousarray", (array,), Some(&options))?;
    Ok(array.cast::<PyArray2<T>>()?.try_readonly()?)
}

fn kind(array: &Bound<'_, PyUntypedArray>) -> (char, usize) {
    (array.dtype().kind() as char, array.dtype().itemsize())
}

/// Coordinates of vertices. float32 stays as it is, every other type of real number is read as float64.
pub fn coordinates(given: &Bound<'_, PyAny>) -> PyResult<Coordinates> {
    let array = rows_of_three("vertices", given)?;
    match kind(&array) {
        ('f', 4) => {
            let array = typed::<f32>(&array)?;
            Ok(Coordinates::Narrow(bytemuck::cast_slice(array.as_slice()?).to_vec()))
        }
        ('f' | 'i' | 'u', _) => {
            let array = typed::<f64>(&array)?;
            Ok(Coordinates::Wide(bytemuck::cast_slice(array.as_slice()?).to_vec()))
        }
        _ => Err(bad_input(format_args!("vertices: an array of {}; give float32 or float64", array.dtype()))),
    }
}

/// Vertex indices of faces.
pub fn triangles(given: &Bound<'_, PyAny>) -> PyResult<Vec<[u32; 3]>> {
    let array = rows_of_three("faces", given)?;
    match kind(&array) {
        ('u', 4) => Ok(bytemuck::cast_slice(typed::<u32>(&array)?.as_slice()?).to_vec()),
        ('i' | 'u', bytes) if bytes < 8 || kind(&array).0 == 'i' => {
            let array = typed::<i64>(&array)?;
            let indices = array.as_slice()?;
            let mut corners = Vec::with_capacity(indices.len());
            for (place, &index) in indices.iter().enumerate() {
                corners.push(u32::try_from(index).map_err(|_| {
                    let face = place / 3;
                    bad_input(format_args!("faces: face {face} names vertex {index}; indices run from 0"))
                })?);
            }
            Ok(bytemuck::allocation::try_cast_vec(corners).unwrap_or_else(|(_, corners)| {
                corners.chunks_exact(3).map(|corner| [corner[0], corner[1], corner[2]]).collect()
            }))
        }
        // An empty list has no type of its own.
        _ if array.shape()[0] == 0 => Ok(Vec::new()),
        _ => Err(bad_input(format_args!("faces: an array of {}; give uint32 or int64", array.dtype()))),
    }
}

/// Rows of `N` as an array of shape (rows, N), which takes the vector's memory over.
pub fn array_of_rows<'py, T, R, const N: usize>(py: Python<'py>, rows: Vec<R>) -> PyResult<Bound<'py, PyArray2<T>>>
where
    T: Element + bytemuck::Pod,
    R: bytemuck::Pod,
{
    const { assert!(size_of::<R>() == N * size_of::<T>()) };
    let count = rows.len();
    let flat: Vec<T> =
        bytemuck::allocation::try_cast_vec(rows).unwrap_or_else(|(_, rows)| bytemuck::cast_slice(&rows).to_vec());
    PyArray1::from_vec(py, flat).reshape([count, N])
}
