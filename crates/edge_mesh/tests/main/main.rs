//! What the method draws and extracts, on whatever adapter there is.
#![cfg(feature = "gpu")]

mod look;
mod scene;
