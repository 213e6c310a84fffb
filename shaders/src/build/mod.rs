//! What the build script does, compiled a second time with the crate's tests.

mod import;
pub mod stages;
pub mod validate;
