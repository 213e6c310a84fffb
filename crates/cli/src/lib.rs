#![doc = include_str!("../README.md")]
//!
//! `examples/own-method` in the repository is a whole program with a method of its own.
//!
//! # Exit codes
//!
//! 0 done, 1 the run failed, 2 bad usage or bad input, 130 interrupted by Ctrl-C. A failure is one line on stderr that names the place
//! and the mend. Results go to stdout or to `-o`, progress and notes to stderr.

mod args;
mod bake;
mod camera;
mod compare;
mod doctor;
mod extract;
mod failure;
mod input;
mod inspect;
mod interrupt;
mod lines;
mod merge;
mod mesa;
mod mesh_argument;
mod methods;
mod out_of_view;
mod output;
mod progress;
mod recommend;
mod render;
mod reproduce;
mod score;
mod smooth;
mod spoken;
mod winding;

pub use silhouette_compare::registry::{Entry, EntryBuilder, Registry};

use args::{Arguments, Command};
use clap::FromArgMatches;
use failure::Failure;
use std::ffi::OsString;
use std::process::ExitCode;

/// Runs the command that the process's arguments name, with the methods of `registry`. Prints what goes wrong.
pub fn run(registry: &Registry) -> ExitCode {
    let matches = methods::command(registry).try_get_matches_from(spoken::joined(std::env::args_os()));
    let result = match matches.and_then(|matches| Arguments::from_arg_matches(&matches)) {
        Ok(arguments) => {
            if arguments.command.may_open_device() {
                mesa::silence();
            }
            interrupt::listen();
            input::limit_bytes(arguments.limit_bytes.unwrap_or(u64::MAX));
            dispatch(arguments.command, registry)
        }
        Err(error) if !error.use_stderr() => {
            // Help and version: clap's own text, on stdout. A reader such as `head` that has seen enough is no failure.
            return match error.print() {
                Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => ExitCode::FAILURE,
                _ => ExitCode::SUCCESS,
            };
        }
        Err(error) => Err(failure::usage(&error)),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(_) if interrupt::is_asked() => Failure::Interrupted.report(),
        Err(failure) => failure.report(),
    }
}

/// Whether a command line can be read, without doing what it says: its words, without the program's name.
///
/// # Errors
/// The line that [`run`] would print for it.
pub fn check(words: impl IntoIterator<Item = OsString>, registry: &Registry) -> Result<(), String> {
    let words = std::iter::once("silhouettes".into()).chain(words);
    let matches = methods::command(registry).try_get_matches_from(spoken::joined(words));
    match matches.and_then(|matches| Arguments::from_arg_matches(&matches)) {
        Err(error) if error.use_stderr() => Err(failure::usage(&error).line()),
        _ => Ok(()),
    }
}

fn dispatch(command: Command, registry: &Registry) -> Result<(), Failure> {
    match command {
        Command::Doctor => doctor::run(registry),
        Command::Methods(arguments) => methods::run(&arguments, registry),
        Command::Inspect(arguments) => inspect::run(&arguments),
        Command::Extract(arguments) => extract::run(&arguments, registry),
        Command::Lines(arguments) => lines::run(&arguments),
        Command::Render(arguments) => render::run(&arguments, registry),
        Command::Smooth(arguments) => smooth::run(&arguments, registry),
        Command::Bake(arguments) => bake::run(&arguments),
        Command::Compare(arguments) => compare::run(&arguments, registry),
        Command::Merge(arguments) => merge::run(&arguments, registry),
        Command::Score(arguments) => score::run(&arguments),
        Command::Recommend(arguments) => recommend::run(&arguments, registry),
        Command::Reproduce(arguments) => reproduce::run(&arguments),
    }
}
