//! Visible lines and the outline of one view, as arrays and as files.

use crate::arrays::array_of_rows;
use crate::camera::CameraArgument;
use crate::errors::{bad_input, exception};
use crate::mesh::Mesh;
use crate::method;
use crate::progress;
use glam::{DVec2, DVec3};
use numpy::PyArray2;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use silhouette_core::{Progress, Topology, VertexId};
use silhouette_visibility::{Chain, LineFinder as Finder, LineOptions, LineScene, Lines, SegmentSource};
use silhouettes::application::Failure;
use silhouettes::calls::{self, WantedLines};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// The lines of a view, hidden ones removed.
///
/// visible_lines(mesh, camera=None, *, progress=None, **options)
///
/// options: those of the command `silhouettes lines` that say which lines are wanted, with underscores for hyphens: creases=30 (or
///     ridge=, valley=, in degrees), hidden="solid" (hidden lines as well), no_boundaries=True, intersections=True, all_edges=True,
///     materials=True; section=(x, y, z, nx, ny, nz), a plane that cuts the mesh open, or a list of such; only=, without= and mask=,
///     names of parts; weld=, heal= and orient= as the methods of Mesh.
///
/// Returns a list of dicts, one for each chain:
///     "kind": "silhouette", "boundary", "ridge", "valley", "material", "intersection", "section" or "mesh"
///     "invisibility": how many layers hide it, 0 where it is visible
///     "closed": whether the last point is joined to the first
///     "points": (n, 3) float64, in the coordinates of the mesh's file
///     "pixels": (n, 2) float64, the same in the picture: origin at its top left, y down, centres of pixels at .5
///     "edges": (m, 2) uint32, the vertices of the mesh edge that each segment lies on, of the mesh as it was welded, healed or cut,
///         if it was; None along intersections
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
    if wanted.options().outline {
        return Err(bad_input("--outline: its rings are no chains; call outline"));
    }
    let (lines, topology) = find(py, mesh.get(), &camera, &wanted, progress)?;
    chains(py, &lines, &topology)
}

/// The outline of a view: the boundary of all that the mesh covers in the picture.
///
/// outline(mesh, camera=None, *, progress=None, **options)
///
/// options: as of visible_lines, those that change the mesh.
///
/// Returns a list of connected regions. Each is a list of rings, (n, 2) float64 arrays of pixels (origin at the top left, y down), closed
/// by their first points: the outer ring, counter-clockwise as seen, then its holes, clockwise.
#[pyfunction]
#[pyo3(signature = (mesh, camera = CameraArgument::DEFAULT, *, progress = None, **options))]
pub fn outline<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, Mesh>,
    camera: CameraArgument<'py>,
    progress: Option<&Bound<'py, PyAny>>,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<Vec<Vec<Bound<'py, PyArray2<f64>>>>> {
    let mut words = method::command_words(options)?;
    words.push("--outline=only".to_owned());
    let (lines, _) = find(py, mesh.get(), &camera, &wanted(&words)?, progress)?;
    let region = |rings: &[Vec<DVec2>]| rings.iter().map(|ring| pixels(py, ring)).collect();
    lines.outline.regions().map(region).collect()
}

/// Writes the lines of a view to a file: the one that the command `silhouettes lines` writes, byte for byte.
///
/// write_lines(mesh, path, camera=None, *, progress=None, **options)
///
/// mesh: a Mesh, or a list of them, which are drawn together and hide each other.
/// path: a name that ends in .svg, .pdf, .dxf, .hpgl or .plt; in .json, with pixels and points in space; or in .gltf or .glb. The file
///     appears whole or not at all.
/// options: all of the command `silhouettes lines`, with underscores for hyphens: those of visible_lines, and those of pages and pens,
///     for example page="a4", width="0.3mm", hidden=True, outline=True, fill="white", layers="object", views="front,top,right,iso".
#[pyfunction]
#[pyo3(signature = (mesh, path, camera = CameraArgument::DEFAULT, *, progress = None, **options))]
pub fn write_lines<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, PyAny>,
    path: PathBuf,
    camera: CameraArgument<'py>,
    progress: Option<&Bound<'py, PyAny>>,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<()> {
    let meshes: Vec<Py<Mesh>> = match mesh.cast::<Mesh>() {
        Ok(mesh) => vec![mesh.clone().unbind()],
        Err(_) => mesh.extract()?,
    };
    let mut words = method::command_words(options)?;
    words.extend_from_slice(camera.get()?.words());
    progress::run(py, progress, |progress| {
        let meshes = meshes.iter().map(|mesh| (mesh.get().name().to_owned(), mesh.get().labelled()));
        calls::write_lines(&words, meshes.collect(), &path, method::registry(), progress)
    })
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
    state: Mutex<State>,
}

struct State {
    finder: Finder,
    /// How long the last view took.
    took: Duration,
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
        if wanted.options().outline {
            return Err(bad_input("--outline: its rings are no chains; call outline"));
        }
        let given = mesh.get();
        let (finder, topology) = progress::run(py, progress, |progress| {
            let (scene, topology) = scene(given, &wanted, progress)?;
            let finder = Finder::for_many_views(scene, progress);
            let finder = finder.map_err(|error| Failure::of_preparation(given.name(), "visible-lines", error))?;
            Ok((finder, topology))
        })?;
        let state = Mutex::new(State { finder, took: Duration::ZERO });
        Ok(Self { mesh: mesh.clone().unbind(), wanted: wanted.options(), topology, state })
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
            let mut state = self.state();
            let started = Instant::now();
            let found = state.finder.find(&camera, &self.wanted, progress);
            state.took = started.elapsed();
            found.map_err(|error| calls::of_finding(mesh.name(), error))
        })?;
        chains(py, &lines, &self.topology)
    }

    /// Milliseconds that finding the lines of the last view took, without making arrays of them.
    #[getter]
    fn last_ms(&self) -> f64 {
        self.state().took.as_secs_f64() * 1e3
    }
}

impl LineFinder {
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The lines that words want.
fn wanted(words: &[String]) -> PyResult<WantedLines> {
    WantedLines::of_words(words, method::registry()).map_err(|failure| exception(&failure))
}

/// What the lines of a mesh are found in, and its edges.
fn scene(mesh: &Mesh, wanted: &WantedLines, progress: &dyn Progress) -> Result<(LineScene, Arc<Topology>), Failure> {
    let scene = if wanted.takes_mesh_as_it_is() {
        LineScene::new(Arc::clone(mesh.prepared()))
    } else {
        wanted.scene(mesh.name(), mesh.labelled(), progress)?
    };
    let topology = scene.mesh().artefact::<Topology>("lines", progress)?;
    Ok((scene, topology))
}

fn chains<'py>(py: Python<'py>, lines: &Lines, topology: &Topology) -> PyResult<Bound<'py, PyList>> {
    let chains = lines.chains.iter().map(|chain| chain_as_dict(py, &chain, lines.origin, topology));
    PyList::new(py, chains.collect::<PyResult<Vec<_>>>()?)
}

fn find<'py>(
    py: Python<'py>,
    mesh: &Mesh,
    camera: &CameraArgument<'py>,
    wanted: &WantedLines,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Lines, Arc<Topology>)> {
    let camera = camera.get()?.of(mesh, None).map_err(|failure| exception(&failure))?;
    progress::run(py, progress, |progress| {
        let (scene, topology) = scene(mesh, wanted, progress)?;
        let mut finder = Finder::new(scene, progress)?;
        let lines = finder.find(&camera, &wanted.options(), progress);
        Ok((lines.map_err(|error| calls::of_finding(mesh.name(), error))?, topology))
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
