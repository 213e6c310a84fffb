//! The contract of a method: its description ([`MethodInfo`]) and options ([`MethodOptions`]), how it is prepared ([`Method`]) and what it can do
//! (the capability traits).
//!
//! To add a paper: make a crate with one file per step, make the options struct with
//! [`method_options!`](crate::method_options), implement [`Method`] and the capabilities that the method has, and add one
//! line to the registry in `silhouette-compare`. A method that cannot do something does not implement the trait; nothing
//! answers "unsupported" at run time.
//!
//! | capability | trait | yields |
//! |---|---|---|
//! | extracts edges | [`ExtractsEdges`] | sorted edge ids |
//! | extracts edges of a moving mesh | [`ExtractsMovingEdges`] | the same, for this frame's positions |
//! | extracts loops | [`ExtractsLoops`] | closed, oriented loops of half-edges |
//! | extracts curves | [`ExtractsCurves`] | smooth pieces in open or closed chains |
//! | draws lines | `silhouette_gpu::DrawsLines` | ink in somebody's render pass |

mod guide;
mod options;
mod published;
mod sweep;
mod typed_options;

pub use guide::MethodGuide;
pub use options::{OptionError, OptionKind, OptionSpec, OptionValue, OptionValues};
pub use published::{PublishedRate, PublishedRates};
pub use sweep::Sweep;
pub use typed_options::{MethodOptions, NoOptions, OptionChoice, OptionField};

use crate::curves::SilhouetteCurves;
use crate::id::VertexId;
use crate::loops::SilhouetteLoops;
use crate::prepared::PreparedMesh;
use crate::progress::{Cancelled, NoProgress, Progress};
use crate::silhouette::SilhouetteEdges;
use crate::view::Viewpoint;
use glam::Vec3;
use std::sync::Arc;

/// Where a method was published.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct Source {
    /// Authors as printed.
    pub authors: &'static str,
    /// Title.
    pub title: &'static str,
    /// Venue.
    pub venue: &'static str,
    /// Year of publication.
    pub year: u16,
}

/// The description of a method.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct MethodInfo {
    /// Name on the command line and in results, in kebab case.
    pub name: &'static str,
    /// What it does, in one sentence.
    pub summary: &'static str,
    /// Where it was published.
    pub source: Source,
    /// Whether it always yields all silhouette edges and no others. Where not, what it misses is measured, not promised.
    pub exact: bool,
    /// Names of the artefacts ([`Artefact::NAME`](crate::prepared::Artefact::NAME)) that its preparation asks for,
    /// sorted. Empty: positions and triangles are enough.
    pub needs: &'static [&'static str],
    /// Its options with ranges and defaults: the [`SPECS`](MethodOptions::SPECS) of [`Method::Options`].
    pub options: &'static [OptionSpec],
    /// What a reader needs in order to choose it.
    pub guide: MethodGuide,
    /// Tables of frame rates that its publication prints and that a comparison sets its own beside; most print none.
    pub published: &'static [PublishedRates],
}

/// Why a method cannot be prepared for a mesh.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PrepareError {
    /// The work was stopped by its [`Progress`].
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// An option has no such name or a value out of range.
    #[error(transparent)]
    Option(#[from] OptionError),
    /// The method is not defined for the mesh; the cause names the elements at fault.
    #[error(transparent)]
    Mesh(Box<dyn std::error::Error + Send + Sync>),
}

/// One published method, prepared for one mesh.
///
/// Preparation happens once per mesh; the capability traits do what happens for each view. The two are never mixed, in
/// code or in measurement.
pub trait Method: Sized + Send + 'static {
    /// Its options; [`NoOptions`] where there are none.
    type Options: MethodOptions;

    /// Name, source, needs, options.
    const INFO: MethodInfo;

    /// Prepares the method for `mesh`. Derived data comes from the [`PreparedMesh`], so that methods share it; what only
    /// this method uses belongs to the returned value.
    ///
    /// # Errors
    /// [`PrepareError`]: cancelled, an option out of range, or a mesh that the method is not defined for.
    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &Self::Options,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError>;

    /// [`prepare`](Self::prepare) without progress.
    ///
    /// # Errors
    /// [`PrepareError`]: an option out of range, or a mesh that the method is not defined for.
    fn new(mesh: &Arc<PreparedMesh>, options: Self::Options) -> Result<Self, PrepareError> {
        Self::prepare(mesh, &options, &NoProgress)
    }

    /// Bytes this value holds beyond the artefacts of its mesh.
    fn bytes(&self) -> usize;
}

/// What one extraction did; the same numbers on every machine and for every thread count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
pub struct ExtractionStats {
    /// Faces whose facing was evaluated.
    pub faces_tested: u64,
    /// How often an edge was tested for faces that differ.
    pub edges_tested: u64,
    /// Nodes of a hierarchy whose bounds were evaluated; 0 for a method without one.
    pub nodes_visited: u64,
    /// Faces whose sign the floating-point filter could not certify, decided by exact arithmetic.
    pub exact_fallbacks: u64,
}

/// Finds the silhouette edges of a view.
pub trait ExtractsEdges: Send {
    /// Replaces `out` by the silhouette edges seen from `viewpoint`, sorted by id. Scratch memory is kept from call to
    /// call; once `out` has grown, a call allocates nothing.
    fn extract_edges(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteEdges) -> ExtractionStats;
}

/// Finds the silhouette edges of a mesh whose vertices move while its triangles stay: skinning, morphing, simulation.
pub trait ExtractsMovingEdges: ExtractsEdges {
    /// Makes the next extractions see `positions`, one per vertex in object space. The topology is kept; the mesh that the
    /// method was prepared for is not changed. O(V + F), allocates nothing from the second call on.
    ///
    /// # Errors
    /// [`PositionsError`]; the previous positions then stay in force.
    fn update_positions(&mut self, positions: &[Vec3]) -> Result<(), PositionsError>;
}

/// Why positions do not fit a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PositionsError {
    /// Not one position per vertex.
    #[error("{given} positions for a mesh of {vertices} vertices")]
    Count {
        /// How many were given.
        given: usize,
        /// How many the mesh has.
        vertices: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("the position of vertex {vertex} is not finite")]
    NotFinite {
        /// The first such vertex.
        vertex: VertexId,
    },
}

/// Finds the silhouette of a view as closed loops.
pub trait ExtractsLoops: ExtractsEdges {
    /// Replaces `out` by the loops that the silhouette half-edges seen from `viewpoint` form, front face on the left,
    /// ordered by each loop's lowest edge, at which it begins.
    fn extract_loops(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteLoops) -> ExtractionStats;
}

/// Finds the silhouette of a view as smooth curves.
pub trait ExtractsCurves: Send {
    /// Replaces `out` by the curves seen from `viewpoint`, in object space. Once `out` has grown, a call allocates nothing.
    fn extract_curves(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteCurves) -> ExtractionStats;
}
