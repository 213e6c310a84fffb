//! The program `silhouettes-viewer`: its library with the methods of this workspace.

use silhouette_compare::registry::Registry;
use std::process::ExitCode;

fn main() -> ExitCode {
    silhouette_viewer::run(&Registry::builtin())
}
