//! Compression against what it must leave unchanged, and against independent computations.

mod eigen;
mod forms;
mod lobes;
mod terms;
