//! `compare` with scenes and sweeps of options, and what it refuses about them.

use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A scene of one mesh in small pictures.
const SCENE: &str = r#"
meshes = ["tetra.obj"]

[path]
kind = "orbit"
projection = "orthographic"
first-azimuth-deg = 20
elevation-deg = 25
swing-deg = 5
step-deg = 2
warm-up = 1
frames = 4
scored = 2

[picture]
width = 64
height = 48
samples = 1

[[methods]]
name = "brute-force"

[[methods]]
name = "tracking"
options = { concavity = [0, 0.5] }
"#;

const TETRAHEDRON: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

fn folder_with(scene: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    fs::write(&path, scene).unwrap();
    fs::write(folder.path().join("tetra.obj"), TETRAHEDRON).unwrap();
    (folder, path)
}

fn compare(scene: &Path, report: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_silhouettes"));
    command.arg("compare").arg("--scene").arg(scene).arg("-o").arg(report).args(arguments).output().unwrap()
}

/// The one line with which a scene or its overrides are refused.
fn refused(scene: &str, arguments: &[&str]) -> String {
    let (folder, path) = folder_with(scene);
    let output = compare(&path, &folder.path().join("report"), arguments);
    let line = String::from_utf8(output.stderr).unwrap();
    assert_eq!((output.status.code(), line.lines().count()), (Some(2), 1), "{line}");
    assert!(!folder.path().join("report").exists());
    line
}

#[test]
fn a_scene_and_a_sweep_of_options_become_one_cell_each() {
    if silhouette_testing::gpu_or_skip("a_scene_and_a_sweep_of_options_become_one_cell_each").is_none() {
        return;
    }
    let (folder, scene) = folder_with(SCENE);
    let report = folder.path().join("report");
    let output = compare(&scene, &report, &["--set", "tracking.concavity=0,0.25,1", "--set", "tracking.jump=0.5,1"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let cells = fs::read_to_string(report.join("results.jsonl")).unwrap();
    let cells: Vec<Value> = cells.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(cells.len(), 7);
    assert!(cells.iter().all(|cell| cell["mesh"]["name"] == "tetra.obj" && cell["frame"]["frames"] == 4));
    let table = fs::read_to_string(report.join("results.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 1 + 7 * 2, "a header and two scored frames per cell");
    let column = rows[0].iter().position(|name| *name == "tracking.concavity").unwrap();
    let levels: Vec<&str> = rows[1..].iter().step_by(2).map(|row| row[column]).collect();
    assert_eq!(levels, ["", "0", "0", "0.25", "0.25", "1", "1"]);
    let run: Value = serde_json::from_str(&fs::read_to_string(report.join("run.json")).unwrap()).unwrap();
    assert_eq!((&run["scene"]["name"], &run["scene"]["path"]["step-deg"]), (&"mine".into(), &2.0.into()));
}

#[test]
fn bad_scenes_are_refused_with_file_key_and_mend() {
    let changed = |from: &str, to: &str| {
        assert!(SCENE.contains(from), "{from}");
        let line = refused(&SCENE.replace(from, to), &[]);
        assert!(line.contains("mine.toml: "), "{line}");
        line
    };
    assert!(changed("swing-deg", "swing").contains("line 9: swing: unknown field `swing`, expected one of `kind`"));
    assert!(changed("frames = 4", "frames = 0").contains("path.frames = 0 does not fit: 1 to 100000"));
    assert!(
        changed("scored = 2", "scored = 5")
            .contains("path.scored = 5 does not fit: at least 1 and at most path.frames")
    );
    assert!(changed("width = 64", "width = 64000").contains("picture.width = 64000 does not fit: 16 to 4096"));
    assert!(changed("\"brute-force\"", "\"brute-farce\"").contains("there is no method 'brute-farce'; there are"));
    assert!(changed("concavity = [0, 0.5]", "level = 1").contains("tracking: there is no option 'level'"));
    assert!(changed("concavity = [0, 0.5]", "concavity = 9").contains("a number from 0 to 3.2 rad"));
    assert!(changed("meshes = [\"tetra.obj\"]", "").contains("meshes: none is listed"));
    assert!(changed("orthographic", "perspective").contains("give path.fov-deg as well"));
}

#[test]
fn bad_overrides_are_refused_by_their_name() {
    let line = |arguments: &[&str]| refused(SCENE, arguments);
    assert!(line(&["--set", "tracking"]).contains("METHOD.OPTION=VALUE[,VALUE...]"));
    assert!(line(&["--set", "randomized.seed=1"]).contains("name it in --methods"));
    assert!(line(&["--set", "tracking.concavity=0,0"]).contains("twice"));
    assert!(line(&["--methods", "none"]).contains("there is no method 'none'"));
    assert!(line(&["--profile", "quick"]).contains("--scene"));
}

/// For each scored frame the share of the pixels of a filled blob that differ from the truth.
fn xor_shares(arguments: &[&str]) -> Vec<f64> {
    let methods = SCENE.find("[[methods]]").unwrap();
    let (folder, scene) =
        folder_with(&SCENE[..methods].replace("tetra.obj", "builtin:blob:2000").replace("samples = 1", "samples = 4"));
    let report = folder.path().join("report");
    let output = compare(&scene, &report, &[&["--methods", "fine-mesh"], arguments].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let cell = fs::read_to_string(report.join("results.jsonl")).unwrap();
    let cell: Value = serde_json::from_str(&cell).unwrap();
    let views = cell["views"].as_array().unwrap();
    views.iter().map(|view| view["metrics"]["fill"]["xor_share"].as_f64().unwrap()).collect()
}

#[test]
fn a_simplified_mesh_is_measured_against_all_of_it() {
    if silhouette_testing::gpu_or_skip("a_simplified_mesh_is_measured_against_all_of_it").is_none() {
        return;
    }
    // The mesh against itself: what the samples of a pixel miss of its area.
    let full = xor_shares(&[]);
    assert!(full.iter().all(|&share| share < 0.02), "{full:?}");
    if cfg!(feature = "simplify") {
        let coarse = xor_shares(&["--simplify", "50"]);
        assert!(full.iter().zip(&coarse).all(|(full, coarse)| 2.0 * full < *coarse), "{full:?} {coarse:?}");
    }
}

#[test]
fn what_cannot_be_simplified_is_refused() {
    let few = refused(SCENE, &["--simplify", "3"]);
    let expected = if cfg!(feature = "simplify") {
        "tetra.obj: 3 faces cannot be reached, only 4"
    } else {
        "tetra.obj: this build does not simplify meshes; build it with the cargo feature `simplify`"
    };
    assert!(few.contains(expected), "{few}");
    let with_truth = SCENE.replace("\"tetra.obj\"", "{ mesh = \"tetra.obj\", truth = \"tetra.obj\" }");
    let both = refused(&with_truth, &["--simplify", "300"]);
    assert!(both.contains("--simplify 300: ") && both.contains("has a truth of its own"), "{both}");
    let none = SCENE.replace("\"tetra.obj\"", "{ mesh = \"tetra.obj\", simplify = 0 }");
    assert!(refused(&none, &[]).contains("meshes.simplify = 0 does not fit"));
}
