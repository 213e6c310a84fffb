//! Visible lines and the outline of one view.

use crate::arrays::array_of_rows;
use crate::camera::CameraArgument;
use crate::errors::exception;
use crate::mesh::Mesh;
use crate::method;
use crate::progress;
use glam::{DVec2, DVec3};
use numpy::PyArray2;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use silhouette_core::{Topology, VertexId};
use silhouette_visibility::{Chain, LineFinder as Finder, LineOptions, LineScene, Lines, SegmentSource};
use silhouettes::application::Failure;
use silhouettes::calls;
use std::sync::{Arc, Mutex, PoisonError};

/// The lines of a view, hidden ones removed.
///
/// visible_lines(mesh, camera=None, *, progress=None, **options)
///
/// options: those of the command `silhouettes lines` that say which lines are wanted, with underscores for hyphens: creases=30 (or
///     ridge=, valley=, in degrees), hidden="solid" (hidden lines as well), no_boundaries=True, intersections=True, all_edges=True.
///
/// Returns a list of dicts, one for each chain:
///     "kind": "silhouette", "boundary", "ridge", "valley", "intersection" or "mesh"
///     "invisibility": how many layers hide it, 0 where it is visible
///     "closed": whether the last point is joined to the first
///     "points": (n, 3) float64, in the coordinates of the mesh's file
///     "pixels": (n, 2) float64, the same in the picture: origin at its top left, y down, centres of pixels at .5
///     "edges": (m, 2) uint32, the vertices of the mesh edge that each segment lies on; None along intersections
/// `pandas.DataFrame` takes the list as it is.
#[pyfunction]
#[pyo3(signature = (mesh, camera = CameraArgument::DEFAULT, *, progress = None, **options))]
pub fn visible_lines<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, Mesh>,
    camera: CameraArgument<'py>,
    progress: Option<&Bound<'py, PyAny>>,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyList>> {
    let wanted = wanted(&method::command_words(options)?)?;
    let (lines, topology) = find(py, mesh.get(), &camera, &wanted, progress)?;
    chains(py, &lines, &topology)
}

/// The outline of a view: the boundary of all that the mesh covers in the picture.
///
/// outline(mesh, camera=None, *, progress=None)
///
/// Returns a list of connected regions. Each is a list of rings, (n, 2) float64 arrays of pixels (origin at the top left, y down), closed
/// by their first points: the outer ring, counter-clockwise as seen, then its holes, clockwise.
#[pyfunction]
#[pyo3(signature = (mesh, camera = CameraArgument::DEFAULT, *, progress = None))]
pub fn outline<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, Mesh>,
    camera: CameraArgument<'py>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Vec<Vec<Bound<'py, PyArray2<f64>>>>> {
    let wanted = wanted(&["--outline=only".to_owned()])?;
    let (lines, _) = find(py, mesh.get(), &camera, &wanted, progress)?;
    let region = |rings: &[Vec<DVec2>]| rings.iter().map(|ring| pixels(py, ring)).collect();
    lines.outline.regions().map(region).collect()
}

/// Finds the lines of many views of a mesh.
///
/// LineFinder(mesh, *, progress=None, **options)
///
/// options: as of visible_lines. Preparation takes longer than for one view, each view less.
#[pyclass(frozen, module = "silhouettes")]
pub struct LineFinder {
    mesh: Py<Mesh>,
    wanted: LineOptions,
    topology: Arc<Topology>,
    finder: Mutex<Finder>,
}

#[pymethods]
impl LineFinder {
    #[new]
    #[pyo3(signature = (mesh, *, progress = None, **options))]
    fn new<'py>(
        py: Python<'py>,
        mesh: &Bound<'py, Mesh>,
        progress: Option<&Bound<'py, PyAny>>,
        options: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Self> {
        let wanted = wanted(&method::command_words(options)?)?;
        let given = mesh.get();
        let (finder, topology) = progress::run(py, progress, |progress| {
            let finder = Finder::for_many_views(LineScene::new(Arc::clone(given.prepared())), progress);
            let finder = finder.map_err(|error| Failure::of_preparation(given.name(), "visible-lines", error))?;
            Ok((finder, given.prepared().artefact::<Topology>("lines", progress)?))
        })?;
        Ok(Self { mesh: mesh.clone().unbind(), wanted, topology, finder: Mutex::new(finder) })
    }

    /// The lines of a view, as visible_lines returns them.
    #[pyo3(signature = (camera = CameraArgument::DEFAULT, *, progress = None))]
    fn find<'py>(
        &self,
        py: Python<'py>,
        camera: CameraArgument<'py>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyList>> {
        let mesh = self.mesh.get();
        let camera = camera.get()?.of(mesh, None).map_err(|failure| exception(&failure))?;
        let lines = progress::run(py, progress, |progress| {
            let mut finder = self.finder.lock().unwrap_or_else(PoisonError::into_inner);
            let found = finder.find(&camera, &self.wanted, progress);
            found.map_err(|error| calls::of_finding(mesh.name(), error))
        })?;
        chains(py, &lines, &self.topology)
    }
}

/// The lines that words want.
fn wanted(words: &[String]) -> PyResult<LineOptions> {
    calls::line_options(words, method::registry()).map_err(|failure| exception(&failure))
}

fn chains<'py>(py: Python<'py>, lines: &Lines, topology: &Topology) -> PyResult<Bound<'py, PyList>> {
    let chains = lines.chains.iter().map(|chain| chain_as_dict(py, &chain, lines.origin, topology));
    PyList::new(py, chains.collect::<PyResult<Vec<_>>>()?)
}

fn find<'py>(
    py: Python<'py>,
    mesh: &Mesh,
    camera: &CameraArgument<'py>,
    wanted: &LineOptions,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Lines, Arc<Topology>)> {
    let camera = camera.get()?.of(mesh, None).map_err(|failure| exception(&failure))?;
    progress::run(py, progress, |progress| {
        let lines = calls::lines(mesh.named(), &camera, wanted, progress)?;
        Ok((lines, mesh.prepared().artefact::<Topology>("lines", progress)?))
    })
}

fn pixels<'py>(py: Python<'py>, points: &[DVec2]) -> PyResult<Bound<'py, PyArray2<f64>>> {
    array_of_rows::<f64, _, 2>(py, points.iter().map(DVec2::to_array).collect::<Vec<_>>())
}

fn chain_as_dict<'py>(
    py: Python<'py>,
    chain: &Chain<'_>,
    origin: DVec3,
    topology: &Topology,
) -> PyResult<Bound<'py, PyDict>> {
    let points: Vec<[f64; 3]> = chain.points.iter().map(|&point| (origin + point).to_array()).collect();
    let edge = |source: &SegmentSource| match source {
        SegmentSource::Edge(edge) => Some(topology.end_points(*edge).map(VertexId::get)),
        SegmentSource::Curve(_) | SegmentSource::Intersection(_) => None,
    };
    let edges: Option<Vec<[u32; 2]>> = chain.sources.iter().map(edge).collect();
    let dict = PyDict::new(py);
    dict.set_item("kind", chain.style.kind.name())?;
    dict.set_item("invisibility", chain.style.invisibility)?;
    dict.set_item("closed", chain.closed)?;
    dict.set_item("points", array_of_rows::<f64, _, 3>(py, points)?)?;
    dict.set_item("pixels", pixels(py, chain.pixels)?)?;
    dict.set_item("edges", edges.map(|edges| array_of_rows::<u32, _, 2>(py, edges)).transpose()?)?;
    Ok(dict)
}
