//! `Mesh`: vertices and faces, with what is derived from them when it is first asked for.

use crate::arrays::{Coordinates, coordinates, triangles};
use crate::errors::bad_input;
use crate::mesh_memory;
use crate::progress;
use crate::records::to_python;
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use silhouette_compare::runner::NamedMesh;
use silhouette_core::inspect::inspect;
use silhouette_core::{PreparedMesh, Topology, TriangleMesh};
use silhouettes::application::{self, Failure, MeshArgument};
use std::path::PathBuf;
use std::sync::Arc;

/// A triangle mesh.
///
/// Mesh(vertices, faces, name="mesh")
///
/// vertices: (V, 3) array of coordinates in any unit. float32 is taken as it is, everything else read as float64 and rounded once; a mesh
///     far from zero then counts from its `origin`.
/// faces: (F, 3) array of vertex indices from 0, counter-clockwise seen from outside. uint32 is copied as it is, other integers are
///     converted.
/// name: what errors and results call it.
///
/// The mesh holds one copy of both, 12 bytes for each vertex and each face, and its `vertices` and `faces` are that copy: let go of
/// arrays of your own to hold only one. Making it takes no further memory where they are C-contiguous, vertices of float32 or float64
/// and faces of uint32, int32 or int64. A file that is loaded has no other copy.
/// It does not change: what is derived from it (topology, search trees) is built when it is first needed, and kept.
#[pyclass(frozen, module = "silhouettes")]
pub struct Mesh {
    named: NamedMesh,
    notes: Vec<String>,
}

impl Mesh {
    /// The mesh by its name.
    pub fn named(&self) -> &NamedMesh {
        &self.named
    }

    /// The mesh with what is derived from it.
    pub fn prepared(&self) -> &Arc<PreparedMesh> {
        &self.named.mesh
    }

    /// The mesh itself.
    pub fn triangle_mesh(&self) -> &Arc<TriangleMesh> {
        self.named.mesh.mesh()
    }
}

impl From<NamedMesh> for Mesh {
    fn from(named: NamedMesh) -> Self {
        Self { named, notes: Vec::new() }
    }
}

#[pymethods]
impl Mesh {
    #[new]
    #[pyo3(signature = (vertices, faces, name = "mesh".to_owned()))]
    fn new(py: Python<'_>, vertices: &Bound<'_, PyAny>, faces: &Bound<'_, PyAny>, name: String) -> PyResult<Self> {
        let (coordinates, triangles) = (coordinates(vertices)?, triangles(faces)?);
        let mesh = match coordinates {
            Coordinates::Narrow(positions) => py.detach(|| TriangleMesh::new(positions, triangles)),
            // Read where they lie, so that no other thread of Python may run meanwhile: some milliseconds for a million.
            Coordinates::Wide(coordinates) => {
                TriangleMesh::from_wide(bytemuck::cast_slice(coordinates.as_slice()?), triangles)
            }
        };
        let mesh = mesh.map_err(|error| bad_input(format_args!("{name}: {error}")))?;
        Ok(NamedMesh { name, mesh: Arc::new(PreparedMesh::new(mesh)) }.into())
    }

    /// What errors and results call it: the file's name for one that was loaded.
    #[getter]
    pub fn name(&self) -> &str {
        &self.named.name
    }

    /// (V, 3) float32, read-only: the positions, which count from `origin`. Not a copy but the mesh's own memory, which lives as long
    /// as the array does.
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f32>>> {
        mesh_memory::positions(py, self.triangle_mesh())
    }

    /// (F, 3) uint32, read-only: the vertex indices of each face. Not a copy either.
    #[getter]
    fn faces<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        mesh_memory::triangles(py, self.triangle_mesh())
    }

    /// (3,) float64: the point from which positions count. Zero unless the mesh lies far from there.
    #[getter]
    fn origin<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.triangle_mesh().origin().to_array())
    }

    /// What its file's reader has to say, one sentence each.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.notes.clone()
    }

    /// Counts, genus, boundary loops and every defect with its ids, as `silhouettes inspect --json` says them.
    ///
    /// Returns a dict.
    #[pyo3(signature = (*, progress = None))]
    fn inspect<'py>(&self, py: Python<'py>, progress: Option<&Bound<'py, PyAny>>) -> PyResult<Bound<'py, PyAny>> {
        let inspection = progress::run(py, progress, |progress| {
            let topology = self.prepared().artefact::<Topology>("inspect", progress)?;
            Ok(inspect(self.triangle_mesh(), &topology))
        })?;
        to_python(py, &inspection)
    }

    fn __repr__(&self) -> String {
        let mesh = self.triangle_mesh();
        format!("<silhouettes.Mesh {}: {} vertices, {} faces>", self.named.name, mesh.vertex_count(), mesh.face_count())
    }
}

/// Loads a mesh.
///
/// load(path, *, progress=None)
///
/// path: a file (.obj .ply .off .stl .gltf .glb), or "builtin:NAME", for example "builtin:torus" or "builtin:blob:100000".
/// progress: called now and then as progress(stage, done, total); what it raises cancels the work.
///
/// Returns a Mesh in the coordinates of the file. What the reader noted is in its `notes`.
/// Raises silhouettes.Error where there is no such file or it cannot be read.
#[pyfunction]
#[pyo3(signature = (path, *, progress = None))]
pub fn load(py: Python<'_>, path: PathBuf, progress: Option<&Bound<'_, PyAny>>) -> PyResult<Mesh> {
    let argument = MeshArgument::from(path.into_os_string());
    progress::run(py, progress, move |progress| {
        if argument == MeshArgument::StandardInput {
            return Err(Failure::Input("-: standard input is for the command line; name a file".into()));
        }
        let (named, notes) = application::load(&argument, progress)?;
        Ok(Mesh { named, notes: notes.iter().map(ToString::to_string).collect() })
    })
}
