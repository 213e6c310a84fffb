//! `compare`, `recommend` and `reproduce`: what they measure, as records.

use crate::errors::{bad_input, exception};
use crate::mesh::Mesh;
use crate::method;
use crate::picture::{silence_drivers, with_device};
use crate::progress;
use crate::records::{record_of_row, to_python};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use serde::Serialize;
use silhouette_compare::Profile;
use silhouette_compare::recommend::Recommendation;
use silhouette_compare::record::flat::Table;
use silhouette_compare::runner::NamedMesh;
use silhouette_papers::{Figure, figure};
use silhouettes::application::Failure;
use silhouettes::calls::{self, Question};

fn named(meshes: &[Py<Mesh>]) -> Vec<NamedMesh> {
    meshes.iter().map(|mesh| mesh.get().named().clone()).collect()
}

/// Compares methods on meshes: pictures, speed, accuracy.
///
/// compare(meshes, *, views=False, progress=None, **options)
///
/// meshes: a list of Mesh; may be empty where a scene names its own.
/// views: a record for each scored view rather than for each method with its options on a mesh.
/// options: those of the command `silhouettes compare`, with underscores for hyphens, for example scene="scene.toml",
///     profile="full", methods="brute-force,tracking", set=["tracking.concavity=0,0.5"], sweep="tracking.concavity".
///
/// Returns a list of dicts, which `pandas.DataFrame` takes as they are. Columns are those of the report's CSV files: times in
/// milliseconds, lengths in pixels, options as METHOD.OPTION.
/// Warns of each method that does not take a mesh: there is no record of it.
/// Needs a device to draw on. Takes about a minute for each mesh with all methods.
#[pyfunction]
#[pyo3(signature = (meshes, *, views = false, progress = None, **options))]
pub fn compare<'py>(
    py: Python<'py>,
    meshes: Vec<Py<Mesh>>,
    views: bool,
    progress: Option<&Bound<'py, PyAny>>,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyList>> {
    let (words, meshes) = (method::command_words(options)?, named(&meshes));
    silence_drivers(py)?;
    let table = progress::run(py, progress, |progress| {
        let compared = with_device(|gpu| calls::compare(&words, &meshes, gpu, method::registry(), progress))?;
        Ok(if views { Table::of_views(&compared.cells) } else { Table::of_cells(&compared.cells) })
    })?;
    let records = table.rows.iter().map(|row| record_of_row(py, &table.columns, row));
    PyList::new(py, records.collect::<PyResult<Vec<_>>>()?)
}

/// One candidate, and what the answer says of it.
#[derive(Serialize)]
struct Candidate<'a> {
    role: &'static str,
    #[serde(flatten)]
    finding: &'a silhouette_compare::recommend::Finding,
}

/// The chosen candidate first, then those that the answer names beside it, then all that were measured.
fn candidates(found: &Recommendation) -> Vec<Candidate<'_>> {
    let better = found.one_step_better.as_ref().map(|better| &better.better);
    let named = [
        ("chosen", found.chosen.as_ref()),
        ("runner-up", found.runner_up.as_ref()),
        ("one-step-better", better),
        ("least-error-in-time", found.least_error_in_time.as_ref()),
        ("fastest-within-error", found.fastest_within_error.as_ref()),
    ];
    let named = named.into_iter().filter_map(|(role, finding)| Some(Candidate { role, finding: finding? }));
    let failed = found.failed.iter().map(|finding| Candidate { role: "failed", finding });
    let measured = found.measured.iter().map(|finding| Candidate { role: "measured", finding });
    named.chain(failed).chain(measured).collect()
}

/// Says which method to use on a mesh: the fastest within an error and a time, by measurements on it.
///
/// recommend(mesh, *, progress=None, **options)
///
/// options: those of the command `silhouettes recommend`, with underscores for hyphens: goal="lines", "fill" or "loops" (which
///     needs no device), error="missed_1px=0.02", max_ms=16.6, seconds=20, size="512x512", no_cache=True.
///
/// Returns a list of dicts, which `pandas.DataFrame` takes as they are: "role" ("chosen" first, where a method keeps to the limits;
/// then "runner-up", "one-step-better", "least-error-in-time", "fastest-within-error", "failed", and "measured" for everything),
/// "method", "set" (options that are not at their defaults), "views", "ms", "worst_ms", "worst_error", and "promise", a dict.
#[pyfunction]
#[pyo3(signature = (mesh, *, progress = None, **options))]
pub fn recommend<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, Mesh>,
    progress: Option<&Bound<'py, PyAny>>,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    let question = Question::of_words(&method::command_words(options)?, method::registry());
    let question = question.map_err(|failure| exception(&failure))?;
    let mesh = mesh.get().named();
    silence_drivers(py)?;
    let (found, _) = progress::run(py, progress, |progress| {
        if question.needs_device() {
            with_device(|gpu| question.answer(mesh, Some(gpu), method::registry(), progress))
        } else {
            question.answer(mesh, None, method::registry(), progress)
        }
    })?;
    to_python(py, &candidates(&found))
}

/// Measures what a paper printed.
///
/// reproduce(paper, meshes=(), *, profile="quick", progress=None)
///
/// paper: "image-precision", "tracking", "silhouette-texture", "edge-mesh" or "smoothing", as `silhouettes reproduce --help` lists them.
/// meshes: a list of Mesh [default: built-in shapes]. profile: "quick" or "full".
///
/// Returns a list of dicts, which `pandas.DataFrame` takes as they are: "method", "table", "row", "metric", "unit", "paper" (the printed
/// value), "ours", "ratio" (None unless "comparable"), "comparable", "note".
#[pyfunction]
#[pyo3(signature = (paper, meshes = Vec::new(), *, profile = "quick", progress = None))]
pub fn reproduce<'py>(
    py: Python<'py>,
    paper: &str,
    meshes: Vec<Py<Mesh>>,
    profile: &str,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let known = || silhouette_papers::ALL.map(|paper| paper.name).join(", ");
    let found = silhouette_papers::find(paper);
    let paper = found.ok_or_else(|| bad_input(format_args!("there is no paper '{paper}'; there are {}", known())))?;
    let found = Profile::NAMED.into_iter().find(|(name, _)| *name == profile);
    let (_, profile) =
        found.ok_or_else(|| bad_input(format_args!("there is no profile '{profile}'; give quick or full")))?;
    let meshes = named(&meshes);
    silence_drivers(py)?;
    let figures: Vec<Figure> = progress::run(py, progress, |progress| {
        let meshes = if meshes.is_empty() { calls::default_meshes(paper, progress)? } else { meshes };
        let measured = if paper.needs_gpu {
            with_device(|gpu| calls::reproduction(paper, profile, &meshes, Some(gpu), progress))
        } else {
            calls::reproduction(paper, profile, &meshes, None, progress)
        }?;
        Ok(figure::figures(paper.name, &measured.measured.tables))
    })?;
    to_python(py, &figures)
}

/// What each method is: a list of dicts as `silhouettes methods --json` says them, with capabilities and options.
#[pyfunction]
pub fn methods(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    let text = calls::methods(method::registry()).map_err(|failure: Failure| exception(&failure))?;
    py.import("json")?.call_method1("loads", (text,))
}
