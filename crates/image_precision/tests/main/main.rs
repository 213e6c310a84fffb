//! What the method draws, on whatever adapter there is.
#![cfg(feature = "gpu")]

mod scaled;
mod scene;
mod variants;
