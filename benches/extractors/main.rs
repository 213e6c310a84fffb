//! Extraction of silhouette edges: every method of the registry over meshes and views, interleaved, against a plain read.
//!
//! `cargo bench --bench extractors -- [--views 200] [--threads 1] [--output rows.jsonl] [--plot times.svg]
//! [--peers rows.jsonl]... [MESH...]`
//!
//! 1. [`arguments`]: what to measure; without arguments built-in blobs from a thousand to a million faces, and the bunny
//!    and the armadillo where `SILHOUETTES_MODELS` names a folder that holds them.
//! 2. [`measure`]: answers asserted first, then timed, view by view, all methods in turn.
//! 3. [`stream_read`]: as many bytes as `brute-force-simd` reads, read plainly.
//! 4. [`table`]: ratios to `brute-force-simd`, and laws of growth.
//! 5. [`plot`]: time over faces as SVG.
//!
//! Rows ([`ExtractionRow`]) are the same as those of `benches/peers`; `--peers` puts them into the same table and plot.
//! `--views 0` measures nothing and shows only those.

mod arguments;
mod measure;
mod plot;
mod stream_read;
mod table;

use arguments::Arguments;
use clap::Parser;
use measure::{MeasureError, measure_mesh};
use silhouette_compare::machine::{describe_machine, describe_program};
use silhouette_compare::scaling::{ExtractionRow, RowsError, read_rows, write_rows};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Why nothing was measured, or not all of it.
#[derive(Debug, thiserror::Error)]
enum BenchError {
    #[error(transparent)]
    Measure(#[from] MeasureError),
    #[error(transparent)]
    Peers(#[from] RowsError),
    #[error(transparent)]
    Threads(#[from] rayon::ThreadPoolBuildError),
    #[error("{}: {source}", path.display())]
    Output { path: PathBuf, source: io::Error },
    #[error("standard output: {0}")]
    Table(io::Error),
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // Where stderr is closed there is nobody to tell; the exit code still says it.
            let _ = writeln!(io::stderr(), "extractors: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), BenchError> {
    let mut rows: Vec<ExtractionRow> = Vec::new();
    for path in &arguments.peers {
        rows.extend(read_rows(path)?);
    }
    let mut out = io::stdout().lock();
    let (program, machine) = (describe_program(), describe_machine());
    let Arguments { views, threads, .. } = arguments;
    writeln!(out, "{program}; {machine}; {views} views, {threads} of the threads").map_err(BenchError::Table)?;

    let pool = rayon::ThreadPoolBuilder::new().num_threads(arguments.threads as usize).build()?;
    let mut measured = Vec::new();
    for mesh in arguments.meshes() {
        let found = pool.install(|| measure_mesh(&mesh, arguments))?;
        table::write_mesh(&found, &rows, &mut out).map_err(BenchError::Table)?;
        measured.extend(found);
    }
    if let Some(path) = &arguments.output {
        let file = std::fs::File::create(path);
        let written = file.and_then(|file| write_rows(&measured, io::BufWriter::new(file)));
        written.map_err(|source| output_error(path, source))?;
    }
    rows.splice(0..0, measured);
    table::write_growth(&rows, &mut out).map_err(BenchError::Table)?;
    if let Some(path) = &arguments.plot {
        std::fs::write(path, plot::times_over_faces(&rows)).map_err(|source| output_error(path, source))?;
    }
    Ok(())
}

fn output_error(path: &Path, source: io::Error) -> BenchError {
    BenchError::Output { path: path.to_owned(), source }
}
