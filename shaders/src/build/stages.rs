//! Finds the stages among the WGSL files, and writes the Rust source that holds them.

use super::import::{Resolved, resolve};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::Path;

/// Folder of the parts that several crates use.
const SHARED: &str = "shared";

/// A WGSL file that no other file imports.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stage {
    /// Path below `shaders/`, with forward slashes: `render/fill.wgsl`.
    pub path: String,
    /// Its first comment paragraph, which becomes the documentation of its constant.
    pub summary: String,
    /// Its text with all imports in front.
    pub text: String,
}

impl Stage {
    /// Folder and file name without the extension.
    fn parts(&self) -> (&str, &str) {
        let path = self.path.strip_suffix(".wgsl").unwrap_or(&self.path);
        path.split_once('/').unwrap_or(("", path))
    }

    /// Name of its constant: that of the file, dots as underscores.
    fn constant(&self) -> String {
        self.parts().1.replace(['.', '/'], "_").to_uppercase()
    }
}

/// Names of the folders below `root` that hold WGSL files, sorted.
///
/// # Errors
/// The folder that cannot be read, and why.
pub fn folders(root: &Path) -> Result<Vec<String>, String> {
    let mut folders = Vec::new();
    for name in names(root)? {
        let folder = root.join(&name);
        if folder.is_dir() && names(&folder)?.iter().any(|file| file.ends_with(".wgsl")) {
            folders.push(name);
        }
    }
    Ok(folders)
}

/// Every stage below `root`, sorted by path.
///
/// # Errors
/// What is wrong and where: a file that cannot be read, an import that cannot be resolved, a shared file that no stage imports, a
/// stage that does not begin with a comment.
pub fn collect(root: &Path) -> Result<Vec<Stage>, String> {
    let read = |path: &str| std::fs::read_to_string(root.join(path)).map_err(|error| error.to_string());
    let mut files: Vec<(String, Resolved)> = Vec::new();
    for folder in folders(root)? {
        for name in names(&root.join(&folder))?.iter().filter(|name| name.ends_with(".wgsl")) {
            let path = format!("{folder}/{name}");
            let resolved = resolve(&path, &read).map_err(|error| error.to_string())?;
            files.push((path, resolved));
        }
    }
    let imported: BTreeSet<String> = files.iter().flat_map(|(_, resolved)| resolved.imports.clone()).collect();
    files.retain(|(path, _)| !imported.contains(path));
    files
        .into_iter()
        .map(|(path, resolved)| {
            if path.starts_with(SHARED) {
                return Err(format!("{path}: no stage imports this file"));
            }
            let summary = summary(&read(&path)?)
                .ok_or_else(|| format!("{path}: a stage begins with a comment that says what it does"))?;
            Ok(Stage { path, summary, text: resolved.text })
        })
        .collect()
}

/// Names of the entries of a folder, sorted.
fn names(folder: &Path) -> Result<Vec<String>, String> {
    let unreadable = |error: std::io::Error| format!("{}: {error}", folder.display());
    let mut names = Vec::new();
    for entry in folder.read_dir().map_err(unreadable)? {
        names.push(entry.map_err(unreadable)?.file_name().to_string_lossy().into_owned());
    }
    names.sort();
    Ok(names)
}

/// The first paragraph of the comment that a file begins with, in one line.
fn summary(text: &str) -> Option<String> {
    let lines = text.lines().map_while(|line| line.strip_prefix("// ")).map(str::trim);
    Some(lines.collect::<Vec<_>>().join(" ")).filter(|summary| !summary.is_empty())
}

/// Rust source of one module per folder with one constant per stage, and of `ALL`. The texts are included from files at the
/// stages' paths below the build script's `OUT_DIR`.
pub fn rust_source(stages: &[Stage]) -> String {
    let mut source = String::new();
    let mut all = String::new();
    let groups = stages.chunk_by(|a, b| a.parts().0 == b.parts().0);
    for group in groups {
        let folder = group[0].parts().0;
        // Writing to a string cannot fail.
        let _ = writeln!(source, "/// Stages of `silhouette-{}`.\npub mod {folder} {{", folder.replace('_', "-"));
        for stage in group {
            let (path, name) = (&stage.path, stage.constant());
            let _ = writeln!(source, "    /// {}", stage.summary);
            let _ =
                writeln!(source, "    pub const {name}: &str = include_str!(concat!(env!(\"OUT_DIR\"), \"/{path}\"));");
            let _ = writeln!(all, "    (\"{path}\", {folder}::{name}),");
        }
        source.push_str("}\n\n");
    }
    let _ = writeln!(
        source,
        "/// Every stage: its path below `shaders/`, and its text.\npub const ALL: &[(&str, &str)] = &[\n{all}];"
    );
    source
}

#[cfg(test)]
mod tests {
    use super::*;

    fn write(root: &Path, files: &[(&str, &str)]) {
        for (path, text) in files {
            let path = root.join(path);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        }
    }

    #[test]
    fn files_that_no_other_imports_are_the_stages() {
        let root = tempfile::tempdir().unwrap();
        let stage = "// Fills.\n// Twin: fill.rs\n//\n// More.\n\n#import \"shared/a.wgsl\"\nstage";
        write(
            root.path(),
            &[
                ("some_crate/fill.wgsl", stage),
                ("some_crate/fill.fast.wgsl", "// Faster.\n#import \"some_crate/part.wgsl\""),
                ("some_crate/part.wgsl", "part"),
                ("shared/a.wgsl", "a"),
                ("src/lib.rs", ""),
            ],
        );
        assert_eq!(folders(root.path()).unwrap(), ["shared", "some_crate"]);
        let stages = collect(root.path()).unwrap();
        let paths: Vec<&str> = stages.iter().map(|stage| stage.path.as_str()).collect();
        assert_eq!(paths, ["some_crate/fill.fast.wgsl", "some_crate/fill.wgsl"]);
        assert_eq!(stages[1].summary, "Fills. Twin: fill.rs");
        assert!(stages[1].text.starts_with("a\n// Fills.") && !stages[1].text.contains("#import"));

        let source = rust_source(&stages);
        for expected in [
            "/// Stages of `silhouette-some-crate`.\npub mod some_crate {",
            "    /// Faster.\n    pub const FILL_FAST: &str = include_str!(",
            "    (\"some_crate/fill.wgsl\", some_crate::FILL),\n",
        ] {
            assert!(source.contains(expected), "{expected} in {source}");
        }
    }

    #[test]
    fn files_that_are_of_no_use_are_refused() {
        let root = tempfile::tempdir().unwrap();
        write(root.path(), &[("shared/a.wgsl", "// A part.")]);
        assert_eq!(collect(root.path()).unwrap_err(), "shared/a.wgsl: no stage imports this file");
        write(root.path(), &[("some_crate/a.wgsl", "#import \"shared/a.wgsl\"\n")]);
        assert!(collect(root.path()).unwrap_err().contains("begins with a comment"));
        write(root.path(), &[("some_crate/a.wgsl", "// A stage.\n#import \"shared/b.wgsl\"\n")]);
        assert!(collect(root.path()).unwrap_err().starts_with("some_crate/a.wgsl:2: cannot import \"shared/b.wgsl\""));
    }
}
