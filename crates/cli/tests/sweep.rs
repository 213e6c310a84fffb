//! Comparisons in shards, merged; and what is kept of one that was interrupted.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::SystemTime;

fn compare(arguments: &[&str], output: &Path) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_silhouettes"));
    for variable in ["SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT"] {
        command.env_remove(variable);
    }
    let methods = ["--methods", "brute-force,tracking,fine-mesh", "--set", "tracking.concavity=0,1"];
    command.args(["compare", "builtin:cube", "builtin:gear"]).args(methods).args(arguments);
    command.arg("-o").arg(output).output().unwrap()
}

fn succeeded(output: &Output) {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// Rows of a table, without columns that hold times, bytes or counts of work.
fn accuracy(report: &Path) -> Vec<BTreeMap<String, String>> {
    let text = fs::read_to_string(report.join("results.csv")).unwrap();
    let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    let columns = lines.next().unwrap();
    let is_cost = |column: &str| column.ends_with("_ms") || column.contains("bytes");
    let row = |values: Vec<String>| {
        assert_eq!(values.len(), columns.len());
        columns.iter().cloned().zip(values).filter(|(column, _)| !is_cost(column)).collect()
    };
    lines.map(row).collect()
}

fn written(folder: &Path) -> BTreeMap<PathBuf, SystemTime> {
    let time = |path: PathBuf| (path.clone(), path.metadata().unwrap().modified().unwrap());
    folder.read_dir().unwrap().map(|entry| time(entry.unwrap().path())).collect()
}

#[test]
fn shards_merged_are_worth_what_one_process_yields() {
    if silhouette_testing::gpu_or_skip("shards_merged_are_worth_what_one_process_yields").is_none() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    succeeded(&compare(&[], &at("whole")));
    let beside = folder.path().read_dir().unwrap().count();
    assert_eq!(beside, 1, "finished cells are removed once the report is there");

    for shard in ["1/3", "2/3"] {
        succeeded(&compare(&["--shard", shard], &at("shared")));
    }
    let merge = |cells: &[&str], output: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_silhouettes"));
        command.arg("merge").args(cells.iter().map(|name| at(name))).arg("-o").arg(at(output)).output().unwrap()
    };
    let too_early = merge(&["shared"], "early");
    let line = String::from_utf8(too_early.stderr).unwrap();
    assert_eq!((too_early.status.code(), line.lines().count()), (Some(2), 1), "{line}");
    assert!(line.contains("cells are missing, 2 of 8") && !at("early").exists(), "{line}");

    succeeded(&compare(&["--shard", "3/3"], &at("own")));
    succeeded(&merge(&["shared", "own"], "merged"));
    let (merged, whole) = (accuracy(&at("merged")), accuracy(&at("whole")));
    assert_eq!(merged, whole);
    assert!(merged.len() >= 8 && merged.iter().any(|row| row["method"] == "fine-mesh"));

    // What is there is not measured again.
    let before = written(&at("shared"));
    succeeded(&compare(&["--shard", "2/3"], &at("shared")));
    assert_eq!(written(&at("shared")), before);
    // Cells of another comparison do not mix with it.
    let other = compare(&["--shard", "2/3", "--set", "tracking.jump=1"], &at("shared"));
    let line = String::from_utf8(other.stderr).unwrap();
    assert!(other.status.code() == Some(2) && line.contains("another comparison"), "{line}");
    assert_eq!(written(&at("shared")), before);
}

#[test]
fn what_is_no_shard_or_no_cells_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    for shard in ["0/2", "3/2", "x", "1"] {
        let output = compare(&["--shard", shard], &folder.path().join("out"));
        let line = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), line.lines().count()), (Some(2), 1), "{line}");
        assert!(line.contains("1/4 to 4/4"), "{line}");
    }
    let mut merge = Command::new(env!("CARGO_BIN_EXE_silhouettes"));
    let output = merge.arg("merge").arg(folder.path()).arg("-o").arg(folder.path().join("out")).output().unwrap();
    let line = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(2) && line.contains("holds no cells"), "{line}");
}

/// What a run says of its scene, as a scene file whose meshes are named elsewhere.
fn scene_of(report: &Path) -> String {
    let run: serde_json::Value = serde_json::from_slice(&fs::read(report.join("run.json")).unwrap()).unwrap();
    let mut scene = run["scene"].clone();
    scene.as_object_mut().unwrap().remove("name");
    toml::to_string(&scene).unwrap()
}

#[test]
fn a_refined_sweep_is_a_scene_that_can_be_repeated() {
    if silhouette_testing::gpu_or_skip("a_refined_sweep_is_a_scene_that_can_be_repeated").is_none() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let run = |arguments: &[&str], output: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_silhouettes"));
        command.args(["compare", "builtin:gear"]).args(arguments).arg("-o").arg(at(output)).output().unwrap()
    };
    let methods = ["--methods", "brute-force,fine-mesh,pn-triangles"];
    let sweeps = ["--sweep", "pn-triangles.level=2", "--sweep", "tracking.concavity=2"];
    let refused = run(&[&methods[..], &sweeps[..]].concat(), "refused");
    let line = String::from_utf8(refused.stderr).unwrap();
    assert!(refused.status.code() == Some(2) && line.contains("name it in --methods"), "{line}");

    // An error that few frames change; time enough to halve a few gaps.
    let refined = run(&[&methods[..], &sweeps[..2], &["--budget", "20", "--error", "xor_share"]].concat(), "refined");
    succeeded(&refined);
    let rows = accuracy(&at("refined"));
    let mut levels: Vec<String> = rows.iter().map(|row| row["pn-triangles.level"].clone()).collect();
    levels.sort_unstable();
    levels.dedup();
    assert!(["0", "3", "7"].iter().all(|level| levels.contains(&(*level).to_owned())), "{levels:?}");
    let left: Vec<_> = folder.path().read_dir().unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left, ["refined"], "finished cells are removed once the report is there");

    fs::write(at("scene.toml"), scene_of(&at("refined"))).unwrap();
    let repeated = run(&["--scene", at("scene.toml").to_str().unwrap()], "repeated");
    succeeded(&repeated);
    assert_eq!(accuracy(&at("repeated")), rows);
}

#[test]
fn what_cannot_be_swept_or_refined_is_refused_in_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |arguments: &[&str], expected: &str| {
        let output = compare(arguments, &folder.path().join("out"));
        let line = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(2) && line.contains(expected), "{arguments:?}: {line}");
    };
    refused(&["--sweep", "tracking.jump"], "tracking.jump has no sweep; there are concavity");
    refused(&["--sweep", "tracking"], "METHOD.OPTION[=N]");
    refused(&["--budget", "0"], "seconds above 0");
    refused(&["--budget", "5", "--error", "width_mean_px"], "chamfer_px");
    refused(&["--error", "chamfer_px"], "--budget");
    refused(&["--budget", "5", "--shard", "1/2"], "--shard");
    refused(&["--passes", "0"], "path.passes = 0");
    assert!(folder.path().read_dir().unwrap().next().is_none());
}
