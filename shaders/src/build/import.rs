//! Replaces `#import` directives by the text of the files that they name.

use std::fmt;

/// Why a stage has no text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ImportError {
    /// A file cannot be read.
    Unreadable {
        /// The file and the line that imports it; `None` for the stage itself.
        imported_at: Option<String>,
        /// Path of the file below `shaders/`.
        path: String,
        /// What the file system reports.
        reason: String,
    },
    /// A line begins with `#import` but is not a directive.
    Malformed {
        /// The file and the line.
        at: String,
        /// The line.
        line: String,
    },
    /// Files import each other.
    Circle {
        /// The files from the first import on; the last one is a repeated one.
        chain: Vec<String>,
    },
}

impl fmt::Display for ImportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreadable { imported_at: Some(at), path, reason } => {
                write!(f, "{at}: cannot import \"{path}\": {reason}; paths are relative to shaders/")
            }
            Self::Unreadable { imported_at: None, path, reason } => write!(f, "cannot read {path}: {reason}"),
            Self::Malformed { at, line } => {
                write!(f, "{at}: `{line}` is not an import; write #import \"folder/file.wgsl\" alone on its line")
            }
            Self::Circle { chain } => write!(f, "imports form a circle: {}", chain.join(" -> ")),
        }
    }
}

impl std::error::Error for ImportError {}

/// A text with all of its imports in front.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Resolved {
    /// The text: each imported file once, in order of first import, files that a file imports before the file itself.
    pub text: String,
    /// Paths of the imported files in that order, without the file that was resolved.
    pub imports: Vec<String>,
}

/// The text of the file at `path` with its imports in front; `read` yields the text of a file by its path below `shaders/`.
///
/// # Errors
/// [`ImportError`] with the file and the line.
pub fn resolve(path: &str, read: &dyn Fn(&str) -> Result<String, String>) -> Result<Resolved, ImportError> {
    let mut resolved = Resolved::default();
    include(path, None, &mut Vec::new(), read, &mut resolved)?;
    resolved.imports.pop();
    Ok(resolved)
}

/// Appends a file after what it imports. `chain` holds the files that are being included, the stage first.
fn include(
    path: &str,
    imported_at: Option<&str>,
    chain: &mut Vec<String>,
    read: &dyn Fn(&str) -> Result<String, String>,
    resolved: &mut Resolved,
) -> Result<(), ImportError> {
    let is_repeated = chain.iter().any(|open| open == path);
    chain.push(path.to_owned());
    if is_repeated {
        return Err(ImportError::Circle { chain: std::mem::take(chain) });
    }
    let text = read(path).map_err(|reason| ImportError::Unreadable {
        imported_at: imported_at.map(str::to_owned),
        path: path.to_owned(),
        reason,
    })?;
    let mut own = String::new();
    for (number, line) in (1..).zip(text.lines()) {
        if !line.trim_start().starts_with("#import") {
            own.push_str(line);
            own.push('\n');
            continue;
        }
        let at = format!("{path}:{number}");
        let Some(part) = imported_path(line) else {
            return Err(ImportError::Malformed { at, line: line.to_owned() });
        };
        if !resolved.imports.iter().any(|included| included == part) {
            include(part, Some(&at), chain, read, resolved)?;
        }
    }
    chain.pop();
    resolved.text.push_str(&own);
    resolved.imports.push(path.to_owned());
    Ok(())
}

/// The path of a directive `#import "path"`; `None` where the line is anything else.
fn imported_path(line: &str) -> Option<&str> {
    let path = line.strip_prefix("#import \"")?.trim_end().strip_suffix('"')?;
    let is_below_shaders = !path.starts_with('/') && path.split('/').all(|part| !part.is_empty() && part != "..");
    (is_below_shaders && !path.contains(['"', '\\'])).then_some(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn resolve_in(files: &[(&str, &str)], path: &str) -> Result<Resolved, ImportError> {
        resolve(path, &|path| {
            let found = files.iter().find(|(name, _)| *name == path);
            found.map(|(_, text)| (*text).to_owned()).ok_or_else(|| "no such file".to_owned())
        })
    }

    #[test]
    fn a_part_that_is_imported_twice_is_included_once_before_what_needs_it() {
        let files = [
            ("stage.wgsl", "// stage\n#import \"a.wgsl\"\n#import \"b.wgsl\"\n#import \"a.wgsl\"\nstage"),
            ("a.wgsl", "#import \"c.wgsl\"\na"),
            ("b.wgsl", "#import \"c.wgsl\"\nb"),
            ("c.wgsl", "c"),
        ];
        let resolved = resolve_in(&files, "stage.wgsl").unwrap();
        assert_eq!(resolved.text, "c\na\nb\n// stage\nstage\n");
        assert_eq!(resolved.imports, ["c.wgsl", "a.wgsl", "b.wgsl"]);
    }

    #[test]
    fn a_circle_is_refused_with_its_chain() {
        let files = [
            ("stage.wgsl", "#import \"a.wgsl\""),
            ("a.wgsl", "#import \"b.wgsl\""),
            ("b.wgsl", "#import \"a.wgsl\""),
            ("own.wgsl", "#import \"own.wgsl\""),
        ];
        let message = resolve_in(&files, "stage.wgsl").unwrap_err().to_string();
        assert_eq!(message, "imports form a circle: stage.wgsl -> a.wgsl -> b.wgsl -> a.wgsl");
        let message = resolve_in(&files, "own.wgsl").unwrap_err().to_string();
        assert_eq!(message, "imports form a circle: own.wgsl -> own.wgsl");
    }

    #[test]
    fn a_missing_file_is_reported_with_the_line_that_imports_it() {
        let files = [("stage.wgsl", "// stage\n#import \"folder/none.wgsl\"")];
        let message = resolve_in(&files, "stage.wgsl").unwrap_err().to_string();
        let expected = "stage.wgsl:2: cannot import \"folder/none.wgsl\": no such file; paths are relative to shaders/";
        assert_eq!(message, expected);
        assert_eq!(resolve_in(&[], "x.wgsl").unwrap_err().to_string(), "cannot read x.wgsl: no such file");
    }

    #[test]
    fn a_line_that_is_almost_an_import_is_refused() {
        for line in
            ["#import a.wgsl", "#import \"a.wgsl", "  #import \"a.wgsl\"", "#import \"../a.wgsl\"", "#import \"\""]
        {
            let text = format!("\n{line}");
            let files = [("stage.wgsl", text.as_str()), ("a.wgsl", "a")];
            let error = resolve_in(&files, "stage.wgsl").unwrap_err();
            let malformed = ImportError::Malformed { at: "stage.wgsl:2".to_owned(), line: line.to_owned() };
            assert_eq!(error, malformed);
        }
    }
}
