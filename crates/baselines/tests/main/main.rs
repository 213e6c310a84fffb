//! What the line methods draw, on whatever adapter there is.
#![cfg(feature = "gpu")]

mod filter;
mod flood;
mod hull;
mod placed;
mod scene;
mod targets;
