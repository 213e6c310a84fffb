//! [`Subject`]: a mesh to compare on.

use silhouette_core::{PreparedMesh, TriangleMesh};
use std::sync::Arc;

/// A mesh with its name.
#[derive(Debug, Clone)]
pub struct NamedMesh {
    /// Name in results and report, usually the path.
    pub name: String,
    /// The mesh.
    pub mesh: Arc<PreparedMesh>,
}

/// A mesh to compare on, and what it stands for.
#[derive(Debug, Clone)]
pub struct Subject {
    /// What is drawn.
    pub mesh: NamedMesh,
    /// What filled pictures are measured against, in the same coordinates; `None`: the mesh itself.
    pub truth: Option<Arc<TriangleMesh>>,
}

impl Subject {
    /// A mesh drawn with at most `faces` faces, by `silhouette_core::simplify`, and measured against all of it. Its name
    /// says so, and feature edges are lost.
    ///
    /// # Errors
    /// [`SimplifyFault`]: there is no such mesh, or this package is built without the feature `simplify`.
    pub fn simplified(full: &NamedMesh, faces: usize) -> Result<Self, SimplifyFault> {
        let truth = Arc::clone(full.mesh.mesh());
        let mesh = Arc::new(PreparedMesh::new(simplify(&truth, faces)?));
        let name = format!("{} simplified to {faces}", full.name);
        Ok(Self { mesh: NamedMesh { name, mesh }, truth: Some(truth) })
    }
}

/// Why a mesh is not drawn simplified.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SimplifyFault {
    /// This package is built without the feature `simplify`.
    #[error(
        "this build does not simplify meshes; build it with the cargo feature `simplify`, which needs a C++ compiler"
    )]
    FeatureOff,
    /// There is no mesh of so few faces.
    #[cfg(feature = "simplify")]
    #[error(transparent)]
    Simplify(#[from] silhouette_core::simplify::SimplifyError),
}

#[cfg(feature = "simplify")]
fn simplify(mesh: &TriangleMesh, faces: usize) -> Result<TriangleMesh, SimplifyFault> {
    Ok(silhouette_core::simplify::simplify(mesh, faces)?)
}

#[cfg(not(feature = "simplify"))]
fn simplify(_mesh: &TriangleMesh, _faces: usize) -> Result<TriangleMesh, SimplifyFault> {
    Err(SimplifyFault::FeatureOff)
}

impl From<NamedMesh> for Subject {
    fn from(mesh: NamedMesh) -> Self {
        Self { mesh, truth: None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::shapes;

    #[test]
    fn a_simplified_mesh_is_measured_against_all_of_it() {
        let full = Arc::new(PreparedMesh::new(shapes::by_name("blob:2000").unwrap()));
        let named = NamedMesh { name: "blob".to_owned(), mesh: Arc::clone(&full) };
        let subject = Subject::simplified(&named, 500);
        if cfg!(feature = "simplify") {
            let subject = subject.unwrap();
            assert_eq!(subject.mesh.name, "blob simplified to 500");
            assert!(subject.mesh.mesh.mesh().face_count() <= 500);
            assert!(Arc::ptr_eq(subject.truth.as_ref().unwrap(), full.mesh()));
            assert!(Subject::simplified(&named, 1).is_err());
        } else {
            assert!(matches!(subject, Err(SimplifyFault::FeatureOff)));
        }
    }
}
