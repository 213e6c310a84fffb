//! `silhouettes methods`: what methods say of themselves.

use serde_json::Value;
use std::process::{Command, Output};

fn methods(words: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_silhouettes")).arg("methods").args(words).output().unwrap()
}

fn text(words: &[&str]) -> String {
    let output = methods(words);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn every_method_is_listed_with_when_to_choose_it() {
    let list = text(&[]);
    let rows: Vec<Value> = serde_json::from_str(&text(&["--json"])).unwrap();
    assert!(rows.len() > 20);
    for row in &rows {
        let said = |key: &str| row["guide"][key].as_str().unwrap();
        let paragraph = format!(
            "{}\n  yields {}\n  choose it when {}\n",
            row["name"].as_str().unwrap(),
            said("yields"),
            said("choose_when")
        );
        assert!(list.contains(&paragraph), "{paragraph}");
    }
    assert_eq!(list.matches("choose it when").count(), rows.len());
}

#[test]
fn one_method_in_full_with_its_options() {
    let full = text(&["image-precision"]);
    for expected in ["Raskar", "\n  needs           triangles\n", "where it fails", "\n  variant ", "screen", "px"] {
        assert!(full.contains(expected), "{expected} is not in {full}");
    }
    let plain = text(&["brute-force"]);
    assert!(plain.contains("needs           topology") && !plain.contains("option"), "{plain}");
    let row: Vec<Value> = serde_json::from_str(&text(&["brute-force", "--json"])).unwrap();
    assert_eq!((row.len(), &row[0]["capabilities"]["loops"]), (1, &Value::Bool(true)));
}

#[test]
fn an_unknown_method_is_answered_with_the_known_ones() {
    let output = methods(&["brute-farce"]);
    let line = String::from_utf8(output.stderr).unwrap();
    assert_eq!((output.status.code(), line.lines().count()), (Some(2), 1), "{line}");
    assert!(line.contains("brute-farce") && line.contains("tracking-exact"), "{line}");
}

#[test]
fn help_of_commands_names_the_methods_that_fit() {
    let output = Command::new(env!("CARGO_BIN_EXE_silhouettes")).args(["render", "--help"]).output().unwrap();
    let help = String::from_utf8(output.stdout).unwrap();
    assert!(help.contains("gbuffer-filter") && !help.contains("interpolated-contours"), "{help}");
}
