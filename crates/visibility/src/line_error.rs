//! [`LineError`]: why there are no lines, and the limits beyond which there are none.

use silhouette_core::Cancelled;

/// Most work that one view may take, in pairs of edges that pass the same cell of the picture; what costs more counts for
/// more. Some ten seconds on one core. A picture that takes more is a tangle that no line drawing shows.
pub const MAX_WORK: u64 = 2_000_000_000;

/// Most places in one view where invisibility may change, or eight per stroke where that is more. They take some 80 bytes
/// each.
pub const MAX_EVENTS: u64 = 8_000_000;

/// Most pieces of lines in one view, beyond one per stroke: some 500 bytes each, until they are drawn.
pub const MAX_PIECES: u64 = 1_500_000;

/// Why there are no lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LineError {
    /// The work was stopped by its [`Progress`](silhouette_core::Progress).
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// Too many edges or faces lie over each other in this view.
    #[error("too many edges or faces lie over each other in this view; choose another view or fewer kinds of edges")]
    TooCrowded,
    /// The lines of this view come in more than [`MAX_PIECES`] pieces; visible lines alone are fewer.
    #[error(
        "the lines of this view come in too many pieces; choose another view, fewer kinds of edges, or no hidden lines"
    )]
    TooManyPieces,
    /// Too many faces lie in one place, or pass through each other, to find their lines of intersection.
    #[error(
        "too many faces lie in one place or pass through each other to draw their lines of intersection; leave those out"
    )]
    TooManyIntersections,
}
