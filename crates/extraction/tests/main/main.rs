//! The exact methods against brute force, edge for edge.

mod allocations;
mod exactness;
mod moving;
mod scenes;
