//! Each stage against its CPU twin, and the pictures of both paths.

mod closed;
mod left_out;
mod picture;
mod scene;
mod stages;
mod sums;
