//! The Python package `silhouettes`: the libraries of this workspace with arrays in and out. Each file is one job; nothing is computed here.
//!
//! Calls that take long run in [`progress`], without the interpreter's lock.

#![expect(clippy::needless_pass_by_value, reason = "what is extracted from Python's arguments belongs to the function")]

mod arrays;
mod camera;
mod comparison;
mod edges;
mod errors;
mod lines;
mod mesh;
mod mesh_memory;
mod method;
mod picture;
mod program;
mod progress;
mod records;
mod smoothing;
mod texture;
mod tracker;

use pyo3::prelude::*;

/// What the package re-exports.
#[pymodule(name = "_silhouettes")]
mod module {
    #[pymodule_export]
    use crate::camera::Camera;
    #[pymodule_export]
    use crate::comparison::{compare, methods, recommend, reproduce};
    #[pymodule_export]
    use crate::edges::{Extractor, edges, loops};
    #[pymodule_export]
    use crate::errors::Error;
    #[pymodule_export]
    use crate::lines::{LineFinder, outline, visible_lines, write_lines};
    #[pymodule_export]
    use crate::mesh::{Mesh, load};
    #[pymodule_export]
    use crate::picture::render;
    #[pymodule_export]
    use crate::program::run_program;
    #[pymodule_export]
    use crate::smoothing::smooth;
    #[pymodule_export]
    use crate::texture::{Texture, bake};
    #[pymodule_export]
    use crate::tracker::Tracker;
}
