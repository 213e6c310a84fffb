//! Names of mesh files that are no Unicode, as old archives and foreign disks have them.
#![cfg(target_os = "linux")]

use silhouette_testing::gpu_or_skip;
use std::ffi::{OsStr, OsString};
use std::os::unix::ffi::OsStrExt as _;
use std::process::{Command, Output};

/// "brücke" in Latin-1.
const NAME: &[u8] = b"br\xfccke.obj";
const TETRAHEDRON: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

fn run(arguments: &[&OsStr]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_silhouettes")).args(arguments).output().unwrap()
}

#[test]
fn names_that_are_no_unicode() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = folder.path().join(OsStr::from_bytes(NAME));
    std::fs::write(&mesh, TETRAHEDRON).unwrap();
    let has_gpu = gpu_or_skip("names_that_are_no_unicode").is_some();
    let lines: &[(&str, bool)] = &[
        ("inspect MESH", false),
        ("inspect MESH --json", false),
        ("extract MESH", false),
        ("extract MESH -o OUT/edges.glb", false),
        ("lines MESH builtin:cube -o OUT/lines.svg", false),
        ("smooth MESH -o OUT/smooth.obj", false),
        ("render MESH -o OUT/lines.png --size 64", true),
        ("compare MESH --methods brute-force -o OUT/report", true),
    ];
    for &(line, needs_gpu) in lines {
        if needs_gpu && !has_gpu {
            continue;
        }
        let word = |word: &str| match word {
            "MESH" => mesh.clone().into_os_string(),
            word => OsString::from(word.replace("OUT", folder.path().to_str().unwrap())),
        };
        let words: Vec<OsString> = line.split(' ').map(word).collect();
        let output = run(&words.iter().map(OsString::as_os_str).collect::<Vec<_>>());
        assert!(output.status.success(), "{line}: {}", String::from_utf8_lossy(&output.stderr));
    }

    let missing = run(&["inspect".as_ref(), folder.path().join(OsStr::from_bytes(b"\xfc.obj")).as_os_str()]);
    let message = String::from_utf8(missing.stderr).unwrap();
    assert!(message.contains("\u{fffd}.obj: there is no such file") && message.lines().count() == 1, "{message}");
    let same = run(&["extract".as_ref(), mesh.as_os_str(), "-o".as_ref(), mesh.as_os_str()]);
    let message = String::from_utf8(same.stderr).unwrap();
    assert!(message.contains("is the input") && message.lines().count() == 1, "{message}");
}
