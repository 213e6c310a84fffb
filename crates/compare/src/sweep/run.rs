//! [`run_shard`]: the cells of a shard that are not finished yet.

use super::shard::Shard;
use super::store::{CellStore, StoreError};
use crate::machine::RunDescription;
use crate::runner::{CompareConfig, CompareError, Subject, run_cells};
use crate::scene::SceneFault;
use silhouette_core::Progress;
use silhouette_render::Gpu;
use std::time::Instant;

/// Why a shard was not measured.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ShardError {
    /// A cell failed.
    #[error(transparent)]
    Compare(#[from] CompareError),
    /// A finished cell could not be kept.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// A value between two that fit does not.
    #[error(transparent)]
    Scene(#[from] SceneFault),
}

/// Measures the cells of a shard that the store does not hold, and keeps each as soon as it is finished. Meshes of which no cell is
/// due cost nothing.
///
/// # Errors
/// [`ShardError`]; what was finished before is in the store.
///
/// # Panics
/// If the store is of another comparison.
pub fn run_shard(
    config: &CompareConfig,
    subjects: &[Subject],
    store: &CellStore,
    shard: Shard,
    gpu: &Gpu,
    progress: &dyn Progress,
) -> Result<(), ShardError> {
    assert_eq!(store.key().cells(), config.methods().len() * subjects.len(), "the store is of another comparison");
    let run = RunDescription::of_this_process(gpu.adapter());
    let is_due = |cell: usize| shard.holds(cell) && !store.holds(cell);
    // Where the scene asks for several passes, the first cell of a mesh has the time of them all.
    let mut start = Instant::now();
    run_cells(config, subjects, gpu, progress, &is_due, &mut |cell, outcome| {
        let took = start.elapsed();
        start = Instant::now();
        store.put(cell, &run, took, &outcome).map_err(ShardError::Store)
    })
}
