//! Errors say their cause once: in their own text, or as their source, and never in both.

use crate::tidy::{root, sources};
use std::path::Path;

/// Places in `text` where an error's text holds the cause that its source yields again.
fn said_twice(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut message = String::new();
    let mut is_open = false;
    for line in text.lines().map(str::trim) {
        if line.starts_with("#[error(") {
            message.clear();
            is_open = true;
        }
        if is_open {
            message.push_str(line);
            is_open = !line.ends_with(")]");
            continue;
        }
        let is_source = line.contains("#[from]") || line.contains("#[source]");
        if (is_source && message.contains("{0}")) || message.contains("{source") {
            found.push(format!("{message} {line}"));
        }
        if line.ends_with(',') || line.ends_with('}') {
            message.clear();
        }
    }
    found
}

#[test]
fn no_error_prints_its_cause_twice() {
    let published = root().join("crates");
    let files = sources().into_iter().filter(|path| path.starts_with(&published));
    let mut errors = 0;
    for path in files {
        let text = std::fs::read_to_string(&path).unwrap();
        errors += text.matches("#[error(").count();
        assert_eq!(said_twice(&text), Vec::<String>::new(), "{}", path.display());
    }
    assert!(errors > 100, "only {errors} errors were looked at");
}

#[test]
fn a_cause_in_both_places_is_found() {
    for bad in [
        "#[error(\"cannot be read: {0}\")]\nIo(#[from] io::Error),",
        "#[error(\"{}: {source}\", path.display())]\nIo {\n    path: PathBuf,\n    source: io::Error,\n},",
        "#[error(\n    \"{place}: {0}\"\n)]\n/// What.\nIo(#[source] io::Error),",
    ] {
        assert!(!said_twice(bad).is_empty(), "{bad}");
    }
    for good in ["#[error(transparent)]\nIo(#[from] io::Error),", "#[error(\"not read\")]\nIo(#[source] io::Error),"] {
        assert!(said_twice(good).is_empty(), "{good}");
    }
}

#[test]
fn a_file_that_is_no_mesh_has_its_cause_in_its_text() {
    let error = silhouette_core::load::load(Path::new("no-such-file.obj")).unwrap_err();
    let (text, cause) = (error.to_string(), error.problem.to_string());
    assert!(text.contains(&cause), "{text}");
    assert!(std::error::Error::source(&error).is_none());
}
