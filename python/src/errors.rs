//! Failures as exceptions, with the command line's text.

use pyo3::create_exception;
use pyo3::exceptions::{PyKeyboardInterrupt, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use silhouettes::application::Failure;

create_exception!(
    silhouettes,
    Error,
    PyValueError,
    "Bad input: one line that names what is wrong, where, and the mend. A subclass of ValueError."
);

/// The exception of a failure.
pub fn exception(failure: &Failure) -> PyErr {
    let line = failure.to_string();
    match failure {
        Failure::Input(_) => Error::new_err(line),
        Failure::Run(_) => PyRuntimeError::new_err(line),
        Failure::Interrupted => PyKeyboardInterrupt::new_err(line),
    }
}

/// The exception of bad input.
pub fn bad_input(reason: impl std::fmt::Display) -> PyErr {
    exception(&Failure::input(reason))
}
