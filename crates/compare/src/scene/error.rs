//! Why a scene is refused.

use super::sweep;
use crate::registry::UnknownMethod;
use silhouette_core::method::OptionError;
use std::io;
use std::path::PathBuf;

/// A scene is refused.
#[derive(Debug, thiserror::Error)]
#[error("{place}: {fault}")]
pub struct SceneError {
    /// The scene's file, or the scene's name where it has none.
    pub place: String,
    /// What is wrong.
    pub fault: SceneFault,
}

/// What is wrong with a scene.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SceneFault {
    /// Its file cannot be read.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// Its file is longer than any scene.
    #[error("longer than {limit} bytes, so no scene")]
    TooLong {
        /// Most bytes that are read.
        limit: u64,
    },
    /// Its file is not of the form of a scene.
    #[error("line {line}: {key}{message}")]
    Form {
        /// The line, from 1.
        line: usize,
        /// The key on that line, with a colon, or nothing.
        key: String,
        /// What is wrong and what is expected.
        message: String,
    },
    /// A value does not fit.
    #[error("{key} = {value} does not fit: {expected}")]
    Value {
        /// The key with its table, as `path.frames`.
        key: &'static str,
        /// The value.
        value: String,
        /// What fits.
        expected: String,
    },
    /// A mesh that is to be simplified is measured against another.
    #[error("{mesh} has a truth of its own in the scene; a mesh is drawn simplified or has a truth, not both")]
    HasTruth {
        /// The mesh.
        mesh: String,
    },
    /// There is no such method.
    #[error("methods: {0}")]
    Method(UnknownMethod),
    /// A method yields no picture.
    #[error("{method} yields no picture that could be compared")]
    NoPicture {
        /// The method.
        method: String,
    },
    /// An option does not fit its method.
    #[error("{method}: {fault}")]
    Option {
        /// The method.
        method: String,
        /// What is wrong.
        fault: OptionError,
    },
    /// An option has a list without values.
    #[error("{method}: {option} has no value; give one or leave it out")]
    NoValue {
        /// The method.
        method: String,
        /// The option.
        option: String,
    },
    /// Two cells would be the same.
    #[error("{method} is there twice with the same options ({options}); leave one out")]
    Twice {
        /// The method.
        method: String,
        /// All of its options.
        options: String,
    },
    /// More cells than can be run.
    #[error("{cells} combinations of methods and options; at most {limit} are compared at once")]
    TooManyCells {
        /// How many there are, or a lower bound of it.
        cells: usize,
        /// How many there may be.
        limit: usize,
    },
    /// Options are set of a method that is not compared.
    #[error("{method}.{option} is set, but {method} is not compared; name it in --methods")]
    NotCompared {
        /// The method.
        method: String,
        /// The option.
        option: String,
    },
    /// An option that says of no values that they are worth comparing is to be swept.
    #[error("{method}.{option} has no sweep; {}", clause_of_sweeps(method, known))]
    NoSweep {
        /// The method.
        method: String,
        /// The option.
        option: String,
        /// Options of the method that have one.
        known: Vec<&'static str>,
    },
    /// An option is to be swept that has several values already.
    #[error("{method}.{option} has several values already; sweep it once, or list its values with --set")]
    SweptTwice {
        /// The method.
        method: String,
        /// The option.
        option: String,
    },
    /// A sweep is not of its form.
    #[error("'{text}' is not of the form METHOD.OPTION[=N], N values from {} to {}", sweep::VALUES.start(), sweep::VALUES.end())]
    SweepForm {
        /// What was given.
        text: String,
    },
    /// A setting is not of its form.
    #[error("'{text}' is not of the form METHOD.OPTION=VALUE[,VALUE...]")]
    SetForm {
        /// What was given.
        text: String,
    },
}

fn clause_of_sweeps(method: &str, known: &[&str]) -> String {
    match known {
        [] => format!("no option of {method} has one; list values with --set"),
        known => format!("there are {}; list values of others with --set", known.join(", ")),
    }
}

impl From<UnknownMethod> for SceneFault {
    fn from(cause: UnknownMethod) -> Self {
        Self::Method(cause)
    }
}

impl SceneFault {
    /// The fault with where it is.
    pub fn in_scene(self, place: impl Into<String>) -> SceneError {
        SceneError { place: place.into(), fault: self }
    }

    /// The fault with the file where it is.
    pub fn in_file(self, path: &std::path::Path) -> SceneError {
        self.in_scene(PathBuf::from(path).display().to_string())
    }
}
