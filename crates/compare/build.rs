//! Records which compiler and which commit the crate was built from, for the head of every result file.

use std::process::Command;

fn main() {
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    println!("cargo::rustc-env=SILHOUETTES_RUSTC={}", first_line(&rustc, &["--version"]));
    println!(
        "cargo::rustc-env=SILHOUETTES_COMMIT={}",
        first_line("git", &["describe", "--always", "--dirty", "--abbrev=12"])
    );
    println!("cargo::rerun-if-changed=build.rs");
    // Every commit adds a line to this log. Where there is none, as in a published package, there is no commit either.
    let log = first_line("git", &["rev-parse", "--git-path", "logs/HEAD"]);
    if !log.is_empty() {
        println!("cargo::rerun-if-changed={log}");
    }
}

/// First line that a program prints; empty where it fails.
fn first_line(program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).output().ok().filter(|output| output.status.success());
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned()).unwrap_or_default();
    text.lines().next().unwrap_or_default().trim().to_owned()
}
