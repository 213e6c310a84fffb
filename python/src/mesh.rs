//! `Mesh`: vertices and faces, with what is derived from them when it is first asked for.

use crate::arrays::{Coordinates, coordinates, triangles};
use crate::errors::bad_input;
use crate::mesh_memory;
use crate::method;
use crate::progress;
use crate::records::to_python;
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use silhouette_compare::runner::NamedMesh;
use silhouette_core::inspect::inspect;
use silhouette_core::load::{LabelledMesh, Parts};
use silhouette_core::mesh::Bounds;
use silhouette_core::{PreparedMesh, Topology, TriangleMesh, VertexId};
use silhouettes::application::{self, Failure, MeshArgument};
use silhouettes::calls;
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

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
    /// For each face which others are of the same material and group, where the file says.
    labels: Option<Vec<u32>>,
    /// What the file calls its parts.
    parts: Option<Parts>,
    /// Asked for by every camera that looks at the mesh.
    bounds: OnceLock<Option<Bounds>>,
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

    /// What its faces span; `None` where there is none. O(F) when first asked for.
    pub fn bounds(&self) -> Option<Bounds> {
        *self.bounds.get_or_init(|| self.triangle_mesh().bounds())
    }

    fn of_labelled(name: String, mut mesh: LabelledMesh, notes: Vec<String>) -> Self {
        let (labels, parts) = (mesh.labels.take(), mesh.parts.take());
        Self { named: calls::prepared(name, mesh), notes, labels, parts, bounds: OnceLock::new() }
    }

    /// A copy of the mesh as its file's reader yields it, but for what it noted.
    pub fn labelled(&self) -> LabelledMesh {
        let feature_edges = self.prepared().feature_edges().iter().map(|edge| edge.map(VertexId::get)).collect();
        LabelledMesh {
            mesh: self.triangle_mesh().as_ref().clone(),
            labels: self.labels.clone(),
            parts: self.parts.clone(),
            feature_edges,
            notes: Vec::new(),
        }
    }

    /// Another mesh, which words of the command `lines` make of this one.
    fn changed(&self, py: Python<'_>, words: &[String], progress: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        progress::run(py, progress, |progress| {
            let change = || calls::changed_mesh(words, self.name(), self.labelled(), method::registry(), progress);
            let (mesh, notes) = calls::with_notes(change);
            Ok(Self::of_labelled(self.name().to_owned(), mesh?, notes))
        })
    }

    /// The mesh itself.
    pub fn triangle_mesh(&self) -> &Arc<TriangleMesh> {
        self.named.mesh.mesh()
    }
}

impl From<NamedMesh> for Mesh {
    fn from(named: NamedMesh) -> Self {
        Self { named, notes: Vec::new(), labels: None, parts: None, bounds: OnceLock::new() }
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

    /// What its file's reader, or the method that made it, has to say, one sentence each.
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

    /// Names of its parts, in the order of the file: objects and groups of an OBJ file, nodes of a glTF file.
    #[getter]
    fn parts(&self) -> Vec<String> {
        let mut names = Vec::new();
        for name in self.parts.iter().flat_map(Parts::as_slice).flat_map(|part| part.names.iter()) {
            if !names.contains(name) {
                names.push(name.clone());
            }
        }
        names
    }

    /// Some of its parts as a Mesh: those named by `only`, or all, but for those named by `without`.
    ///
    /// Vertices keep their numbers. An object or a node stands for all that belongs to it.
    #[pyo3(signature = (*, only = Vec::new(), without = Vec::new()))]
    fn select(&self, py: Python<'_>, only: Vec<String>, without: Vec<String>) -> PyResult<Self> {
        let words = only.iter().map(|name| format!("--only={name}"));
        let words: Vec<_> = words.chain(without.iter().map(|name| format!("--without={name}"))).collect();
        self.changed(py, &words, None)
    }

    /// A Mesh in which vertices no farther apart than `distance`, in units of the mesh, are one: seams are no boundaries then.
    #[pyo3(signature = (distance = 0.0, *, progress = None))]
    fn weld(&self, py: Python<'_>, distance: f64, progress: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        self.changed(py, &[format!("--weld={distance:?}")], progress)
    }

    /// A Mesh whose edges are divided at vertices that lie on them, no farther than `distance` in units of the mesh: T-junctions are no
    /// boundaries then. Joins vertices as weld does. Without a distance it is a millionth of the mesh's largest extent.
    #[pyo3(signature = (distance = None, *, progress = None))]
    fn heal(&self, py: Python<'_>, distance: Option<f64>, progress: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let word = distance.map_or("--heal".to_owned(), |distance| format!("--heal={distance:?}"));
        self.changed(py, &[word], progress)
    }

    /// A Mesh whose parts that were wound inside out are turned, so that faces point outwards: exact for closed parts, a guess for open
    /// ones. Its `notes` say how many faces were turned.
    #[pyo3(signature = (*, progress = None))]
    fn orient(&self, py: Python<'_>, progress: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        self.changed(py, &["--orient".to_owned()], progress)
    }

    /// The Mesh cut open by the plane through `point`: what lies on the side to which `normal` points is taken away. Both are three
    /// numbers, in the coordinates of the mesh's file. To draw the curves of the cut give visible_lines or write_lines a section.
    #[pyo3(signature = (point, normal, *, progress = None))]
    fn cut(
        &self,
        py: Python<'_>,
        point: [f64; 3],
        normal: [f64; 3],
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let numbers: Vec<_> = point.iter().chain(&normal).map(|number| format!("{number:?}")).collect();
        self.changed(py, &[format!("--section={}", numbers.join(","))], progress)
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
        let (name, mesh) = application::load_labelled(&argument, progress)?;
        let notes = mesh.notes.iter().map(ToString::to_string).collect();
        Ok(Mesh::of_labelled(name, mesh, notes))
    })
}
