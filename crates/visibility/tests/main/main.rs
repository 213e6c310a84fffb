//! Visible lines against brute force, closed forms and hostile scenes.

#![allow(clippy::print_stderr, reason = "tests report what they measured")]

mod bounds;
mod closed_forms;
mod determinism;
mod drawings;
mod hostile;
mod invariance;
mod octants;
mod oracle;
mod outline;
mod outline_raster;
mod rays;
mod scenes;
mod sections;
mod soups;
mod strokes_of_the_caller;
