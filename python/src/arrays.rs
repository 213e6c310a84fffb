//! Arrays of Python and vectors of Rust.

use crate::errors::bad_input;
use glam::Vec3;
use numpy::{Element, PyUntypedArrayMethods};
use numpy::{PyArray1, PyArray2, PyArrayDescrMethods, PyArrayMethods, PyReadonlyArray2, PyUntypedArray};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::fmt::Display;

/// Coordinates as they were given: of 32 bits, which are positions, or of 64.
pub enum Coordinates<'py> {
    /// float32, copied.
    Narrow(Vec<Vec3>),
    /// float64, where they lie.
    Wide(PyReadonlyArray2<'py, f64>),
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
pub fn coordinates<'py>(given: &Bound<'py, PyAny>) -> PyResult<Coordinates<'py>> {
    let array = rows_of_three("vertices", given)?;
    match kind(&array) {
        ('f', 4) => {
            let array = typed::<f32>(&array)?;
            Ok(Coordinates::Narrow(bytemuck::cast_slice(array.as_slice()?).to_vec()))
        }
        ('f' | 'i' | 'u', _) => Ok(Coordinates::Wide(typed::<f64>(&array)?)),
        _ => Err(bad_input(format_args!("vertices: an array of {}; give float32 or float64", array.dtype()))),
    }
}

/// Vertex indices of faces.
pub fn triangles(given: &Bound<'_, PyAny>) -> PyResult<Vec<[u32; 3]>> {
    let array = rows_of_three("faces", given)?;
    match kind(&array) {
        ('u', 4) => Ok(bytemuck::cast_slice(typed::<u32>(&array)?.as_slice()?).to_vec()),
        ('i', 4) => corners(typed::<i32>(&array)?.as_slice()?),
        ('i', _) | ('u', 1 | 2) => corners(typed::<i64>(&array)?.as_slice()?),
        // An empty list has no type of its own.
        _ if array.shape()[0] == 0 => Ok(Vec::new()),
        _ => Err(bad_input(format_args!("faces: an array of {}; give uint32 or int64", array.dtype()))),
    }
}

/// Three indices for each face, of numbers with a sign.
fn corners<T: Copy + TryInto<u32> + Display>(indices: &[T]) -> PyResult<Vec<[u32; 3]>> {
    let corner = |face: usize, index: T| {
        let refused = |_| bad_input(format_args!("faces: face {face} names vertex {index}; indices run from 0"));
        index.try_into().map_err(refused)
    };
    // Of this size from the beginning: collected, it would grow to up to twice of it.
    let mut faces = Vec::with_capacity(indices.len() / 3);
    for (face, ids) in indices.chunks_exact(3).enumerate() {
        faces.push([corner(face, ids[0])?, corner(face, ids[1])?, corner(face, ids[2])?]);
    }
    Ok(faces)
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
