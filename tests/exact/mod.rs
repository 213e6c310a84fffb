//! What the workspace computes against rational arithmetic without any rounding.
//!
//! `tests/exactness.rs`, `tests/oracle.rs` and `crates/visibility/tests/main/oracle.rs` ask exact integers for the set of
//! silhouette edges and for the invisibility of single points. New here are predicates with their values and powers
//! (`predicates.rs`), whole drawings as exact intervals of parameters with the ends of their chains (`drawing.rs`, `clipped.rs`), and
//! outlines as exact polygons (`outline.rs`).
//!
//! Nothing here treats a tie. The viewer and the strokes that the crate moves infinitesimally are moved by small rational
//! numbers instead, chosen below the least difference that the coordinates allow (`moved.rs`): a viewer in general position
//! whom plain geometry describes.

mod clipped;
mod drawing;
mod moved;
mod outline;
mod predicates;
mod rational;
mod situations;
mod visible;
