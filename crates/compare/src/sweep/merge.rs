//! [`merge`]: directories of finished cells as one comparison.

use super::store::{CellStore, StoreError, difference};
use crate::registry::{Registry, UnknownMethod};
use crate::runner::Comparison;
use std::path::PathBuf;

/// Why directories do not make a comparison.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MergeError {
    /// There is none.
    #[error("there is nothing to merge")]
    Nothing,
    /// A directory cannot be read.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// Two directories are of different comparisons.
    #[error("{} and {} hold cells of different comparisons: the {difference} differs", first.display(), second.display())]
    Different {
        /// One.
        first: PathBuf,
        /// The other.
        second: PathBuf,
        /// What differs.
        difference: &'static str,
    },
    /// Some cells are in no directory.
    #[error(
        "cells are missing, {missing} of {cells}, the first of {method} on {mesh}; run their shards again, then merge"
    )]
    Missing {
        /// How many.
        missing: usize,
        /// Of how many.
        cells: usize,
        /// The method of the first.
        method: String,
        /// The mesh of the first.
        mesh: String,
    },
    /// A method is not known here.
    #[error(transparent)]
    Method(#[from] UnknownMethod),
}

/// The comparison whose cells the stores hold, as one process would have yielded it. Of a cell in several stores the first counts.
///
/// # Errors
/// [`MergeError`].
pub fn merge(stores: &[CellStore], registry: &Registry) -> Result<Comparison, MergeError> {
    let first = stores.first().ok_or(MergeError::Nothing)?;
    let key = first.key();
    for other in stores {
        if let Some(difference) = difference(key, other.key()) {
            let (first, second) = (first.folder().to_owned(), other.folder().to_owned());
            return Err(MergeError::Different { first, second, difference });
        }
    }
    let holder = |cell: usize| stores.iter().find(|store| store.holds(cell));
    let mut missing = (0..key.cells()).filter(|&cell| holder(cell).is_none());
    if let Some(cell) = missing.next() {
        return Err(MergeError::Missing {
            missing: 1 + missing.count(),
            cells: key.cells(),
            method: key.methods[cell % key.methods.len()].name.clone(),
            mesh: key.meshes[cell / key.methods.len()].name.clone(),
        });
    }
    let mut comparison = Comparison::new(key.scene().map_err(|error| first.damaged(&error))?);
    for method in &key.methods {
        comparison.add_method(registry.find(&method.name)?);
    }
    for cell in 0..key.cells() {
        let Some(store) = holder(cell) else { continue };
        let kept = store.read(cell)?;
        comparison.add(&kept.run, kept.outcome);
    }
    Ok(comparison)
}
