//! What changed between the last two runs of the benchmarks: `cargo bench --bench last_two_runs [-- FILTER...]`.
//!
//! Criterion keeps its estimates below `target/criterion`, and for each benchmark that has run twice how its median changed, with a
//! bootstrap interval. This reads them; it measures nothing. One line per benchmark whose name holds one of the filters, the largest
//! slow-down first: the medians before and now, their ratio, its interval, and `slower` or `faster` where the interval excludes 1.
//!
//! Two runs on a machine that does other work differ for that alone: a mark says that the samples differ, not why.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "the table is the output, or why there is none")]

mod changes;
mod table;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

fn main() -> ExitCode {
    // Cargo adds --bench.
    let filters: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    let folder = folder();
    match changes::read(&folder) {
        Ok(found) => {
            print!("{}", table::table(&found, &filters));
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("last_two_runs: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Where criterion writes: the folder that `CRITERION_HOME` names, or `criterion` in the target folder that holds this program.
fn folder() -> PathBuf {
    if let Some(home) = std::env::var_os("CRITERION_HOME") {
        return PathBuf::from(home);
    }
    let program = std::env::current_exe().unwrap_or_default();
    // target/release/deps/last_two_runs
    program.ancestors().nth(3).unwrap_or(Path::new("target")).join("criterion")
}
