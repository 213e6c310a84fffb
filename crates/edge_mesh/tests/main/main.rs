//! What the method draws and extracts, on whatever adapter there is.
#![cfg(feature = "gpu")]

mod economy;
mod edge_sets;
mod extremes;
mod features;
mod placed;
mod scene;
mod widths;
