//! Silhouette edges and loops, once or frame after frame.

use crate::arrays::array_of_rows;
use crate::camera::{Camera, CameraArgument};
use crate::errors::{bad_input, exception};
use crate::mesh::Mesh;
use crate::method;
use crate::progress;
use crate::records::to_python;
use glam::DVec3;
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use silhouette_compare::registry::{Entry, Prepared};
use silhouette_core::method::{ExtractionStats, OptionValues};
use silhouette_core::{SilhouetteEdges, Topology, VertexId, Viewpoint};
use silhouettes::application::Failure;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// A method that extracts edges, with its options.
fn extractor_of(name: &str, options: Option<&Bound<'_, PyDict>>) -> PyResult<(&'static Entry, OptionValues)> {
    let entry = method::find(name)?;
    if !entry.capabilities().edges {
        let known = method::registry().names(|entry| entry.capabilities().edges);
        return Err(bad_input(format_args!("method {name} extracts no edges; choose {known}")));
    }
    let options = method::options(entry, &method::words(options)?)?;
    Ok((entry, options))
}

/// Prepares a method for a mesh, and asks it about one view.
fn find_once<T: Send>(
    py: Python<'_>,
    mesh: &Mesh,
    camera: &CameraArgument<'_>,
    method: &str,
    options: Option<&Bound<'_, PyDict>>,
    find: impl FnOnce(&mut Prepared, &Topology, &Viewpoint) -> Option<T> + Send,
) -> PyResult<T> {
    let (entry, options) = extractor_of(method, options)?;
    let viewpoint = camera.get()?.viewpoint(mesh).map_err(|failure| exception(&failure))?;
    progress::run(py, None, |progress| {
        let prepared = entry.prepare(mesh.prepared(), &options, progress);
        let mut prepared = prepared.map_err(|error| Failure::of_preparation(&mesh.named().name, method, error))?;
        let topology = mesh.prepared().artefact::<Topology>("edges", progress)?;
        let found = find(&mut prepared, &topology, &viewpoint);
        found.ok_or_else(|| Failure::Input(format!("method {method} extracts no edges")))
    })
}

fn end_points(edges: &SilhouetteEdges, topology: &Topology) -> Vec<[u32; 2]> {
    edges.iter().map(|edge| topology.end_points(edge).map(VertexId::get)).collect()
}

fn arrays_of<'py>(py: Python<'py>, loops: Vec<Vec<VertexId>>) -> Vec<Bound<'py, PyArray1<u32>>> {
    let array = |vertices: Vec<VertexId>| PyArray1::from_vec(py, vertices.into_iter().map(VertexId::get).collect());
    loops.into_iter().map(array).collect()
}

/// The silhouette edges of one view.
///
/// edges(mesh, camera=None, method="brute-force", **options)
///
/// camera: a Camera, or an object of trimesh or PyVista that silhouettes.camera understands; by default a three-quarter view.
/// method, options: a method that extracts edges, and its options with underscores for hyphens; silhouettes.methods() lists both.
///
/// Returns an (N, 2) uint32 array: the vertices of each edge, lower one first, sorted. Boundary edges of front faces are among them;
/// hidden edges are too (see visible_lines).
#[pyfunction]
#[pyo3(signature = (mesh, camera = CameraArgument::DEFAULT, method = "brute-force", **options))]
pub fn edges<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, Mesh>,
    camera: CameraArgument<'py>,
    method: &str,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyArray2<u32>>> {
    let found = find_once(py, mesh.get(), &camera, method, options, |prepared, topology, viewpoint| {
        let mut edges = SilhouetteEdges::default();
        prepared.edges()?.extract_edges(viewpoint, &mut edges);
        Some(end_points(&edges, topology))
    })?;
    array_of_rows::<u32, _, 2>(py, found)
}

/// The same edges as closed loops, the front face on the left.
///
/// loops(mesh, camera=None, method="brute-force", **options)
///
/// Returns a list of (n,) uint32 arrays: the vertices of each loop in order, the first of which follows the last.
#[pyfunction]
#[pyo3(signature = (mesh, camera = CameraArgument::DEFAULT, method = "brute-force", **options))]
pub fn loops<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, Mesh>,
    camera: CameraArgument<'py>,
    method: &str,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<Vec<Bound<'py, PyArray1<u32>>>> {
    let mesh = mesh.get();
    let (found, _) = find_once(py, mesh, &camera, method, options, |prepared, topology, viewpoint| {
        prepared.find_edges(mesh.triangle_mesh(), topology, viewpoint)
    })?;
    Ok(arrays_of(py, found.loops))
}

/// An eye, three numbers in the coordinates of the mesh's file, or a camera: what a frame is seen from.
pub fn viewpoint(mesh: &Mesh, from: &Bound<'_, PyAny>) -> PyResult<Viewpoint> {
    if let Ok(eye) = from.extract::<[f64; 3]>() {
        let eye = (DVec3::from(eye) - mesh.triangle_mesh().origin()).as_vec3();
        if !eye.is_finite() {
            return Err(bad_input("eye: three finite numbers are wanted"));
        }
        return Ok(Viewpoint::Perspective { eye });
    }
    let camera: Camera = from.extract::<CameraArgument<'_>>()?.get()?;
    camera.viewpoint(mesh).map_err(|failure| exception(&failure))
}

/// A method prepared for a mesh, which keeps what it learns from frame to frame.
///
/// Extractor(mesh, method="brute-force", *, progress=None, **options)
///
/// For many views of one mesh: preparation is done once, and methods that follow the last view do so.
#[pyclass(frozen, module = "silhouettes")]
pub struct Extractor {
    mesh: Py<Mesh>,
    topology: Arc<Topology>,
    state: Mutex<State>,
}

struct State {
    prepared: Prepared,
    found: SilhouetteEdges,
    stats: ExtractionStats,
    /// How long the last view took.
    took: Duration,
}

impl Extractor {
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[pymethods]
impl Extractor {
    #[new]
    #[pyo3(signature = (mesh, method = "brute-force", *, progress = None, **options))]
    fn new<'py>(
        py: Python<'py>,
        mesh: &Bound<'py, Mesh>,
        method: &str,
        progress: Option<&Bound<'py, PyAny>>,
        options: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Self> {
        let (entry, options) = extractor_of(method, options)?;
        let given = mesh.get();
        let (prepared, topology) = progress::run(py, progress, |progress| {
            let prepared = entry.prepare(given.prepared(), &options, progress);
            let prepared = prepared.map_err(|error| Failure::of_preparation(&given.named().name, method, error))?;
            Ok((prepared, given.prepared().artefact::<Topology>("edges", progress)?))
        })?;
        let (found, stats) = (SilhouetteEdges::default(), ExtractionStats::default());
        let state = Mutex::new(State { prepared, found, stats, took: Duration::ZERO });
        Ok(Self { mesh: mesh.clone().unbind(), topology, state })
    }

    /// The silhouette edges seen from an eye, three numbers in the coordinates of the mesh's file, or by a camera.
    ///
    /// Returns an (N, 2) uint32 array as `edges` does.
    fn update<'py>(&self, py: Python<'py>, eye: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        let viewpoint = viewpoint(self.mesh.get(), eye)?;
        let edges = py.detach(|| {
            let mut state = self.state();
            let State { prepared, found, stats, took } = &mut *state;
            if let Some(method) = prepared.edges() {
                let started = Instant::now();
                *stats = method.extract_edges(&viewpoint, found);
                *took = started.elapsed();
            }
            end_points(found, &self.topology)
        });
        array_of_rows::<u32, _, 2>(py, edges)
    }

    /// What the last update did: a dict of counts, the same on every machine.
    #[getter]
    fn stats<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.state().stats)
    }

    /// Milliseconds that the method took in the last update, without making an array of what it found.
    #[getter]
    fn last_ms(&self) -> f64 {
        self.state().took.as_secs_f64() * 1e3
    }
}
