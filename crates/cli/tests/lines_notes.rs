//! What `lines` says about drawings that will surprise.

use std::path::Path;
use std::process::Command;

/// What is said on standard error by a run that succeeds.
fn notes(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_silhouettes")).args(arguments).output().unwrap();
    let notes = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments:?}: {notes}");
    notes
}

fn obj(folder: &Path, name: &str, vertices: &[[f32; 3]], faces: &[&str]) -> String {
    let path = folder.join(name);
    let vertices: String = vertices.iter().map(|[x, y, z]| format!("v {x} {y} {z}\n")).collect();
    let faces: String = faces.iter().map(|face| format!("f {face}\n")).collect();
    std::fs::write(&path, vertices + &faces).unwrap();
    path.to_str().unwrap().to_owned()
}

const TENT: [[f32; 3]; 6] =
    [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 1.0], [0.0, 1.0, 1.0], [2.0, 0.0, 2.0], [0.0, 0.0, 2.0]];

#[test]
fn parts_wound_against_each_other_are_noted() {
    let folder = tempfile::tempdir().unwrap();
    let even = obj(folder.path(), "even.obj", &TENT, &["1 4 3 2", "4 6 5 3"]);
    let odd = obj(folder.path(), "odd.obj", &TENT, &["1 2 3 4", "4 6 5 3"]);
    assert_eq!(notes(&["lines", &even, "--creases", "30"]), "");
    let said = notes(&["lines", &even, &odd, "--creases", "30"]);
    assert!(said.contains("odd.obj: at 1 of 9 edges") && said.contains("--orient"), "{said}");
    assert_eq!(said.lines().count(), 1, "{said}");
}

#[test]
fn open_seams_are_noted_with_the_distance_that_closes_them() {
    let folder = tempfile::tempdir().unwrap();
    let mut vertices = [&TENT[..4], &[TENT[3], TENT[2], TENT[4], TENT[5]]].concat();
    let faces = ["1 4 3 2", "5 8 7 6"];
    let split = obj(folder.path(), "split.obj", &vertices, &faces);
    let said = notes(&["lines", &split]);
    assert!(said.contains("split.obj: 2 boundary edges") && said.contains("; --weld closes"), "{said}");
    assert_eq!(notes(&["lines", &split, "--weld"]), "");

    vertices[4][0] += 0.002;
    let near = obj(folder.path(), "near.obj", &vertices, &faces);
    let said = notes(&["lines", &near]);
    let weld = said.split_whitespace().find(|word| word.starts_with("--weld=")).unwrap_or_else(|| panic!("{said}"));
    assert_eq!(weld, "--weld=0.0021", "0.002 is a little more in 32 bits");
    assert_eq!(notes(&["lines", &near, weld]), "");

    vertices[4][0] += 0.2;
    let apart = obj(folder.path(), "apart.obj", &vertices, &faces);
    assert_eq!(notes(&["lines", &apart]), "", "two sheets with a gap between them");
}

#[test]
fn an_empty_picture_says_why() {
    for (arguments, words) in [
        (&["--eye", "0,0,9", "--target", "0,0,20"][..], &["behind the eye", "--eye"][..]),
        (&["--eye", "0,0,9", "--target", "30,0,0"], &["left of the picture"]),
        (&["--eye", "0.1,0,0"], &["none of the kinds", "--creases 30", "--all-edges", "--hidden"]),
        (&["--eye", "0.1,0,0", "--creases", "120", "--hidden"], &["none of the kinds", "; --all-edges may"]),
        (&["--min-length", "9000mm"], &["shorter than --min-length"]),
    ] {
        let command = [&["lines", "builtin:cube"], arguments].concat();
        let said = notes(&command);
        assert!(words.iter().all(|word| said.contains(word)), "{command:?}: {said}");
        assert_eq!(said.lines().count(), 1, "{said}");
    }
    let folder = tempfile::tempdir().unwrap();
    let json = folder.path().join("x.json");
    let said = notes(&["lines", "builtin:cube", "--eye", "0.1,0,0", "-o", json.to_str().unwrap()]);
    assert!(said.contains("no line lies in the view"), "{said}");
    assert_eq!(notes(&["lines", "builtin:cube", "-o", json.to_str().unwrap()]), "");
}
