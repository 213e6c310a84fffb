//! How a command fails: one line on stderr and an exit code.

use crate::{PROGRAM, interrupt, observer};
use silhouette_compare::runner::CompareError;
use silhouette_core::load::LoadError;
use silhouette_core::method::{OptionError, PrepareError};
use silhouette_core::progress::Cancelled;
use silhouette_core::view::ViewError;
use silhouette_render::GpuError;
use std::cell::RefCell;
use std::fmt::{self, Display};
use std::io::Write;
use std::process::ExitCode;

/// Why a command did not do what it was asked.
#[derive(Debug)]
pub enum Failure {
    /// Bad usage or bad input: exit code 2. The message names the file or argument, the place and the mend.
    Input(String),
    /// The run itself failed: exit code 1.
    Run(String),
    /// Ctrl-C: exit code 130.
    Interrupted,
}

impl Failure {
    /// Bad usage or bad input.
    pub fn input(message: impl Display) -> Self {
        Self::Input(message.to_string())
    }

    /// The run itself failed.
    pub fn run(message: impl Display) -> Self {
        Self::Run(message.to_string())
    }

    /// `method` could not be prepared for `mesh`: bad input where an option or the mesh itself does not fit.
    pub fn of_preparation(mesh: &str, method: &str, error: PrepareError) -> Self {
        match error {
            PrepareError::Option(error) => error.into(),
            PrepareError::Mesh(reason) => Self::Input(format!("{mesh}: not defined for {method}: {reason}")),
            other => Self::run(other),
        }
    }

    /// A comparison failed: bad input where a mesh or the views of it do not fit.
    pub fn of_comparison(error: CompareError) -> Self {
        use CompareError::{EmptyMesh, NoMesh, SameName, View};
        match error {
            input @ (NoMesh | SameName { .. } | EmptyMesh { .. } | View { .. }) => Self::input(input),
            other => Self::run(other),
        }
    }

    /// No device could be opened: bad usage where the choice of an adapter itself does not fit.
    pub fn gpu(error: GpuError) -> Self {
        match error {
            GpuError::AdapterVariable { .. } => Self::input(error),
            other => Self::run(other),
        }
    }

    /// Prints the line on stderr, after the name of the program; yields the exit code.
    pub fn report(&self, program: &str) -> ExitCode {
        // Where stderr is closed there is nobody to tell; the exit code still says it.
        let _ = writeln!(std::io::stderr(), "{program}: {self}");
        ExitCode::from(self.exit_code())
    }

    /// What a program that fails so exits with.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Input(_) => 2,
            Self::Run(_) => 1,
            Self::Interrupted => interrupt::EXIT_CODE,
        }
    }
}

impl Display for Failure {
    /// The line.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(message) | Self::Run(message) => f.write_str(&one_line(message)),
            Self::Interrupted => f.write_str("interrupted; what was in progress was not written"),
        }
    }
}

thread_local! {
    /// Notes of this thread, while [`with_notes`] collects them.
    static TAKEN: RefCell<Option<Vec<String>>> = const { RefCell::new(None) };
}

/// Passes a note on, on one line: something that does not stop the command, but that its user has to know. It goes to
/// [`with_notes`], else to the observer of the command, else to stderr.
pub fn note(message: impl Display) {
    let line = one_line(&message.to_string());
    let left = TAKEN.with_borrow_mut(|taken| match taken {
        Some(notes) => {
            notes.push(line);
            None
        }
        None => Some(line),
    });
    match (left, observer::current()) {
        (None, _) => {}
        (Some(line), Some(observer)) => observer.note(&line),
        // Where stderr is closed nobody can read it.
        (Some(line), None) => drop(writeln!(std::io::stderr(), "{PROGRAM}: note: {line}")),
    }
}

/// Does work, and yields what it notes on this thread, instead of passing it on.
pub fn with_notes<T>(work: impl FnOnce() -> T) -> (T, Vec<String>) {
    /// Restores what was collected before, after a panic as well.
    struct Restores(Option<Vec<String>>);
    impl Drop for Restores {
        fn drop(&mut self) {
            TAKEN.set(self.0.take());
        }
    }
    let _restores = Restores(TAKEN.replace(Some(Vec::new())));
    let done = work();
    (done, TAKEN.take().unwrap_or_default())
}

/// clap's message as one line: its paragraphs up to the usage, which `--help` of the program shows.
pub fn usage(error: &clap::Error, program: &str) -> Failure {
    let text = error.render().to_string();
    let lines =
        text.lines().map(str::trim).take_while(|line| !line.starts_with("Usage:") && !line.starts_with("For more"));
    let message = lines.filter(|line| !line.is_empty()).collect::<Vec<_>>().join(" ");
    Failure::Input(format!("{} (see {program} --help)", message.trim_start_matches("error: ")))
}

/// On one line, and without what a terminal would obey: an option or a file may hold any character, and messages quote them.
fn one_line(message: &str) -> String {
    let mut line = String::with_capacity(message.len());
    for word in message.split_whitespace() {
        if !line.is_empty() {
            line.push(' ');
        }
        for letter in word.chars() {
            if letter.is_control() {
                line.extend(letter.escape_default());
            } else {
                line.push(letter);
            }
        }
    }
    line
}

impl From<LoadError> for Failure {
    fn from(error: LoadError) -> Self {
        Self::input(error)
    }
}

impl From<OptionError> for Failure {
    fn from(error: OptionError) -> Self {
        Self::Input(format!("option of the method: {error}"))
    }
}

impl From<ViewError> for Failure {
    fn from(error: ViewError) -> Self {
        Self::Input(format!("camera: {error}"))
    }
}

impl From<Cancelled> for Failure {
    fn from(error: Cancelled) -> Self {
        Self::run(error)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::args::Arguments;
    use clap::Parser;

    fn message(words: &[&str]) -> String {
        let error = Arguments::try_parse_from(words).unwrap_err();
        match usage(&error, "silhouettes") {
            Failure::Input(message) | Failure::Run(message) => message,
            Failure::Interrupted => panic!("nobody interrupted"),
        }
    }

    #[test]
    fn nothing_that_a_terminal_obeys_is_printed() {
        let failure = Failure::input("there is no option 'a\u{1b}[2J\0b\nc\u{9b}'; the method has none");
        assert_eq!(failure.to_string(), "there is no option 'a\\u{1b}[2J\\u{0}b c\\u{9b}'; the method has none");
    }

    #[test]
    fn notes_go_to_the_innermost_collector() {
        let ((inner, notes), outer) = with_notes(|| {
            note("before");
            let inner = with_notes(|| note("a\nnote"));
            note("after");
            inner
        });
        assert_eq!(
            (inner, notes, outer),
            ((), vec!["a note".to_owned()], vec!["before".to_owned(), "after".to_owned()])
        );
        let ((), outer) = with_notes(|| {
            let panicked = std::panic::catch_unwind(|| with_notes(|| panic!("in the middle")));
            assert!(panicked.is_err());
            note("after a panic");
        });
        assert_eq!(outer, ["after a panic"]);
    }

    #[test]
    fn usage_errors_are_one_line_that_names_the_argument() {
        let two_numbers = message(&["silhouettes", "extract", "builtin:cube", "--eye", "1,2"]);
        assert!(two_numbers.contains("--eye") && two_numbers.contains("three numbers"), "{two_numbers}");
        let missing = message(&["silhouettes", "extract"]);
        assert!(missing.contains("<MESH>"), "{missing}");
        for text in [two_numbers, missing] {
            assert_eq!(text.lines().count(), 1);
        }
    }
}
