//! The command line, which comes with the package.

use crate::method::registry;
use pyo3::prelude::*;
use std::ffi::OsString;

/// Runs the command line with these words, the program's name first; returns its exit code.
///
/// Prints on the process's own stdout and stderr, and takes Ctrl-C over: meant for a process of its own.
#[pyfunction]
pub fn run_program(py: Python<'_>, words: Vec<OsString>) -> u8 {
    py.detach(|| silhouettes::exit_code(words, registry()))
}
