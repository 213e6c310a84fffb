#![doc = include_str!("../README.md")]
//!
//! `examples/own-method` in the repository is a whole program with a method of its own.
//!
//! # Exit codes
//!
//! 0 done, 1 the run failed, 2 bad usage or bad input, 130 interrupted by Ctrl-C. A failure is one line on stderr that names the place
//! and the mend. Results go to stdout or to `-o`, progress and notes to stderr.

pub mod application;
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

/// What lines on stderr begin with.
pub(crate) const PROGRAM: &str = "silhouettes";

/// Runs the command that `words` say, the program's own name not among them, as [`run`] runs that of the process's arguments, but
/// leaves the failure to the caller.
///
/// # Errors
/// [`Failure`](application::Failure): the command failed, or there is no such command.
pub fn execute(words: impl IntoIterator<Item = impl Into<OsString>>, registry: &Registry) -> Result<(), Failure> {
    let words = std::iter::once("silhouettes".into()).chain(words.into_iter().map(Into::into));
    let matches = methods::command(registry).try_get_matches_from(spoken::joined(words));
    let arguments = matches.and_then(|matches| Arguments::from_arg_matches(&matches));
    dispatch(arguments.map_err(|error| failure::usage(&error, PROGRAM))?.command, registry)
}

/// Runs the command that the process's arguments name, with the methods of `registry`. Prints what goes wrong.
pub fn run(registry: &Registry) -> ExitCode {
    let matches = methods::command(registry).try_get_matches_from(spoken::joined(std::env::args_os()));
    let result = match matches.and_then(|matches| Arguments::from_arg_matches(&matches)) {
        Ok(arguments) => {
            if arguments.command.may_open_device() {
                mesa::silence();
            }
            interrupt::listen();
            dispatch(arguments.command, registry)
        }
        Err(error) if !error.use_stderr() => {
            // Help and version: clap's own text, on stdout. A reader such as `head` that has seen enough is no failure.
            return match error.print() {
                Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => ExitCode::FAILURE,
                _ => ExitCode::SUCCESS,
            };
        }
        Err(error) => Err(failure::usage(&error, PROGRAM)),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(_) if interrupt::is_asked() => Failure::Interrupted.report(PROGRAM),
        Err(failure) => failure.report(PROGRAM),
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
