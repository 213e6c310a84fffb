//! `render`: the picture of a method as an array.

use crate::camera::CameraArgument;
use crate::errors::{bad_input, exception};
use crate::mesh::Mesh;
use crate::method;
use crate::progress;
use numpy::{PyArray1, PyArray3, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use silhouette_compare::drawing::{FrameStyle, Ground};
use silhouette_render::Gpu;
use silhouettes::application::{self, Failure, MethodArguments};
use std::sync::{Mutex, PoisonError};

/// The device, opened when something is drawn for the first time. One picture is drawn at a time.
static DEVICE: Mutex<Option<Gpu>> = Mutex::new(None);

/// Does something with the device, opened if it is not yet.
///
/// # Errors
/// [`Failure`]: there is no device, or what is done fails.
pub fn with_device<T>(work: impl FnOnce(&Gpu) -> Result<T, Failure>) -> Result<T, Failure> {
    let mut device = DEVICE.lock().unwrap_or_else(PoisonError::into_inner);
    let gpu = match device.take() {
        // One that failed once is opened anew.
        Some(gpu) if gpu.check().is_ok() => gpu,
        _ => application::open_device()?,
    };
    work(device.insert(gpu))
}

/// Keeps Mesa's drivers from looking for a display server, as they complain on stderr where there is none.
pub fn silence_drivers(py: Python<'_>) -> PyResult<()> {
    py.import("os")?.getattr("environ")?.call_method1("setdefault", ("NODEVICE_SELECT", "1")).map(drop)
}

/// Draws a mesh by one method: its lines, or the surface that it fills.
///
/// render(mesh, method="brute-force", camera=None, size=None, *, lines_only=False, width=1.5, samples=4, progress=None, **options)
///
/// size: width and height of the picture in pixels [default: the camera's].
/// lines_only: only lines (or the filled surface) are opaque, so that the picture lies over another one.
/// width: of the pen, in pixels. samples: per pixel, 1 or 4.
///
/// Returns an (H, W, 4) uint8 array: red, green, blue (sRGB) and straight alpha, rows from the top.
/// Raises RuntimeError where there is no device to draw on; Mesa's software rasteriser is one.
#[pyfunction]
#[pyo3(signature = (mesh, method = "brute-force", camera = CameraArgument::DEFAULT, size = None, *, lines_only = false,
    width = 1.5, samples = 4, progress = None, **options))]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
pub fn render<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, Mesh>,
    method: &str,
    camera: CameraArgument<'py>,
    size: Option<[u32; 2]>,
    lines_only: bool,
    width: f64,
    samples: u32,
    progress: Option<&Bound<'py, PyAny>>,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyArray3<u8>>> {
    if ![1, 4].contains(&samples) {
        return Err(bad_input(format_args!("samples={samples}: give 1 or 4")));
    }
    let mesh = mesh.get();
    let ground = if lines_only { Ground::Transparent } else { Ground::Paper };
    let arguments = MethodArguments { method: method.to_owned(), set: method::words(options)? };
    let failed = |failure: Failure| exception(&failure);
    let (entry, options) =
        application::method_of_picture(&arguments, width, ground, method::registry()).map_err(failed)?;
    let camera = camera.get()?.of(mesh, size).map_err(failed)?;
    let style = FrameStyle { size: camera.size(), pen_width_px: width, samples, ground };
    silence_drivers(py)?;
    let drawn = progress::run(py, progress, |progress| {
        with_device(|gpu| application::picture(gpu, (entry, &options), mesh.named(), &camera, style, progress))
    })?;
    if let Some(warning) = drawn.warning {
        progress::warn(py, &warning)?;
    }
    let [columns, rows] = camera.size().map(|side| side as usize);
    PyArray1::from_vec(py, drawn.image.rgba).reshape([rows, columns, 4])
}
