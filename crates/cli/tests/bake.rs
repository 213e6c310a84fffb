//! `silhouettes bake`, and `render` of what it writes.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::Duration;

/// A bake of a few seconds in the tests' build: 500 vertices are too many for textures of this size.
const SMALL: [&str; 6] = ["--set", "size=64", "--set", "azimuths=16", "--set", "hull-vertices=60"];

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_silhouettes"));
    command.args(arguments);
    command
}

fn run(arguments: &[&str]) -> Output {
    let output = command(arguments).output().unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    output
}

fn refused(arguments: &[&str]) -> String {
    let output = command(arguments).output().unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
    assert_eq!(message.lines().count(), 1, "{message}");
    message
}

fn bake<'a>(mesh: &'a str, path: &'a Path) -> Vec<&'a str> {
    [&["bake", mesh, "-o", path.to_str().unwrap()], &SMALL[..]].concat()
}

fn checkpoint(path: &Path) -> PathBuf {
    path.with_extension("siltex.checkpoint")
}

/// Killed five times, after different times, the same command leaves the file that one run leaves.
#[test]
fn a_bake_that_is_killed_goes_on_and_yields_the_same_file() {
    let folder = tempfile::tempdir().unwrap();
    let [whole, killed] = ["whole.siltex", "killed.siltex"].map(|name| folder.path().join(name));
    run(&bake("builtin:torus", &whole));
    let mut interrupted = 0;
    for wait_ms in [150, 260, 330, 410, 520] {
        let mut child = command(&bake("builtin:torus", &killed)).stderr(Stdio::null()).spawn().unwrap();
        std::thread::sleep(Duration::from_millis(wait_ms));
        let _ = child.kill();
        interrupted += u32::from(!child.wait().unwrap().success());
    }
    assert!(interrupted > 0, "finding the hull alone takes longer than the first wait");
    run(&bake("builtin:torus", &killed));
    let [whole, resumed] = [&whole, &killed].map(|path| std::fs::read(path).unwrap());
    assert_eq!(whole, resumed);
    let names: Vec<_> = folder.path().read_dir().unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(names.len(), 2, "checkpoints are removed: {names:?}");
}

#[test]
fn a_texture_is_drawn_by_the_methods_for_it_and_by_no_other() {
    let Some(_) = silhouette_testing::gpu_or_skip("a_texture_is_drawn_by_the_methods_for_it_and_by_no_other") else {
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let [texture, picture] = ["x.siltex", "x.png"].map(|name| folder.path().join(name));
    run(&bake("builtin:icosphere:3", &texture));
    let (texture, picture) = (texture.to_str().unwrap(), picture.to_str().unwrap());
    let drawn = |method: &str| {
        run(&["render", texture, "--method", method, "--size", "96x96", "-o", picture]);
        std::fs::read(picture).unwrap()
    };
    let pictures = ["texture", "texture-lines", "normal-map-hull"].map(drawn);
    assert!(pictures[0] != pictures[1] && pictures[0] != pictures[2]);
    let message = refused(&["render", texture, "--method", "fine-mesh", "-o", picture]);
    assert!(message.contains("x.siltex") && message.contains("normal-map-hull"), "{message}");
}

#[test]
fn what_cannot_be_baked_or_read_is_refused_in_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.siltex");
    let output = path.to_str().unwrap();
    let message = refused(&["bake", "builtin:torus", "-o", folder.path().join("x.obj").to_str().unwrap()]);
    assert!(message.contains(".siltex"), "{message}");
    let message = refused(&["bake", "builtin:torus", "--set", "size=16", "-o", output]);
    assert!(message.contains("builtin:torus") && message.contains("texels"), "{message}");
    // A cube of side 2 does not enclose a torus of radius 1 and more.
    let message = refused(&["bake", "builtin:torus", "--hull", "builtin:cube", "-o", output]);
    assert!(message.contains("builtin:cube"), "{message}");
    std::fs::write(&path, b"no texture").unwrap();
    let message =
        refused(&["render", output, "--method", "texture", "-o", folder.path().join("x.png").to_str().unwrap()]);
    assert!(message.contains("x.siltex"), "{message}");
    std::fs::write(checkpoint(&path), b"something of the user's own").unwrap();
    let message = refused(&bake("builtin:torus", &path));
    assert!(message.contains("x.siltex.checkpoint"), "{message}");
    assert_eq!(std::fs::read(checkpoint(&path)).unwrap(), b"something of the user's own");
}
