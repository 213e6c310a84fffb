//! The program itself, where it cannot open a window: one clear line, and the exit code of the command line.

use silhouette_testing::skipped;
use std::process::{Command, Output};

/// The program without a display, with `more` in its environment.
fn without_display(words: &[&str], more: &[(&str, &str)]) -> Output {
    let mut program = Command::new(env!("CARGO_BIN_EXE_silhouettes-viewer"));
    program.args(words).env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").env_remove("WAYLAND_SOCKET");
    program.env("NODEVICE_SELECT", "1").env_remove("SILHOUETTES_ADAPTER").envs(more.iter().copied());
    program.output().unwrap()
}

/// What it prints on stderr, and its exit code.
fn failure(words: &[&str], more: &[(&str, &str)]) -> (String, Option<i32>) {
    let output = without_display(words, more);
    assert!(output.stdout.is_empty(), "{}", String::from_utf8_lossy(&output.stdout));
    (String::from_utf8(output.stderr).unwrap(), output.status.code())
}

#[test]
fn an_adapter_that_is_not_there_is_one_line() {
    // A loader that is given no driver finds no adapter; other systems draw without it.
    if !cfg!(target_os = "linux") {
        return skipped("an_adapter_that_is_not_there_is_one_line", "this system's adapters are not Vulkan's");
    }
    let nothing = [("VK_DRIVER_FILES", "/nonexistent.json"), ("VK_ICD_FILENAMES", "/nonexistent.json")];
    let (line, code) = failure(&["builtin:torus"], &nothing);
    assert!(line.lines().count() == 1 && line.starts_with("silhouettes-viewer: "), "{line}");
    assert!(line.contains("adapter") && line.contains("Vulkan"), "{line}");
    // As of every command: what was asked for is right, and the run fails.
    assert_eq!(code, Some(1), "{line}");
}

#[test]
fn a_choice_of_an_adapter_that_does_not_fit_is_one_line() {
    let (line, code) = failure(&["builtin:torus"], &[("SILHOUETTES_ADAPTER", "fastest")]);
    assert!(line.lines().count() == 1 && line.contains("SILHOUETTES_ADAPTER") && line.contains("fastest"), "{line}");
    assert_eq!(code, Some(2), "{line}");
}

#[test]
fn arguments_that_do_not_fit_are_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("broken.toml");
    std::fs::write(&file, "meshes = 3\n").unwrap();
    let scene = file.to_str().unwrap();
    for (words, expected) in [
        (&["--scene", scene][..], scene),
        (&["--scene", "missing.toml"], "missing.toml"),
        (&["--measure", "5"], "name a mesh"),
        (&["builtin:torus", "--measure", "0"], "--measure"),
        (&["builtin:torus", "--view", "inside"], "--view"),
        (&["builtin:torus", "--methods", "tracking"], "--methods"),
    ] {
        let (line, code) = failure(words, &[]);
        assert!(line.lines().count() == 1 && line.contains(expected), "{words:?}: {line}");
        assert_eq!(code, Some(2), "{line}");
    }
}
