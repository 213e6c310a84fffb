#![doc = include_str!("../README.md")]
//!
//! # Steps
//!
//! In the paper's order:
//!
//! 1. `connectivity_table` (Preparation): neighbours and plane of each face; `plane_test`: facing by the plane;
//!    `concave_edges`: concave edges in order of decreasing angle, and the boundary; `refuse` (Restrictions): meshes that
//!    cannot be tracked, or are cut.
//! 2. [`brute_force`]: the first frame.
//! 3. `track` (Tracking the Silhouette): each edge of the old loops is tested; `find_silhouette_edge` walks from one
//!    that is no silhouette any more to one that is; `complete_silhouette` walks the whole loop from there;
//!    `single_edge` (Single edge testing) tests fewer edges.
//! 4. `detect_new` (Detecting new silhouettes): the concave list down to the concavity level, then the boundary list.
//! 5. [`identity`], not in the paper: each loop keeps an id, and births, deaths, splits and merges are reported.
//!
//! [`as_printed`] shows the slips of the printed text. Two modes go beyond the paper ([`Accuracy`]):
//!
//! - `exact`: no loop is ever missed, and a frame costs what changes;
//! - `budget`: the concavity level follows from the share of the silhouette that may be missed.
//!
//! # When to choose it
//!
//! Where the view changes little from frame to frame, and loops are wanted in order. What is found is silhouette, always:
//! facings are exact, and loops complete. The exact mode misses nothing and, at small steps, is faster than tracking up to
//! level 0.2, so it is the first to try. What is missed by level:
//!
//! - at level 0 with all edges tested, only what is neither reached from an old edge nor holds a concave edge or a
//!   boundary edge: nothing in all that the tests try, but there is no proof for large steps;
//! - at level N, also loops that are new and hold no edge bent by more than N. How many depends on the tessellation:
//!   finer triangles have smaller angles;
//! - with single edges tested, also parts that split off.
//!
//! Frames that must not be tracked are found by brute force ([`BruteForceReason`]): the first, after a frame without
//! silhouette, after a jump, and when the eye may have crossed the surface, since the rule that new loops come from
//! concave edges holds only while it does not (`eye_crossing` says what is promised).
//!
//! # Departures from the paper
//!
//! 1. Facings are exact and evaluated at most once per frame.
//! 2. Twin half-edges instead of a table of faces, which is ambiguous where two faces share several edges.
//! 3. The corrections that [`as_printed`] lists.
//! 4. A fruitless walk ends by itself, and when all walks of a frame together take more steps than one fruitless walk
//!    can (6 F), brute force takes over.
//! 5. Loops run counter-clockwise around front faces.
//! 6. The concave edges of a level are searched in the order of memory, not of angle, and their faces are evaluated
//!    first.
//! 7. All faces that the loops of the last frame were walked along are evaluated first, four at a time, and what no
//!    turned face lies on is copied instead of walked (`complete_silhouette`). With all edges tested at most 0.6 % more
//!    faces are evaluated for it on the bunny; with single edges 0.5 % at 0.1 degrees per frame, and 16 % at 10 degrees,
//!    where much of what was is never walked again.
//!
//! The baseline, [`BruteForce`], does nothing of the kind: it has no past, and evaluates one face after the other.
//! [`BruteForce::in_fours`] evaluates as tracking does.
//!
//! # Cost
//!
//! A tracked frame: O(S + faces walked over + selected concave edges + boundary edges) for S silhouette edges, on one
//! thread, without allocation; an audited frame O(F), and the exact mode as `exact` says. Preparation: O(F + E + C log C) for C
//! concave edges. Memory: 45 bytes per face, at most 60 per concave edge, and some 40 per silhouette edge.

pub mod as_printed;
mod asked;
pub mod brute_force;
mod budget;
mod complete_silhouette;
mod concave_edges;
mod connectivity_table;
mod detect_new;
mod exact;
mod eye_crossing;
mod faces;
mod find_silhouette_edge;
pub mod identity;
mod method;
mod options;
mod plane_test;
mod published;
mod refuse;
mod scene;
mod single_edge;
mod stats;
mod track;
mod tracker;

pub use brute_force::BruteForce;
pub use budget::Audit;
pub use concave_edges::{ConcaveEdge, TrackedEdges};
pub use connectivity_table::ConnectivityTable;
pub use identity::{LoopEvent, LoopEvents, LoopId, LoopIdentities, Relation};
pub use method::{ExactTracking, Tracking};
pub use options::{Accuracy, Concavity, ErrorBudget, MeshPolicy, TestedEdges, TrackerOptions, TrackingOptions};
pub use refuse::{Defect, DefectKind, NotTrackable, RefusedByMethod};
pub use stats::{BruteForceReason, TrackingStats};
pub use tracker::Tracker;
