//! [`MeshArgument`]: a mesh as the command line names it.

use silhouette_compare::scene::BUILTIN;
use silhouette_core::load::OneLine;
use std::ffi::OsString;
use std::fmt;
use std::path::{Path, PathBuf};

/// A mesh as the command line names it. Displays on one line, what is no Unicode replaced.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum MeshArgument {
    /// A file. Its name need not be Unicode.
    File(PathBuf),
    /// `-`.
    StandardInput,
    /// `builtin:NAME`, by its name.
    Builtin(String),
}

impl MeshArgument {
    /// The path of a file.
    pub fn path(&self) -> Option<&Path> {
        match self {
            Self::File(path) => Some(path),
            Self::StandardInput | Self::Builtin(_) => None,
        }
    }

    /// The path of a file of a silhouette texture.
    pub fn texture(&self) -> Option<&Path> {
        let is_texture = |path: &&Path| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("siltex"));
        self.path().filter(is_texture)
    }
}

impl From<OsString> for MeshArgument {
    fn from(word: OsString) -> Self {
        match word.to_str() {
            Some("-") => Self::StandardInput,
            Some(text) => match text.strip_prefix(BUILTIN) {
                Some(name) => Self::Builtin(name.to_owned()),
                None => Self::File(word.into()),
            },
            None => Self::File(word.into()),
        }
    }
}

impl From<&str> for MeshArgument {
    fn from(word: &str) -> Self {
        OsString::from(word).into()
    }
}

impl fmt::Display for MeshArgument {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File(path) => OneLine(path).fmt(f),
            Self::StandardInput => f.write_str("standard input"),
            Self::Builtin(name) => write!(f, "{BUILTIN}{name}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_files_unless_they_say_otherwise() {
        assert_eq!(MeshArgument::from("builtin:torus"), MeshArgument::Builtin("torus".into()));
        assert_eq!(MeshArgument::from("-"), MeshArgument::StandardInput);
        assert_eq!(MeshArgument::from("./-").path(), Some(Path::new("./-")));
    }

    #[cfg(unix)]
    #[test]
    fn names_that_are_no_unicode_are_kept_and_shown() {
        use std::os::unix::ffi::OsStringExt as _;
        let word = OsString::from_vec(b"br\xfccke.obj".to_vec());
        let argument = MeshArgument::from(word.clone());
        assert_eq!(argument.path().map(Path::as_os_str), Some(word.as_os_str()));
        assert_eq!(argument.to_string(), "br\u{fffd}cke.obj");
    }
}
