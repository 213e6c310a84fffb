//! Each stage against its CPU twin, and the pictures of both paths.

mod picture;
mod scene;
mod stages;
