//! Why a comparison failed.

use crate::drawing::DrawError;
use crate::truth::TruthError;
use crate::truth::fill::FillTruthError;
use silhouette_core::Cancelled;
use silhouette_core::method::PrepareError;
use silhouette_core::view::ViewError;
use silhouette_visibility::LineError;

/// Why a comparison failed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CompareError {
    /// There is nothing to compare on.
    #[error("there is no mesh to compare")]
    NoMesh,
    /// Two meshes have the same name, so their results could not be distinguished.
    #[error("two meshes are named '{name}'")]
    SameName {
        /// The name.
        name: String,
    },
    /// A mesh has no triangle.
    #[error("{mesh}: the mesh has no triangle, so there is nothing to see")]
    EmptyMesh {
        /// Its name.
        mesh: String,
    },
    /// The views cannot be set up.
    #[error("{mesh}: {cause}")]
    View {
        /// The mesh.
        mesh: String,
        /// What is wrong.
        cause: ViewError,
    },
    /// The truth could not be found.
    #[error("{mesh}: {cause}")]
    Truth {
        /// The mesh.
        mesh: String,
        /// What went wrong.
        cause: TruthError,
    },
    /// The truth of filled pictures could not be drawn.
    #[error("{mesh}: {cause}")]
    FillTruth {
        /// The mesh.
        mesh: String,
        /// What went wrong.
        cause: FillTruthError,
    },
    /// A method could not be prepared or drawn.
    #[error("{mesh}, {method}: {cause}")]
    Draw {
        /// The mesh.
        mesh: String,
        /// The method.
        method: String,
        /// What went wrong.
        cause: DrawError,
    },
    /// Stopped by the progress.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl CompareError {
    /// Names the mesh; a cancellation stays one, however deep it happened.
    pub(crate) fn truth(mesh: &str, cause: TruthError) -> Self {
        match cause {
            TruthError::Prepare(PrepareError::Cancelled(cancelled))
            | TruthError::Lines(LineError::Cancelled(cancelled)) => Self::Cancelled(cancelled),
            cause => Self::Truth { mesh: mesh.to_owned(), cause },
        }
    }

    /// Names mesh and method; a cancellation stays one, however deep it happened.
    pub(super) fn draw(mesh: &str, method: &str, cause: DrawError) -> Self {
        match cause {
            DrawError::Prepare(PrepareError::Cancelled(cancelled)) => Self::Cancelled(cancelled),
            cause => Self::Draw { mesh: mesh.to_owned(), method: method.to_owned(), cause },
        }
    }
}
