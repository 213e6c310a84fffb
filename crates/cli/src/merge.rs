//! `silhouettes merge`: the cells that several processes measured, as one report.

use crate::args::MergeArguments;
use crate::compare::read_peers;
use crate::failure::{self, Failure};
use silhouette_compare::sweep::{CellStore, merge};
use silhouette_compare::{Registry, report};

/// Runs the command.
pub fn run(arguments: &MergeArguments, registry: &Registry) -> Result<(), Failure> {
    report::check_target(&arguments.output).map_err(Failure::input)?;
    let peers = read_peers(&arguments.peers)?;
    let stores = arguments.cells.iter().map(|folder| CellStore::existing(folder)).collect::<Result<Vec<_>, _>>();
    let mut comparison = merge(&stores.map_err(Failure::input)?, registry).map_err(Failure::input)?;
    for cell in &comparison.left_out {
        failure::note(cell);
    }
    comparison.peers = peers;
    report::write(&comparison, &arguments.output).map_err(Failure::run)?;
    Ok(())
}
