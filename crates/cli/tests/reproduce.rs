//! `silhouettes reproduce`: its files, its table, what it refuses.

use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn reproduce(meshes: &[&str], output: &Path) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_silhouettes"));
    command.args(["reproduce", "tracking"]).args(meshes).arg("-o").arg(output).output().unwrap()
}

#[test]
fn tables_chart_and_page_of_built_in_meshes() {
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("deep/out");
    for meshes in [&["builtin:blob:600", "builtin:cube"][..], &["builtin:torus"]] {
        let output = reproduce(meshes, &target);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let table = String::from_utf8(output.stdout).unwrap();
        for mesh in meshes {
            assert!(table.contains(&format!("\n{mesh}: Performance (")), "{table}");
        }
        assert_eq!(table.matches("\ntracking, exact ").count(), meshes.len(), "{table}");
    }
    let rows = fs::read_to_string(target.join("tables.jsonl")).unwrap();
    let rows: Vec<Value> = rows.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let sheet = fs::read_to_string(target.join("tables.csv")).unwrap();
    assert!(sheet.starts_with("method,table,row,metric,unit,paper,ours,ratio,comparable,note\n"), "{sheet}");
    assert_eq!(sheet.lines().count(), rows.len() + 1, "a row for each figure");
    let find = |row: &str, metric: &str| {
        rows.iter().find(|figure| figure["row"] == row && figure["metric"] == metric).unwrap_or_else(|| panic!("{row}"))
    };
    assert!(find("builtin:torus, tracking, N = 0.1", "speed-up, counted")["ours"].as_f64().unwrap() >= 1.0);
    assert_eq!(find("builtin:torus, tracking, exact", "edges missed")["ours"], 0.0);
    let alien = find("Alien, tracking, N = 1", "speed-up, counted");
    assert_eq!((&alien["paper"], &alien["ours"], &alien["ratio"]), (&Value::from(3.54), &Value::Null, &Value::Null));
    assert_eq!(alien["comparable"], false);
    assert!(fs::read_to_string(target.join("trade.svg")).unwrap().contains("builtin:torus"));
    let page = fs::read_to_string(target.join("index.html")).unwrap();
    assert!(page.contains("builtin:torus") && !page.contains("builtin:cube"), "the first run is replaced");
    assert_eq!(fs::read_dir(target.parent().unwrap()).unwrap().count(), 1, "nothing is left beside it");
}

#[test]
fn names_of_papers_are_listed_where_one_is_unknown() {
    let output =
        Command::new(env!("CARGO_BIN_EXE_silhouettes")).args(["reproduce", "nonsense", "-o", "x"]).output().unwrap();
    let line = String::from_utf8(output.stderr).unwrap();
    assert_eq!((output.status.code(), line.lines().count()), (Some(2), 1), "{line}");
    assert!(["nonsense", "tracking", "image-precision", "all"].iter().all(|name| line.contains(name)), "{line}");
}

#[test]
fn what_cannot_be_reproduced_is_refused_in_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let theirs = folder.path().join("photos");
    fs::create_dir(&theirs).unwrap();
    fs::write(theirs.join("a.jpg"), "mine").unwrap();
    let new = folder.path().join("new");
    for (mesh, target, expected) in [
        ("builtin:cube", &theirs, "photos: exists and is no reproduction"),
        ("builtin:moebius", &new, "builtin:moebius: "),
        ("missing.obj", &new, "missing.obj"),
    ] {
        let output = reproduce(&[mesh], target);
        let line = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), line.lines().count()), (Some(2), 1), "{mesh}: {line}");
        assert!(line.contains(expected) && output.stdout.is_empty(), "wanted '{expected}' in: {line}");
    }
    assert_eq!(fs::read_to_string(theirs.join("a.jpg")).unwrap(), "mine");
    assert!(!new.exists());
}

#[test]
fn image_precision_has_its_own_tables_and_needs_an_adapter() {
    if std::env::var_os("SILHOUETTES_GPU").is_none() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("out");
    let run = |adapter: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_silhouettes"));
        command.args(["reproduce", "image-precision", "builtin:cube", "-o"]).arg(&target);
        command.env("SILHOUETTES_ADAPTER", adapter).output().unwrap()
    };
    let refused = run("quantum");
    let line = String::from_utf8(refused.stderr).unwrap();
    assert_eq!((refused.status.code(), line.lines().count()), (Some(2), 1), "{line}");
    assert!(line.contains("'quantum'") && !target.exists(), "{line}");
    let done = run("any");
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let table = String::from_utf8(done.stdout).unwrap();
    assert!(table.contains("\nbuiltin:cube: pictures (12 faces") && table.matches("\nscreen ").count() == 2, "{table}");
    let rows = fs::read_to_string(target.join("tables.jsonl")).unwrap();
    let rows: Vec<Value> = rows.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let missed = rows.iter().find(|row| row["row"] == "builtin:cube, screen" && row["metric"] == "missed at 1 px");
    assert_eq!(missed.unwrap()["ours"], 0.0);
    let printed = rows.iter().find(|row| row["row"] == "AMR (252000 triangles), wireframe").unwrap();
    assert!((printed["paper"].as_f64().unwrap() - 0.7).abs() < 1e-12 && printed["ours"].is_null(), "{printed}");
    assert_eq!((&printed["comparable"], &printed["ratio"]), (&Value::from(false), &Value::Null));
    assert!(fs::read_to_string(target.join("index.html")).unwrap().contains("builtin:cube"));
}
