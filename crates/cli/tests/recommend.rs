//! `recommend`: the answer, its cache, and what it refuses.

use serde_json::Value;
use silhouette_testing::gpu_or_skip;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn recommend(cache: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_silhouettes"));
    command.arg("recommend").args(arguments).env("XDG_CACHE_HOME", cache);
    command.output().unwrap()
}

fn json(cache: &Path, arguments: &[&str]) -> (Value, String) {
    let output = recommend(cache, &[arguments, &["--json"]].concat());
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{stderr}");
    (serde_json::from_slice(&output.stdout).unwrap(), stderr)
}

const LOOPS: [&str; 3] = ["builtin:torus", "--goal", "loops"];

#[test]
fn loops_are_recommended_with_a_promise_that_holds() {
    let folder = tempfile::tempdir().unwrap();
    let (answer, stderr) = json(folder.path(), &[&LOOPS[..], &["--check", "50", "--no-cache"]].concat());
    assert_eq!(stderr, "");
    let promise = &answer["chosen"]["promise"];
    assert_eq!((&answer["request"]["goal"], &promise["error"]), (&"loops".into(), &0.0.into()));
    assert!(promise["confidence"].as_f64().unwrap() > 0.95, "{promise}");
    // Whether times are kept is this machine's affair at this moment; that nothing is missed is not.
    assert_eq!((&answer["check"]["views"], &answer["check"]["within_error"]), (&50.into(), &50.into()));
    assert!(answer["chosen"]["preparation"]["cost"]["bytes"].as_u64().unwrap() > 0);
    assert_ne!(answer["runner_up"]["method"], answer["chosen"]["method"]);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0, "nothing is kept");
}

#[test]
fn a_second_question_is_answered_from_the_cache_and_a_damaged_cache_is_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let (first, _) = json(folder.path(), &LOOPS);
    let cached = folder.path().join("silhouettes/recommend");
    let file = fs::read_dir(&cached).unwrap().next().unwrap().unwrap().path();
    let (second, _) = json(folder.path(), &LOOPS);
    assert_eq!((&second["views_measured"], &second["chosen"]), (&0.into(), &first["chosen"]));

    fs::write(&file, "{\"key\": 1").unwrap();
    let (third, stderr) = json(folder.path(), &LOOPS);
    assert!(stderr.contains("note") && stderr.contains("measured anew") && stderr.lines().count() == 1, "{stderr}");
    assert!(third["views_measured"].as_u64().unwrap() > 0);
    assert!(serde_json::from_slice::<Value>(&fs::read(&file).unwrap()).is_ok());
    assert_eq!(fs::read_dir(&cached).unwrap().count(), 1);
}

#[test]
fn the_text_says_what_to_use_and_what_it_rests_on() {
    let folder = tempfile::tempdir().unwrap();
    let output = recommend(folder.path(), &[&LOOPS[..], &["--error", "missed_edges=0.5"]].concat());
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.starts_with("builtin:torus: loops with missed edges of at most 50 %\n"), "{text}");
    for label in ["  use ", "  promise ", "  costs ", "  builds ", "  runner-up ", "  one better ", "  measured "] {
        assert_eq!(text.lines().filter(|line| line.starts_with(label)).count(), 1, "{label}:\n{text}");
    }
}

/// A moebius band has no two sides, so that trackers refuse it; nothing extracts its loops in a millionth of a millisecond.
#[test]
fn where_nothing_fits_the_answer_says_so_and_names_who_refused() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["builtin:moebius:12,2", "--goal", "loops", "--max-ms", "0.000001", "--no-cache"];
    let output = recommend(folder.path(), &arguments);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success() && text.contains("nothing fits"), "{text}");
    assert!(
        text.lines().any(|line| line.contains("not tried") && line.contains("tracking") && line.contains("disagree")),
        "{text}"
    );
}

#[test]
fn pictures_are_recommended_in_the_time_that_is_given() {
    if gpu_or_skip("pictures_are_recommended_in_the_time_that_is_given").is_none() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for (goal, metric) in [("lines", "chamfer_px"), ("fill", "boundary_chamfer_px")] {
        let arguments = ["builtin:cube", "--goal", goal, "--size", "64", "--seconds", "3", "--no-cache"];
        let (answer, _) = json(folder.path(), &arguments);
        assert_eq!(answer["request"]["limit"]["metric"], metric);
        // However little a busy machine measures in that time, everything is accounted for.
        let [measured, left_out] = ["measured", "not_measured"].map(|list| answer[list].as_array().unwrap().len());
        assert!(measured + left_out > 20, "{answer}");
        assert_eq!(answer["chosen"].is_object(), measured > 0, "{answer}");
    }
}

#[test]
fn what_does_not_fit_is_refused_in_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let flat = folder.path().join("flat.obj");
    fs::write(&flat, "v 0 0 0\n").unwrap();
    let cases: [(&[&str], &str); 7] = [
        (&["builtin:torus", "--error", "soon"], "--error: 'soon' is not of the form NAME=MAX"),
        (&["builtin:torus", "--error", "psnr_db=3"], "--error: 'psnr_db' is no error of lines"),
        (&["builtin:torus", "--goal", "loops", "--error", "chamfer_px=3"], "missed_edges"),
        (&["builtin:torus", "--max-ms", "0"], "expected milliseconds, above 0"),
        (&["builtin:torus", "--seconds", "0"], "expected 0.1 to 86400 seconds"),
        (&["builtin:torus", "--goal", "loops", "--size", "8"], "--size: picture.width = 8 does not fit: 16 to 4096"),
        (&[flat.to_str().unwrap(), "--goal", "loops"], "flat.obj"),
    ];
    for (arguments, expected) in cases {
        let output = recommend(folder.path(), arguments);
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{stderr}");
        assert!(stderr.contains(expected) && stderr.lines().count() == 1, "{stderr}");
    }
}
