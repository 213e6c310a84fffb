//! Ctrl-C while a command works.
#![cfg(unix)]

use std::process::{Command, Stdio};
use std::time::Duration;

#[test]
fn an_interrupted_command_says_so_and_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let svg = folder.path().join("lines.svg");
    // A million faces: seconds of work, even on a fast machine.
    let mut command = Command::new(env!("CARGO_BIN_EXE_silhouettes"));
    command.args(["lines", "builtin:blob:1000000", "-o", svg.to_str().unwrap()]);
    let child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    std::thread::sleep(Duration::from_millis(500));
    let interrupted = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(interrupted.success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130));
    assert_eq!(
        String::from_utf8(output.stderr).unwrap(),
        "silhouettes: interrupted; what was in progress was not written\n"
    );
    assert_eq!(folder.path().read_dir().unwrap().count(), 0);
}
