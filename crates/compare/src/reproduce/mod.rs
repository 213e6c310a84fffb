//! Figures of papers beside ours.
//!
//! [`figure`]: the format, one row a figure. [`tracking`]: Hall's table of speeds, and what it does not tell.

pub mod figure;
pub mod tracking;

pub use figure::{Figure, TableError, read_figures, write_figures};
