//! Records which compiler and which commit the crate was built from, for the head of every result file.

use std::path::Path;
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    println!("cargo::rustc-env=SILHOUETTES_RUSTC={}", first_line(&rustc, &["--version"]));
    println!("cargo::rustc-env=SILHOUETTES_COMMIT={}", commit());
}

/// The commit, with `-dirty` where the tree has changes. Empty for a published package, which may lie inside of somebody
/// else's repository: only this workspace's own counts.
fn commit() -> String {
    if !Path::new("../../.git").exists() {
        return String::new();
    }
    // Every commit adds a line to this log.
    println!("cargo::rerun-if-changed={}", first_line("git", &["rev-parse", "--git-path", "logs/HEAD"]));
    first_line("git", &["describe", "--always", "--dirty", "--abbrev=12"])
}

/// First line that a program prints; empty where it fails.
fn first_line(program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).output().ok().filter(|output| output.status.success());
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned()).unwrap_or_default();
    text.lines().next().unwrap_or_default().trim().to_owned()
}
