//! [`LineScene`]: the meshes, labels and curves that are drawn together.

use crate::kind::LineKind;
use silhouette_core::glam::{BVec3, DVec3, Vec3};
use silhouette_core::mesh::MeshError;
use silhouette_core::{FaceId, PreparedMesh, TriangleMesh, VertexId};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::{Arc, OnceLock};

/// A smooth curve as cubic Bezier pieces in object space, to be drawn where it is visible.
///
/// A curve that smooths a silhouette runs a little above or below the faces around it, which would hide parts of it; it is
/// drawn as if those faces were not there.
#[derive(Debug, Clone, PartialEq)]
pub struct CurvePiece {
    /// Control points; the first and the last are on the curve.
    pub control: [Vec3; 4],
    /// Faces that do not hide this piece.
    pub on_faces: Vec<FaceId>,
    /// Why it is drawn, which its layer and pen depend on: [`LineKind::Curve`] where it stands for no other line.
    pub kind: LineKind,
    /// The object it belongs to.
    pub object: u32,
}

/// Why a scene cannot be made.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// Together the meshes are too large for 32-bit ids.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// There must be a label, an object or a mask for each face.
    #[error("{given} {what} for {faces} faces; give one for each face")]
    PerFace {
        /// What is given: labels, objects or masks.
        what: &'static str,
        /// How many of them.
        given: usize,
        /// How many faces there are.
        faces: usize,
    },
    /// An edge of a section between vertices that do not exist.
    #[error("section edge {edge} names a vertex that does not exist")]
    Section {
        /// Its index.
        edge: usize,
    },
    /// A control point that is not finite, or a face or object that does not exist.
    #[error(
        "curve piece {piece} has a control point that is not finite, or names a face or object that does not exist"
    )]
    Curve {
        /// Its index.
        piece: usize,
    },
}

/// What is drawn together: one or several meshes, which hide each other.
#[derive(Clone)]
pub struct LineScene {
    mesh: Arc<PreparedMesh>,
    /// First face of each object, ascending; 0 comes first.
    object_starts: Vec<u32>,
    labels: Option<Vec<u32>>,
    section_edges: Vec<[VertexId; 2]>,
    /// The object of each face, where objects are no meshes.
    objects: Option<Vec<u32>>,
    /// Which faces are masks, where there are some.
    masks: Option<Vec<bool>>,
    curves: Vec<CurvePiece>,
    fingerprint: OnceLock<u128>,
}

/// Least and largest coordinates of a mesh; 0 without faces.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Extent {
    pub(crate) min: DVec3,
    pub(crate) max: DVec3,
}

impl Extent {
    /// Largest absolute coordinate.
    pub(crate) fn reach(&self) -> f64 {
        self.min.abs().max(self.max.abs()).max_element()
    }

    /// The middle, towards which viewers are displaced.
    pub(crate) fn center(&self) -> Vec3 {
        ((self.min + self.max) * 0.5).as_vec3()
    }

    /// The corners of the box.
    pub(crate) fn corners(&self) -> impl Iterator<Item = DVec3> {
        let Self { min, max } = *self;
        (0..8).map(move |index| DVec3::select(BVec3::new(index & 1 == 1, index & 2 == 2, index & 4 == 4), max, min))
    }
}

impl LineScene {
    /// One mesh, object 0.
    pub fn new(mesh: Arc<PreparedMesh>) -> Self {
        Self::with_starts(mesh, vec![0])
    }

    fn with_starts(mesh: Arc<PreparedMesh>, object_starts: Vec<u32>) -> Self {
        Self {
            mesh,
            object_starts,
            labels: None,
            objects: None,
            masks: None,
            section_edges: Vec::new(),
            curves: Vec::new(),
            fingerprint: OnceLock::new(),
        }
    }

    /// Several meshes in one space, each an object of its own. Ids of edges and faces are those of the meshes set one after
    /// another. Meshes that count from different [origins](TriangleMesh::origin) are placed right relative to each other, and
    /// count from a [common one](silhouette_core::origin::common_origin), which that of the scene's mesh then is: cameras must do so, too. O(V + F).
    ///
    /// # Errors
    /// [`SceneError::Mesh`] if together they are too large.
    pub fn of_meshes(meshes: &[&TriangleMesh]) -> Result<Self, SceneError> {
        let mesh = Arc::new(PreparedMesh::new(TriangleMesh::of_parts(meshes)?));
        let counts = meshes.iter().map(|mesh| mesh.face_count() as u32);
        let starts = counts.scan(0, |next, count| Some(std::mem::replace(next, *next + count)));
        let mut object_starts: Vec<u32> = starts.collect();
        if object_starts.is_empty() {
            object_starts.push(0);
        }
        Ok(Self::with_starts(mesh, object_starts))
    }

    /// The same scene with a label for each face, such as its material: lines are drawn between faces of different labels.
    ///
    /// # Errors
    /// [`SceneError::PerFace`].
    pub fn with_labels(mut self, labels: Vec<u32>) -> Result<Self, SceneError> {
        self.check_per_face("labels", labels.len())?;
        self.labels = Some(labels);
        self.fingerprint = OnceLock::new();
        Ok(self)
    }

    /// The same scene with the edges along which sections cut it, by their end points; those that are no edges of the mesh are
    /// passed over. See [`SectionedMesh`](crate::SectionedMesh).
    ///
    /// # Errors
    /// [`SceneError::Section`] names the first at fault.
    pub fn with_section_edges(mut self, edges: Vec<[VertexId; 2]>) -> Result<Self, SceneError> {
        let vertices = self.mesh.mesh().vertex_count();
        if let Some(edge) = edges.iter().position(|ends| ends.iter().any(|vertex| vertex.index() >= vertices)) {
            return Err(SceneError::Section { edge });
        }
        self.section_edges = edges;
        self.fingerprint = OnceLock::new();
        Ok(self)
    }

    /// The edges along which sections cut it.
    pub fn section_edges(&self) -> &[[VertexId; 2]] {
        &self.section_edges
    }

    /// The same scene with the object of each face, such as a part of a mesh. An edge between faces of two objects belongs to that
    /// of its first face.
    ///
    /// # Errors
    /// [`SceneError::PerFace`].
    pub fn with_objects(mut self, objects: Vec<u32>) -> Result<Self, SceneError> {
        self.check_per_face("objects", objects.len())?;
        self.objects = Some(objects);
        self.fingerprint = OnceLock::new();
        Ok(self)
    }

    /// The same scene with a mask: faces that hide what is behind them without being drawn. Edges and lines of intersection of which
    /// all faces are masked are not drawn; curves are, and so is the [outline](crate::LineFinder::outline).
    ///
    /// # Errors
    /// [`SceneError::PerFace`].
    pub fn with_masks(mut self, is_mask: Vec<bool>) -> Result<Self, SceneError> {
        self.check_per_face("masks", is_mask.len())?;
        self.masks = Some(is_mask);
        self.fingerprint = OnceLock::new();
        Ok(self)
    }

    fn check_per_face(&self, what: &'static str, given: usize) -> Result<(), SceneError> {
        let faces = self.mesh.mesh().face_count();
        if given == faces { Ok(()) } else { Err(SceneError::PerFace { what, given, faces }) }
    }

    /// The same scene with smooth curves.
    ///
    /// # Errors
    /// [`SceneError::Curve`] names the first piece at fault.
    pub fn with_curves(mut self, curves: Vec<CurvePiece>) -> Result<Self, SceneError> {
        let (faces, objects) = (self.mesh.mesh().face_count(), self.object_count());
        let is_valid = |piece: &CurvePiece| {
            piece.control.iter().all(|point| point.is_finite())
                && piece.on_faces.iter().all(|face| face.index() < faces)
                && (piece.object as usize) < objects
        };
        if let Some(piece) = curves.iter().position(|piece| !is_valid(piece)) {
            return Err(SceneError::Curve { piece });
        }
        self.curves = curves;
        self.fingerprint = OnceLock::new();
        Ok(self)
    }

    /// All meshes as one, with the artefacts derived from it.
    pub fn mesh(&self) -> &Arc<PreparedMesh> {
        &self.mesh
    }

    /// What the mesh spans. O(F).
    pub(crate) fn extent(&self) -> Extent {
        self.mesh.mesh().bounds().map_or(Extent::default(), |bounds| Extent { min: bounds.min, max: bounds.max })
    }

    /// Number of objects, at least 1.
    pub fn object_count(&self) -> usize {
        let most = |objects: &Vec<u32>| objects.iter().max().map_or(1, |&last| last as usize + 1);
        self.objects.as_ref().map_or(self.object_starts.len(), most)
    }

    /// The object that a face belongs to. O(log objects).
    pub fn object_of(&self, face: FaceId) -> u32 {
        if let Some(objects) = &self.objects {
            return objects[face.index()];
        }
        (self.object_starts.partition_point(|&start| start <= face.get()) - 1) as u32
    }

    /// Whether a line on these faces is drawn: unless all of them are masks.
    pub(crate) fn is_drawn(&self, faces: impl IntoIterator<Item = FaceId>) -> bool {
        self.masks.as_ref().is_none_or(|is_mask| faces.into_iter().any(|face| !is_mask[face.index()]))
    }

    /// The label of each face.
    pub fn labels(&self) -> Option<&[u32]> {
        self.labels.as_deref()
    }

    /// A hash of all that decides the lines of this scene: two scenes with one fingerprint have the same lines. O(V + F) the
    /// first time.
    pub fn fingerprint(&self) -> u128 {
        *self.fingerprint.get_or_init(|| {
            let [low, high] = [0_u8, 1].map(|half| u128::from(self.hash_of(half)));
            high << 64 | low
        })
    }

    fn hash_of(&self, half: u8) -> u64 {
        let mut hasher = DefaultHasher::new();
        half.hash(&mut hasher);
        let mesh = self.mesh.mesh();
        let bits = |point: &Vec3| point.to_array().map(f32::to_bits);
        mesh.vertex_count().hash(&mut hasher);
        mesh.positions().iter().for_each(|position| bits(position).hash(&mut hasher));
        mesh.triangles().hash(&mut hasher);
        self.object_starts.hash(&mut hasher);
        (&self.labels, &self.objects, &self.masks).hash(&mut hasher);
        self.section_edges.hash(&mut hasher);
        for curve in &self.curves {
            curve.control.iter().for_each(|position| bits(position).hash(&mut hasher));
            (&curve.on_faces, curve.kind, curve.object).hash(&mut hasher);
        }
        hasher.finish()
    }

    /// The smooth curves.
    pub fn curves(&self) -> &[CurvePiece] {
        &self.curves
    }
}

impl std::fmt::Debug for LineScene {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("LineScene")
            .field("faces", &self.mesh.mesh().face_count())
            .field("objects", &self.object_count())
            .field("labelled", &self.labels.is_some())
            .field("curves", &self.curves.len())
            .finish_non_exhaustive()
    }
}
