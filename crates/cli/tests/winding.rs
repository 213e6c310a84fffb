//! Meshes that are wound inside out, and `--orient`.

use silhouette_testing::gpu_or_skip;
use std::path::Path;
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    let output = Command::new(env!("CARGO_BIN_EXE_silhouettes")).args(arguments).output().unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    output
}

fn notes(output: &Output) -> String {
    let lines = std::str::from_utf8(&output.stderr).unwrap().lines();
    lines.filter(|line| line.starts_with("silhouettes: note: ")).collect()
}

/// A cube that is inside out, and beside it one that is not.
fn write_cubes(path: &Path) {
    let corner =
        |cube: u32, at: u32| [f64::from(at & 1) + 3.0 * f64::from(cube), f64::from(at >> 1 & 1), f64::from(at >> 2)];
    let mut obj = String::new();
    for cube in 0..2 {
        for at in 0..8 {
            let [x, y, z] = corner(cube, at);
            obj += &format!("v {x} {y} {z}\n");
        }
    }
    let quads = [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]];
    for [a, b, c, d] in quads {
        obj += &format!("f {d} {c} {b} {a}\nf {} {} {} {}\n", a + 8, b + 8, c + 8, d + 8);
    }
    std::fs::write(path, obj).unwrap();
}

#[test]
fn inside_out_parts_are_noted_where_it_matters_and_turned_on_demand() {
    let folder = tempfile::tempdir().unwrap();
    let [mesh, svg] = ["cubes.obj", "lines.svg"].map(|name| folder.path().join(name));
    write_cubes(&mesh);
    let [mesh, svg] = [&mesh, &svg].map(|path| path.to_str().unwrap());

    let text = String::from_utf8(run(&["inspect", mesh]).stdout).unwrap();
    assert!(
        text.contains("12 of 24 faces; --orient, of the commands that draw, turns them")
            && text.contains("no other defects"),
        "{text}"
    );
    let turned = notes(&run(&["lines", mesh, "--orient", "-o", svg]));
    assert!(turned.contains("12 of 24 faces were turned"), "{turned}");
    assert_eq!(notes(&run(&["lines", mesh, "-o", svg])), "", "lines are right either way");
    if gpu_or_skip("inside_out_parts_are_noted_where_it_matters_and_turned_on_demand").is_some() {
        let png = folder.path().join("lines.png");
        let png = png.to_str().unwrap();
        let noted = notes(&run(&["render", mesh, "--method", "image-precision", "-o", png]));
        assert!(noted.contains("12 of 24 faces are in parts") && noted.contains("--orient"), "{noted}");
        assert_eq!(notes(&run(&["render", mesh, "--method", "brute-force", "-o", png])), "");
    }
    assert_eq!(notes(&run(&["extract", mesh])), "", "the same edges are silhouettes either way");
    assert_eq!(notes(&run(&["lines", "builtin:torus", "--orient", "-o", svg])), "", "nothing to turn");

    let glb = folder.path().join("turned.glb");
    let glb = glb.to_str().unwrap();
    run(&["extract", mesh, "--orient", "-o", glb]);
    let text = String::from_utf8(run(&["inspect", glb]).stdout).unwrap();
    assert!(!text.contains("inside out") && text.contains("24"), "{text}");
}

/// A hollow cube: the wall of its cavity points into it, and stays so.
#[test]
fn walls_of_cavities_are_right_as_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let [mesh, glb] = ["hollow.obj", "kept.glb"].map(|name| folder.path().join(name).to_str().unwrap().to_owned());
    let quads = [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]];
    let mut obj = String::new();
    for size in [3.0, 1.0] {
        for at in 0..8 {
            let [x, y, z] = [at & 1, at >> 1 & 1, at >> 2].map(|side| size * (f64::from(side) - 0.5));
            obj += &format!("v {x} {y} {z}\n");
        }
    }
    for [a, b, c, d] in quads {
        obj += &format!("f {a} {b} {c} {d}\nf {} {} {} {}\n", d + 8, c + 8, b + 8, a + 8);
    }
    std::fs::write(&mesh, &obj).unwrap();
    let text = String::from_utf8(run(&["inspect", &mesh]).stdout).unwrap();
    assert!(text.contains("no defects") && text.contains("cavities         1"), "{text}");
    assert!(text.contains("negative volume  1 of them: -1 (face 2)"), "{text}");
    assert_eq!(notes(&run(&["extract", &mesh, "--orient", "-o", &glb])), "", "nothing to turn");

    // The same, all of it inside out.
    let turned = obj.lines().map(|line| match line.strip_prefix("f ") {
        Some(corners) => format!("f {}\n", corners.split(' ').rev().collect::<Vec<_>>().join(" ")),
        None => format!("{line}\n"),
    });
    std::fs::write(&mesh, turned.collect::<String>()).unwrap();
    let noted = notes(&run(&["extract", &mesh, "--orient", "-o", &glb]));
    assert!(noted.contains("24 of 24 faces were turned"), "{noted}");
    let text = String::from_utf8(run(&["inspect", &glb]).stdout).unwrap();
    assert!(text.contains("no defects") && text.contains("cavities         1"), "{text}");
}
