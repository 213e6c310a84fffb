//! Comparisons in pieces: over many processes and machines, and over interruptions.
//!
//! A comparison is a list of *cells*, one for each mesh and choice of a method with options. What decides a cell is written down
//! ([`Key`]), so that any process with the same key measures the same cells:
//!
//! 1. [`shard`]: which cells are a process's own, as `3/20` or by what Slurm says of an array;
//! 2. [`store`]: a directory of finished cells. Each appears as a whole, so that a process that is killed loses the cell that it
//!    was measuring and no other, and several processes may share one directory;
//! 3. [`run_shard`]: measures the cells of a shard that the store does not hold;
//! 4. [`refine`]: measures more values of swept options where the [front is coarse](gap), within a budget of time;
//! 5. [`merge`](mod@merge): stores become the [`Comparison`](crate::Comparison) that one process would have yielded.
//!
//! What a picture is worth does not depend on the process that drew it. Times do: each cell says which of the
//! [runs](crate::Comparison::runs) measured it, and cells of different machines never stand in one chart.

pub mod gap;
pub mod key;
pub mod merge;
pub mod refine;
mod run;
pub mod shard;
pub mod store;

pub use gap::Errors;
pub use key::Key;
pub use merge::{MergeError, merge};
pub use refine::{Budget, Refinement};
pub use run::{ShardError, run_shard};
pub use shard::Shard;
pub use store::{CellStore, Kept, StoreError};

#[cfg(test)]
mod tests;
