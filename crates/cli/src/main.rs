//! `silhouettes`: find, draw and compare the silhouettes of triangle meshes.
//!
//! Exit codes: 0 done, 1 the run failed, 2 bad usage or bad input. A failure is one line on stderr that names the place
//! and the mend. Results go to stdout or to `-o`, progress and notes to stderr.

mod args;
mod camera;
mod compare;
mod doctor;
mod extract;
mod failure;
mod input;
mod inspect;
mod lines;
mod output;
mod progress;
mod render;
mod reproduce;

use args::{Arguments, Command};
use clap::Parser;
use failure::Failure;
use std::process::ExitCode;

fn main() -> ExitCode {
    let result = match Arguments::try_parse() {
        Ok(arguments) => run(arguments.command),
        Err(error) if !error.use_stderr() => {
            // Help and version: clap's own text, on stdout.
            return if error.print().is_ok() { ExitCode::SUCCESS } else { ExitCode::FAILURE };
        }
        Err(error) => Err(failure::usage(&error)),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

fn run(command: Command) -> Result<(), Failure> {
    match command {
        Command::Doctor => doctor::run(),
        Command::Inspect(arguments) => inspect::run(&arguments),
        Command::Extract(arguments) => extract::run(&arguments),
        Command::Lines(arguments) => lines::run(&arguments),
        Command::Render(arguments) => render::run(&arguments),
        Command::Compare(arguments) => compare::run(&arguments),
        Command::Reproduce(arguments) => reproduce::run(&arguments),
    }
}
