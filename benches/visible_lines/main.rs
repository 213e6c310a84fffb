//! Exact visible lines: preparation, first view, views over an orbit and the view that other tools are given.
//!
//! `cargo bench --bench visible_lines -- [--views 24] [--threads 1,2] [--output rows.jsonl] [--peers rows.jsonl]...
//! [MESH[+loopN]...]`
//!
//! 1. [`arguments`]: what to measure; without arguments the bunny, the armadillo and the bunny with 1.1 million faces where
//!    `SILHOUETTES_MODELS` names a folder that holds them, and a blob of as many.
//! 2. [`mesh_source`] and [`threads`], shared with the benchmark of the extractors.
//! 3. [`measure`]: view by view, visible lines and all lines, by both sorts of finder, with all numbers of threads in turn.
//! 4. [`row`]: what is written, a JSON object a row, and what is read of the rows of `benches/peers`.
//! 5. [`table`]: ratios to the first mesh of the run, and of other tools' times to ours.
//!
//! Rows of other tools come from runs of their own, so a ratio to them is one between two runs on one machine.

mod arguments;
mod measure;
#[path = "../extractors/mesh_source.rs"]
mod mesh_source;
mod row;
mod table;
#[path = "../extractors/threads.rs"]
mod threads;

use arguments::Arguments;
use clap::Parser;
use measure::{MeasureError, measure_mesh};
use mesh_source::{SourceError, load_mesh};
use row::{LinesRow, PeersError, read_peers, write_rows};
use silhouette_compare::machine::{describe_machine, describe_program};
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use threads::Threads;

/// Why nothing was measured, or not all of it.
#[derive(Debug, thiserror::Error)]
enum BenchError {
    #[error(transparent)]
    Source(#[from] SourceError),
    #[error(transparent)]
    Measure(#[from] MeasureError),
    #[error(transparent)]
    Peers(#[from] PeersError),
    #[error(transparent)]
    Threads(#[from] rayon::ThreadPoolBuildError),
    #[error("{}: {source}", path.display())]
    Output { path: PathBuf, source: io::Error },
    #[error("standard output: {0}")]
    Table(io::Error),
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // Where stderr is closed there is nobody to tell; the exit code still says it.
            let _ = writeln!(io::stderr(), "visible_lines: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), BenchError> {
    let mut peers = Vec::new();
    for path in &arguments.peers {
        peers.extend(read_peers(path)?);
    }
    let mut out = io::stdout().lock();
    let (program, machine, views) = (describe_program(), describe_machine(), arguments.views);
    writeln!(out, "{program}; {machine}; {views} views").map_err(BenchError::Table)?;
    let all_threads = arguments.threads().into_iter().map(Threads::new).collect::<Result<Vec<_>, _>>()?;
    let mut measured: Vec<Vec<LinesRow>> = Vec::new();
    for argument in arguments.meshes() {
        let (name, mesh) = load_mesh(&argument)?;
        let rows = measure_mesh(&name, mesh, views, &all_threads)?;
        let first = measured.first().unwrap_or(&rows);
        table::write_mesh(&rows, first, &peers, &mut out).map_err(BenchError::Table)?;
        measured.push(rows);
    }
    if let Some(path) = &arguments.output {
        let file = std::fs::File::create(path);
        let written = file.and_then(|file| write_rows(&measured.concat(), io::BufWriter::new(file)));
        written.map_err(|source| BenchError::Output { path: path.clone(), source })?;
    }
    Ok(())
}
