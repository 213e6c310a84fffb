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
pub mod calls;
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
mod observer;
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
use failure::Failure;
use std::ffi::OsString;
use std::process::ExitCode;

/// What lines on stderr begin with.
pub(crate) const PROGRAM: &str = "silhouettes";

/// Runs the command that `words` say, the program's own name not among them, as [`run`] runs that of the process's arguments, but
/// leaves the failure to the caller.
///
/// # Errors
/// [`Failure`]: the command failed, or there is no such command.
pub fn execute(words: impl IntoIterator<Item = impl Into<OsString>>, registry: &Registry) -> Result<(), Failure> {
    let words = std::iter::once(PROGRAM.into()).chain(words.into_iter().map(Into::into));
    dispatch(calls::arguments(words, registry).map_err(|error| failure::usage(&error, PROGRAM))?, registry)
}

/// Runs the command that the process's arguments name, with the methods of `registry`. Prints what goes wrong.
pub fn run(registry: &Registry) -> ExitCode {
    ExitCode::from(exit_code(std::env::args_os(), registry))
}

/// Runs the command that `words` say, that of the program first, as a whole program does: listens for Ctrl-C, prints what goes wrong, and
/// yields what the process is to exit with.
pub fn exit_code(words: impl IntoIterator<Item = OsString>, registry: &Registry) -> u8 {
    let result = match calls::arguments(words, registry) {
        Ok(arguments) => {
            if arguments.command.may_open_device() {
                mesa::silence();
            }
            interrupt::listen();
            dispatch(arguments, registry)
        }
        Err(error) if !error.use_stderr() => {
            // Help and version: clap's own text, on stdout. A reader such as `head` that has seen enough is no failure.
            return match error.print() {
                Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => 1,
                _ => 0,
            };
        }
        Err(error) => Err(failure::usage(&error, PROGRAM)),
    };
    let Err(failure) = result else { return 0 };
    let failure = if interrupt::is_asked() { Failure::Interrupted } else { failure };
    failure.report(PROGRAM);
    failure.exit_code()
}

/// Whether a command line can be read, without doing what it says: its words, without the program's name.
///
/// # Errors
/// The line that [`run`] would print for it.
pub fn check(words: impl IntoIterator<Item = OsString>, registry: &Registry) -> Result<(), String> {
    let words = std::iter::once(PROGRAM.into()).chain(words);
    match calls::arguments(words, registry) {
        Err(error) if error.use_stderr() => Err(failure::usage(&error, PROGRAM).to_string()),
        _ => Ok(()),
    }
}

fn dispatch(arguments: Arguments, registry: &Registry) -> Result<(), Failure> {
    input::limit_bytes(arguments.limit_bytes.unwrap_or(u64::MAX));
    match arguments.command {
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
