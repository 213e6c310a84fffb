//! How the measurement for a paper fails.

use silhouette_compare::drawing::DrawError;
use silhouette_compare::registry::UnknownMethod;
use silhouette_compare::truth::TruthError;
use silhouette_compare::truth::fill::FillTruthError;
use silhouette_core::Cancelled;
use silhouette_core::method::{OptionError, PrepareError};
use silhouette_core::shapes::ShapeError;
use silhouette_core::view::ViewError;
use std::fmt;

/// What went wrong.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Cause {
    /// No mesh was given.
    #[error("there is no mesh to measure")]
    NoMesh,
    /// The mesh has no triangle.
    #[error("the mesh has no triangle, so it has no silhouette")]
    EmptyMesh,
    /// The paper draws, and the run has no device.
    #[error("the paper's pictures need a graphics adapter, and this run has none")]
    NoGpu,
    /// A method could not be prepared, or the run was cancelled.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// A picture could not be drawn.
    #[error(transparent)]
    Draw(#[from] DrawError),
    /// The true lines could not be found.
    #[error(transparent)]
    Truth(#[from] TruthError),
    /// The true filled picture could not be drawn.
    #[error(transparent)]
    FillTruth(#[from] FillTruthError),
    /// A camera could not be made.
    #[error(transparent)]
    View(#[from] ViewError),
    /// A built-in shape could not be made.
    #[error(transparent)]
    Shape(#[from] ShapeError),
    /// The registry lacks a method that the paper is measured beside.
    #[error(transparent)]
    Method(#[from] UnknownMethod),
    /// No thread could be started.
    #[error(transparent)]
    Threads(#[from] rayon::ThreadPoolBuildError),
}

impl From<Cancelled> for Cause {
    fn from(cancelled: Cancelled) -> Self {
        Self::Prepare(cancelled.into())
    }
}

impl From<OptionError> for Cause {
    fn from(error: OptionError) -> Self {
        Self::Prepare(error.into())
    }
}

/// A [`Cause`], with the mesh that was being measured.
#[derive(Debug)]
pub struct PaperError {
    /// Name of the mesh; `None` where the failure concerns no particular one.
    pub mesh: Option<String>,
    /// What went wrong.
    pub cause: Cause,
}

impl PaperError {
    /// For `map_err`: names the mesh.
    pub fn of<C: Into<Cause>>(mesh: &str) -> impl Fn(C) -> Self + Copy + '_ {
        move |cause| Self { mesh: Some(mesh.to_owned()), cause: cause.into() }
    }

    /// Whether the mesh is at fault, not the run.
    pub fn is_of_input(&self) -> bool {
        matches!(
            &self.cause,
            Cause::NoMesh
                | Cause::EmptyMesh
                | Cause::View(_)
                | Cause::Prepare(PrepareError::Mesh(_))
                | Cause::Draw(DrawError::Prepare(PrepareError::Mesh(_)))
        )
    }
}

impl<C: Into<Cause>> From<C> for PaperError {
    fn from(cause: C) -> Self {
        Self { mesh: None, cause: cause.into() }
    }
}

impl fmt::Display for PaperError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.mesh {
            Some(mesh) => write!(f, "{mesh}: {}", self.cause),
            None => self.cause.fmt(f),
        }
    }
}

impl std::error::Error for PaperError {}
