//! Extraction of silhouette edges: every method of the registry over meshes and views, interleaved, against a plain read.
//!
//! `cargo bench --bench extractors -- [--views 200] [--threads 1,2] [--output rows.jsonl] [--plot times.svg]
//! [--export DIR] [--peers rows.jsonl]... [MESH[+loopN]...]`
//!
//! 1. [`arguments`]: what to measure; without arguments built-in blobs from a thousand to a million faces, and the bunny
//!    and the armadillo where `SILHOUETTES_MODELS` names a folder that holds them.
//! 2. [`mesh_source`]: files and built-in shapes, Loop-subdivided on request: `stanford-bunny.obj+loop2` is the bunny with
//!    16 times the faces.
//! 3. [`export`]: the meshes as files, so that other tools are measured on the very same ones.
//! 4. [`measure`]: answers asserted first, then timed, view by view, all methods in turn, each ([`cell`]) with all numbers
//!    of [`threads`] in turn.
//! 5. [`stream_read`]: as many bytes as `brute-force-simd` reads, read plainly.
//! 6. [`table`]: ratios to `brute-force-simd`, of several threads to one, and laws of growth.
//! 7. [`plot`]: time over faces as SVG.
//!
//! Rows ([`ExtractionRow`]) are the same as those of `benches/peers`; `--peers` puts them into the same table and plot.
//! `--views 0` measures nothing, but exports the meshes named and shows those rows.

mod arguments;
mod cell;
mod export;
mod measure;
mod mesh_source;
mod plot;
mod stream_read;
mod table;
mod threads;

use arguments::Arguments;
use clap::Parser;
use export::{Export, ExportError};
use measure::{MeasureError, measure_mesh};
use mesh_source::{SourceError, load_mesh};
use silhouette_compare::machine::{describe_machine, describe_program};
use silhouette_compare::scaling::{ExtractionRow, RowsError, read_rows, write_rows};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use threads::Threads;

/// Why nothing was measured, or not all of it.
#[derive(Debug, thiserror::Error)]
enum BenchError {
    #[error(transparent)]
    Source(#[from] SourceError),
    #[error(transparent)]
    Export(#[from] ExportError),
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
    let (program, machine, views) = (describe_program(), describe_machine(), arguments.views);
    let counts = arguments.threads();
    let listed: Vec<String> = counts.iter().map(u32::to_string).collect();
    writeln!(out, "{program}; {machine}; {views} views, threads: {}", listed.join(", ")).map_err(BenchError::Table)?;

    let all_threads = counts.into_iter().map(Threads::new).collect::<Result<Vec<_>, _>>()?;
    let mut export = arguments.export.as_deref().map(Export::to).transpose()?;
    let mut measured = Vec::new();
    for argument in arguments.meshes() {
        let (name, mesh) = load_mesh(&argument)?;
        if let Some(export) = &mut export {
            export.write(&name, &mesh)?;
        }
        if views > 0 {
            let found = measure_mesh(&name, mesh, views, &all_threads)?;
            for cell in &found.left_out {
                // Where stderr is closed there is nobody to tell.
                let _ = writeln!(io::stderr(), "extractors: note: {cell}");
            }
            table::write_mesh(&found.rows, &rows, &mut out).map_err(BenchError::Table)?;
            measured.extend(found.rows);
        }
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
