//! [`Hull`]: the coarse mesh around the object, which is drawn in its place.
//!
//! 1. [`offset_surface`]: the surface at a distance from the object.
//! 2. `coarsen.rs`: its simplification to some times the wanted vertices (cargo feature `simplify`), and `collapse.rs`: the last
//!    collapses, each checked against the object and the hull itself. The paper simplifies without checks.
//! 3. [`enclosure`]: the proof that the result encloses the object.
//! 4. `smallest.rs`: the smallest offset for which the proof succeeds.
//!
//! One hull serves the whole object, open or closed, of one or several components: parts closer than twice the offset share a
//! component of the hull, others have one each. An open surface is enclosed from both sides, or as if it were closed where its
//! holes are narrow: `caps.rs`.

#[cfg(feature = "simplify")]
mod box_grid;
#[cfg(feature = "simplify")]
mod caps;
#[cfg(feature = "simplify")]
mod coarsen;
#[cfg(feature = "simplify")]
mod collapse;
pub mod enclosure;
mod lattice;
mod layered;
pub mod offset_surface;
mod outside;
#[cfg(feature = "simplify")]
mod quadric;
mod self_contact;
#[cfg(feature = "simplify")]
mod smallest;
#[cfg(all(test, feature = "simplify"))]
mod tests;
mod touching;
pub(crate) mod winding_number;

use crate::hull::enclosure::{Enclosed, Enclosure, Offence};
use silhouette_core::{Cancelled, NoProgress, Progress, TriangleMesh};
use std::sync::Arc;

#[cfg(feature = "simplify")]
pub use smallest::{HullOptions, LEAST_OFFSET, MOST_FACES, MOST_OFFSET, PRECISION};

/// A coarse mesh around the object, wound counter-clockwise seen from outside.
#[derive(Debug, Clone)]
pub struct Hull {
    mesh: Arc<TriangleMesh>,
    offset: Option<f64>,
    enclosure: Option<Enclosure>,
}

/// Why there is no hull.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum HullError {
    /// The object has no faces, or all its vertices are in one place.
    #[error("the object has no extent: it has no faces, or all their corners are in one place")]
    NoExtent,
    /// 32-bit positions around the object are farther apart than the smallest offset, so that no surface close to it can be written
    /// down, and the search for one was still running after eight minutes.
    #[error(
        "the object lies so far from zero that 32-bit positions near it are up to {step:.1e} apart, more than a thousandth of its radius of {radius:.1e}; have them count from an origin close to it"
    )]
    TooFar {
        /// Most that neighbouring positions are apart.
        step: f64,
        /// Radius of the bounding sphere.
        radius: f64,
    },
    /// The smallest 32-bit numbers are farther apart than the smallest offset.
    #[error(
        "the object is so small, with a radius of {radius:.1e}, that 32-bit floats hold no surface close to it; scale it by a million or more"
    )]
    TooSmall {
        /// Radius of the bounding sphere.
        radius: f64,
    },
    /// A hull, or distances from it to the object, would be beyond 32-bit floats.
    #[error(
        "the object reaches so far, with a radius of {radius:.1e}, that distances around it are beyond 32-bit floats; scale it by a \
         thousandth or less"
    )]
    TooLarge {
        /// Radius of the bounding sphere.
        radius: f64,
    },
    /// Too few vertices were asked for.
    #[error("a hull of {0} vertices was asked for; ask for 4 or more")]
    TooFewVertices(usize),
    /// No offset gives a hull of so few vertices.
    #[error("no hull of {vertices} vertices was found to enclose the object ({failure}); ask for more vertices")]
    OutOfReach {
        /// How many were asked for.
        vertices: usize,
        /// What was wrong with the last one tried.
        failure: Failure,
    },
    /// A given hull does not enclose the object.
    #[error(transparent)]
    NotEnclosing(#[from] Offence),
    /// The work was stopped.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Why an offset does not give a hull.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Failure {
    /// The coarse surface does not enclose the object.
    #[error("{0}")]
    Offence(Offence),
    /// The surface cannot be simplified so far.
    #[error("no fewer than {0} vertices could be reached")]
    Vertices(usize),
    /// The offset is too small or too large a share of the object's size to be computed.
    #[error("its surface is beyond the limits of memory or of 32-bit floats")]
    Unsupported,
}

impl Hull {
    /// A mesh that the caller vouches for: nothing is checked. Where it does not enclose the object, outlines have holes.
    pub fn trusted(mesh: impl Into<Arc<TriangleMesh>>) -> Self {
        Self { mesh: mesh.into(), offset: None, enclosure: None }
    }

    /// A given mesh, if it encloses the object. See [`enclosure`] for what that means and costs.
    ///
    /// # Errors
    /// [`HullError::NotEnclosing`] names the first offence.
    pub fn checked(object: &TriangleMesh, hull: impl Into<Arc<TriangleMesh>>) -> Result<Self, HullError> {
        Self::checked_with_progress(object, hull, &NoProgress)
    }

    /// Like [`checked`](Self::checked), but stops when `progress` asks to.
    ///
    /// # Errors
    /// As [`checked`](Self::checked); [`HullError::Cancelled`] when `progress` says so.
    pub fn checked_with_progress(
        object: &TriangleMesh,
        hull: impl Into<Arc<TriangleMesh>>,
        progress: &dyn Progress,
    ) -> Result<Self, HullError> {
        let mesh = hull.into();
        let enclosure = Enclosed::with_progress(object, progress)?.by_with_progress(&mesh, progress)?;
        enclosure.first.map_or(Ok(()), Err)?;
        Ok(Self { mesh, offset: None, enclosure: Some(enclosure) })
    }

    /// Its triangles, in the object's own space.
    pub fn mesh(&self) -> &Arc<TriangleMesh> {
        &self.mesh
    }

    /// The distance from the object, in object units, of the surface that it is a simplification of. Its vertices are about so
    /// far away, its faces nearer or farther. `None` for a given mesh.
    pub fn offset(&self) -> Option<f64> {
        self.offset
    }

    /// What was found about its enclosing the object; `None` where nothing was checked.
    pub fn enclosure(&self) -> Option<&Enclosure> {
        self.enclosure.as_ref()
    }
}
