//! [`Tessellation`]: every face of a mesh as a curved patch, split evenly, whatever the view. What PN triangles and Phong
//! tessellation have in common.

use crate::eye::SmoothingView;
use crate::face_splitter::{FaceSplitter, Patch, Splitting};
use crate::hermite::Hermite;
use crate::shading_mesh::ShadingMesh;
use crate::shading_normals::NormalWeights;
use crate::side_curves::side_curves;
use crate::view_mesh::{Remesher, ViewMesh};
use silhouette_core::id::PerEdge;
use silhouette_core::method::PrepareError;
use silhouette_core::{FaceId, PreparedMesh, Progress};
use std::sync::Arc;

/// A split mesh would have more triangles than 32-bit half-edge numbers can name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("{faces} faces of {per_face} triangles each are too many; choose a lower level")]
pub struct TooManyTriangles {
    /// Faces of the mesh.
    pub faces: usize,
    /// Triangles that each would be split into.
    pub per_face: u32,
}

/// Whether a mesh can be split.
///
/// # Errors
/// [`PrepareError::Mesh`] with [`TooManyTriangles`].
pub(crate) fn check_size(faces: usize, segments: u32) -> Result<(), PrepareError> {
    let per_face = segments * segments;
    if faces as u64 * u64::from(3 * per_face) < u64::from(u32::MAX) {
        Ok(())
    } else {
        Err(PrepareError::Mesh(Box::new(TooManyTriangles { faces, per_face })))
    }
}

/// A mesh with a patch over each face.
#[derive(Debug, Clone)]
pub struct Tessellation<P> {
    mesh: Arc<ShadingMesh>,
    curves: Arc<PerEdge<Hermite>>,
    patch: P,
    segments: u32,
    splitter: FaceSplitter,
    /// Vertices that were made last.
    made: Option<usize>,
}

impl<P: Patch> Tessellation<P> {
    /// Prepares a mesh, each side of which gets `level` more vertices: (level + 1)² triangles per face. O(F).
    ///
    /// # Errors
    /// [`PrepareError::Cancelled`]; [`PrepareError::Mesh`] with [`TooManyTriangles`].
    pub(crate) fn new(
        mesh: &PreparedMesh,
        patch: P,
        level: u32,
        crease_deg: f64,
        weights: NormalWeights,
        asker: &'static str,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        let segments = level + 1;
        check_size(mesh.mesh().face_count(), segments)?;
        let mesh = ShadingMesh::new(mesh, crease_deg, weights, asker, progress)?;
        progress.check()?;
        let curves = Arc::new(side_curves(&mesh));
        progress.check()?;
        Ok(Self { mesh: Arc::new(mesh), curves, patch, segments, splitter: FaceSplitter::default(), made: None })
    }

    /// Bytes held beside the mesh and its topology.
    pub fn bytes(&self) -> usize {
        self.mesh.bytes() + size_of_val(self.curves.as_slice()) + self.splitter.bytes()
    }

    /// The mesh that is tessellated.
    pub fn mesh(&self) -> &ShadingMesh {
        &self.mesh
    }
}

/// Nothing is made anew as long as `out` holds what was made before. O(F (level + 1)²) the first time.
impl<P: Patch> Remesher for Tessellation<P> {
    fn remesh(&mut self, _view: &SmoothingView, out: &mut ViewMesh) -> bool {
        if self.made == Some(out.positions.len()) {
            return false;
        }
        let Self { mesh, curves, patch, segments, splitter, made } = self;
        let from = Splitting { mesh, curves, patch, segments: *segments };
        splitter.begin(mesh, out);
        for face in (0..mesh.triangles().len()).map(FaceId::from_usize) {
            splitter.push_split(&from, face, out);
        }
        *made = Some(out.positions.len());
        true
    }
}
