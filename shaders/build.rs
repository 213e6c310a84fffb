//! Resolves the imports of every stage, validates it, and writes the list of stages that `src/lib.rs` includes.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "cargo reads both streams of a build script")]

#[path = "src/build/mod.rs"]
mod build;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    let root = folder("CARGO_MANIFEST_DIR")?;
    let out = folder("OUT_DIR")?;
    for folder in build::stages::folders(&root)? {
        println!("cargo::rerun-if-changed={folder}");
    }
    let stages = build::stages::collect(&root)?;
    for stage in &stages {
        let resolved = out.join(&stage.path);
        write(&resolved, &stage.text)?;
        build::validate::validate(&stage.path, &stage.text, &resolved.to_string_lossy())?;
    }
    write(&out.join("stages.rs"), &build::stages::rust_source(&stages))
}

/// The folder that an environment variable of cargo's names.
fn folder(variable: &str) -> Result<PathBuf, String> {
    std::env::var_os(variable).map(PathBuf::from).ok_or_else(|| format!("cargo sets {variable} for build scripts"))
}

/// Writes a file below the build script's `OUT_DIR`.
fn write(path: &Path, text: &str) -> Result<(), String> {
    let unwritable = |error: std::io::Error| format!("{}: {error}", path.display());
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(unwritable)?;
    }
    std::fs::write(path, text).map_err(unwritable)
}
