//! What a published crate has to have: a front page that opens with an example, licences, and a description of its own.

use crate::tidy::cargo;
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::PathBuf;

/// The packages that are published, as cargo describes them.
fn published() -> Vec<Value> {
    let metadata = cargo(&["metadata", "--no-deps", "--format-version=1"]);
    let metadata: Value = serde_json::from_str(&metadata).unwrap();
    let packages = metadata["packages"].as_array().unwrap();
    packages.iter().filter(|package| package["publish"].is_null()).cloned().collect()
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap()
}

/// What is wrong with a front page.
fn faults_of_page(name: &str, page: &str) -> Vec<String> {
    let mut faults = Vec::new();
    if !page.starts_with(&format!("# {name}\n")) {
        faults.push(format!("{name}: its page does not begin with its name"));
    }
    match page.lines().position(|line| line.starts_with("```rust")) {
        None => faults.push(format!("{name}: its page has no example")),
        Some(line) if line > 20 => faults.push(format!("{name}: its page opens with {line} lines without an example")),
        Some(_) => {}
    }
    // Lines that rustdoc hides stand in the page as text elsewhere.
    if page.lines().any(|line| line == "#" || line.starts_with("# ") && line != format!("# {name}")) {
        faults.push(format!("{name}: its example has hidden lines"));
    }
    faults
}

#[test]
fn every_crate_has_a_front_page_and_licences() {
    let packages = published();
    assert!(packages.len() >= 16, "{} packages", packages.len());
    let mut faults = Vec::new();
    for package in &packages {
        let name = text(&package["name"]);
        let folder = PathBuf::from(text(&package["manifest_path"])).parent().unwrap().to_owned();
        let page = std::fs::read_to_string(folder.join("README.md")).unwrap_or_default();
        faults.extend(faults_of_page(name, &page));
        for licence in ["LICENSE-MIT", "LICENSE-APACHE"] {
            if std::fs::read_to_string(folder.join(licence)).is_ok_and(|licence| licence.len() > 500) {
                continue;
            }
            faults.push(format!("{name}: no {licence}"));
        }
        let library = std::fs::read_to_string(folder.join("src/lib.rs")).unwrap();
        if !library.starts_with("#![doc = include_str!(\"../README.md\")]") {
            faults.push(format!("{name}: its documentation does not begin with its page"));
        }
    }
    assert_eq!(faults, Vec::<String>::new());
}

#[test]
fn pages_can_be_faulty() {
    let good = "# silhouette-x\n\nWhat it is.\n\n```rust\nlet x = 1;\n```\n";
    assert_eq!(faults_of_page("silhouette-x", good), Vec::<String>::new());
    for bad in
        [&good[2..], "# silhouette-x\n", &good.replace("let x", "# let x"), &good.replace("What", &"\n".repeat(30))]
    {
        assert_eq!(faults_of_page("silhouette-x", bad).len(), 1, "{bad}");
    }
}

#[test]
fn no_two_crates_describe_themselves_alike() {
    let packages = published();
    for key in ["description", "documentation", "keywords"] {
        let values: BTreeSet<String> = packages.iter().map(|package| package[key].to_string()).collect();
        assert_eq!(values.len(), packages.len(), "{key}");
        assert!(!values.contains("null"), "{key}");
    }
}
