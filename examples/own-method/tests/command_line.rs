//! The method stands wherever those of the workspace do.

use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    let output = Command::new(env!("CARGO_BIN_EXE_own-method")).args(arguments).output().unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    output
}

#[test]
fn the_method_extracts_and_is_known_by_name() {
    let output = run(&["extract", "builtin:icosphere:3", "--method", "single-precision"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("\"method\":\"single-precision\"") && text.contains("\"edges\":[["), "{text}");
    let unknown = Command::new(env!("CARGO_BIN_EXE_own-method"))
        .args(["extract", "builtin:cube", "--method", "none"])
        .output()
        .unwrap();
    assert_eq!(unknown.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&unknown.stderr).contains("single-precision"), "listed with the others");
}

#[test]
fn the_report_of_a_comparison_holds_the_method() {
    let Some(_) = silhouette_testing::gpu_or_skip("the_report_of_a_comparison_holds_the_method") else {
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let report = folder.path().join("report");
    let methods = "brute-force,single-precision";
    run(&["compare", "builtin:torus", "--methods", methods, "-o", report.to_str().unwrap()]);
    let page = std::fs::read_to_string(report.join("index.html")).unwrap();
    assert!(page.contains("single-precision"), "the page names the method");
}
