//! Makes the generated parts of the documentation.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "what was written, and what went wrong, is the output")]

use clap::Parser;
use silhouette_docs::{Made, make, pictures, write};
use std::path::Path;
use std::process::ExitCode;

/// Write the tables of README.md and docs/METHODS.md anew, from what methods say of themselves and from docs/results.
#[derive(Debug, Parser)]
struct Arguments {
    /// Only say which files are not up to date; exit code 1 where there are any
    #[arg(long)]
    check: bool,
    /// Draw the gallery's pictures, too
    #[arg(long, conflicts_with = "check")]
    pictures: bool,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match run(&arguments) {
        Ok(code) => code,
        Err(error) => {
            eprintln!("silhouette-docs: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<ExitCode, Box<dyn std::error::Error + Send + Sync>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize()?;
    if arguments.check {
        let stale: Vec<Made> = make(&root)?.into_iter().filter(|made| !made.is_up_to_date()).collect();
        for made in &stale {
            println!("{}: not up to date; run cargo run -p silhouette-docs", made.file.display());
        }
        return Ok(if stale.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE });
    }
    if arguments.pictures {
        pictures::write(&root)?.iter().for_each(|file| println!("{}", file.display()));
    }
    write(&root)?.iter().for_each(|file| println!("{}", file.display()));
    Ok(ExitCode::SUCCESS)
}
