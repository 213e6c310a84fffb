//! Ctrl-C while a command works: one line, and nothing that is not whole.
#![cfg(unix)]

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// How soon a command may end that was asked to: it is asked somewhere, and a slow machine is no failure.
const SOON: Duration = Duration::from_secs(20);

/// Interrupts a command after some time; yields its exit code and stderr. Fails where it goes on for long.
fn interrupted(words: &[&str], folder: &Path, after: Duration) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_silhouettes"));
    command.args(words).current_dir(folder).env("NODEVICE_SELECT", "1");
    let child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    std::thread::sleep(after);
    let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).stderr(Stdio::null()).status().unwrap();
    let asked = Instant::now();
    let output = child.wait_with_output().unwrap();
    assert!(asked.elapsed() < SOON, "{words:?} goes on");
    assert!(killed.success() || output.status.success(), "{words:?}");
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

/// Names of what a folder holds.
fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        folder.read_dir().unwrap().map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

const LARGE: &str = "builtin:blob:1000000";

/// Every command that writes one file, at several moments of its work: it leaves the whole file or none.
#[test]
fn an_interrupted_command_says_so_and_leaves_nothing() {
    let commands: [&[&str]; 8] = [
        &["lines", LARGE, "-o", "out.svg"],
        &["lines", "builtin:blob:200000", "--hidden", "dashed", "--intersections", "-o", "out.dxf"],
        &["extract", LARGE, "-o", "out.json"],
        &["extract", LARGE, "-o", "out.glb"],
        &["extract", LARGE, "--method", "cluster-cones", "-o", "out.svg"],
        &["smooth", "builtin:blob:200000", "-o", "out.obj"],
        &["render", LARGE, "--method", "tracking", "-o", "out.png"],
        &["bake", "builtin:blob:100000", "-o", "out.siltex"],
    ];
    let mut stopped = 0;
    for words in commands {
        for after in [100, 500, 1500] {
            let folder = tempfile::tempdir().unwrap();
            let (code, stderr) = interrupted(words, folder.path(), Duration::from_millis(after));
            let left = names(folder.path());
            match code {
                Some(130) => {
                    let last = stderr.lines().last().unwrap_or_default();
                    assert_eq!(last, "silhouettes: interrupted; what was in progress was not written", "{words:?}");
                    // A bake goes on from what it had, which is said by a file of its own.
                    let is_kept = |name: &String| words[0] == "bake" && name.contains("checkpoint");
                    let others: Vec<_> = left.into_iter().filter(|name| !is_kept(name)).collect();
                    assert_eq!(others, Vec::<String>::new(), "{words:?} after {after} ms");
                    stopped += 1;
                }
                Some(0) => assert_eq!(left, [*words.last().unwrap()], "{words:?}"),
                // Asked before it listened.
                None => assert_eq!(left, Vec::<String>::new(), "{words:?}"),
                other => panic!("{words:?}: exit code {other:?}, {stderr}"),
            }
        }
    }
    assert!(stopped >= commands.len(), "only {stopped} of {} were stopped", 3 * commands.len());
}

/// Commands that write folders: what is in them is whole, and no temporary file stays behind.
#[test]
fn an_interrupted_command_leaves_no_part_of_a_file() {
    let commands: [&[&str]; 4] = [
        &["compare", "builtin:blob:100000", "-o", "out"],
        &["reproduce", "tracking", "-o", "out"],
        &["score", LARGE, "--cameras", "-o", "out"],
        &["recommend", "builtin:blob:100000", "--goal", "loops", "--no-cache"],
    ];
    for words in commands {
        for after in [200, 1500] {
            let folder = tempfile::tempdir().unwrap();
            let (code, stderr) = interrupted(words, folder.path(), Duration::from_millis(after));
            assert!(matches!(code, Some(0 | 130) | None), "{words:?}: exit code {code:?}, {stderr}");
            let mut folders = vec![folder.path().to_owned()];
            while let Some(folder) = folders.pop() {
                for entry in folder.read_dir().unwrap() {
                    let path = entry.unwrap().path();
                    let name = path.file_name().unwrap().to_string_lossy().into_owned();
                    assert!(!name.ends_with(".part") && !name.starts_with(".tmp"), "{words:?} leaves {name}");
                    if path.is_dir() {
                        folders.push(path);
                    } else if name.ends_with(".json") {
                        let text = std::fs::read(&path).unwrap();
                        let parsed = serde_json::from_slice::<serde_json::Value>(&text);
                        assert!(parsed.is_ok(), "{words:?}: {name} is no whole document");
                    }
                }
            }
        }
    }
}
