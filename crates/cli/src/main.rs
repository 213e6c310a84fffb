//! The command `silhouettes`: its library with the methods of this workspace.

use silhouettes::Registry;
use std::process::ExitCode;

fn main() -> ExitCode {
    silhouettes::run(&Registry::builtin())
}
