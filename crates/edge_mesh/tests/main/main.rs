//! What the method draws and extracts.
#![cfg(feature = "gpu")]
