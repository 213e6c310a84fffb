//! `Tracker`: silhouette loops that keep their identity from frame to frame.

use crate::edges::viewpoint;
use crate::mesh::Mesh;
use crate::method;
use crate::progress;
use crate::records::to_python;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use silhouette_core::loops::start_vertex;
use silhouette_core::{
    ExtractsEdges, Method, MethodOptions, NoOptions, Progress, SilhouetteEdges, SilhouetteLoops, Viewpoint,
};
use silhouette_tracking::{ExactTracking, LoopEvent, LoopId, Tracking, TrackingOptions};
use silhouettes::application::Failure;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Follows the silhouette loops of a mesh from frame to frame (Hall 2003).
///
/// Tracker(mesh, method="tracking", *, progress=None, **options)
///
/// method, options: "tracking" with its options, underscores for hyphens, for example concavity=0.2; or "tracking-exact", which misses
///     nothing.
#[pyclass(frozen, module = "silhouettes")]
pub struct Tracker {
    mesh: Py<Mesh>,
    method: Mutex<Follower>,
}

/// A method that names loops.
enum Follower {
    Tracking(Tracking),
    Exact(ExactTracking),
}

impl Follower {
    fn prepare(name: &str, words: &[String], mesh: &Mesh, progress: &dyn Progress) -> Result<Self, Failure> {
        let words = words.iter().map(String::as_str);
        let refused = |error| Failure::of_preparation(&mesh.named().name, name, error);
        match name {
            _ if name == Tracking::INFO.name => {
                let options = TrackingOptions::parse(words)?;
                Tracking::prepare(mesh.prepared(), &options, progress).map(Self::Tracking).map_err(refused)
            }
            _ if name == ExactTracking::INFO.name => {
                let options = NoOptions::parse(words)?;
                ExactTracking::prepare(mesh.prepared(), &options, progress).map(Self::Exact).map_err(refused)
            }
            _ => {
                let [one, other] = [Tracking::INFO.name, ExactTracking::INFO.name];
                Err(Failure::Input(format!("method {name} names no loops; choose {one} or {other}")))
            }
        }
    }

    fn update(&mut self, viewpoint: &Viewpoint) -> &SilhouetteLoops {
        match self {
            Self::Tracking(method) => method.tracker_mut().update(viewpoint),
            Self::Exact(method) => {
                method.extract_edges(viewpoint, &mut SilhouetteEdges::default());
                method.tracker().loops()
            }
        }
    }

    fn tracker(&self) -> &silhouette_tracking::Tracker {
        match self {
            Self::Tracking(method) => method.tracker(),
            Self::Exact(method) => method.tracker(),
        }
    }
}

impl Tracker {
    fn method(&self) -> MutexGuard<'_, Follower> {
        self.method.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

fn numbers(ids: &[LoopId]) -> Vec<u64> {
    ids.iter().map(|id| id.get()).collect()
}

#[pymethods]
impl Tracker {
    #[new]
    #[pyo3(signature = (mesh, method = "tracking", *, progress = None, **options))]
    fn new<'py>(
        py: Python<'py>,
        mesh: &Bound<'py, Mesh>,
        method: &str,
        progress: Option<&Bound<'py, PyAny>>,
        options: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Self> {
        let words = method::words(options)?;
        let given = mesh.get();
        let follower = progress::run(py, progress, |progress| Follower::prepare(method, &words, given, progress))?;
        Ok(Self { mesh: mesh.clone().unbind(), method: Mutex::new(follower) })
    }

    /// The loops seen from an eye, three numbers in the coordinates of the mesh's file, or by a camera.
    ///
    /// Returns a list of (n,) uint32 arrays: the vertices of each loop in order, front faces on the left. `ids` and `events` are then
    /// those of this frame.
    fn update<'py>(&self, py: Python<'py>, eye: &Bound<'py, PyAny>) -> PyResult<Vec<Bound<'py, PyArray1<u32>>>> {
        let mesh = self.mesh.get();
        let viewpoint = viewpoint(mesh, eye)?;
        let loops: Vec<Vec<u32>> = py.detach(|| {
            let mut method = self.method();
            let loops = method.update(&viewpoint);
            let start = |&half_edge: &_| start_vertex(mesh.triangle_mesh(), half_edge).get();
            loops.iter().map(|half_edges| half_edges.iter().map(start).collect()).collect()
        });
        Ok(loops.into_iter().map(|vertices| PyArray1::from_vec(py, vertices)).collect())
    }

    /// (n,) uint64: the id of each loop of the last frame. A loop keeps its id while it lives; none is used twice.
    #[getter]
    fn ids<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u64>> {
        PyArray1::from_vec(py, numbers(self.method().tracker().ids()))
    }

    /// What happened to loops in the last frame: a list of dicts with "kind" ("birth", "death", "split" or "merge") and lists of ids,
    /// "from" and "into".
    #[getter]
    fn events<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let method = self.method();
        let dict = |event: LoopEvent<'_>| {
            let (kind, from, into) = match event {
                LoopEvent::Birth { id } => ("birth", Vec::new(), numbers(&[id])),
                LoopEvent::Death { id } => ("death", numbers(&[id]), Vec::new()),
                LoopEvent::Split { from, into } => ("split", numbers(&[from]), numbers(into)),
                LoopEvent::Merge { from, into } => ("merge", numbers(from), numbers(&[into])),
            };
            let dict = PyDict::new(py);
            dict.set_item("kind", kind)?;
            dict.set_item("from", from)?;
            dict.set_item("into", into)?;
            Ok(dict)
        };
        PyList::new(py, method.tracker().events().iter().map(dict).collect::<PyResult<Vec<_>>>()?)
    }

    /// What the last frame took: a dict of counts, the same on every machine.
    #[getter]
    fn stats<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.method().tracker().stats().extraction())
    }
}
