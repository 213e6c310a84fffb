//! What the method draws, on whatever adapter there is.
#![cfg(feature = "gpu")]

mod economy;
mod interior;
mod placed;
mod scaled;
mod scene;
mod variants;
