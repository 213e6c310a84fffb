//! What the layout promises: dependency rules, sizes of files, words that do not belong in finished work.

use serde_json::Value;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Crates that hold one published method each, or a family of extractors.
const METHOD_CRATES: [&str; 3] = ["silhouette-extraction", "silhouette-image-precision", "silhouette-tracking"];
/// Crates that may always depend on wgpu. Method crates may behind their `gpu` feature.
const GPU_CRATES: [&str; 2] = ["silhouette-gpu", "silhouette-render"];
/// Crates that must build without wgpu and without a C++ compiler once default features are off.
const LEAN_CRATES: [&str; 5] = [
    "silhouette-core",
    "silhouette-extraction",
    "silhouette-image-precision",
    "silhouette-tracking",
    "silhouette-visibility",
];

const MAX_RUST_LINES: usize = 600;
const MAX_WGSL_LINES: usize = 150;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_owned()
}

fn cargo(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO")).args(arguments).arg("--offline").current_dir(root()).output().unwrap();
    assert!(output.status.success(), "cargo {arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// A dependency between two crates of the workspace, or on wgpu.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Edge {
    from: String,
    to: String,
    optional: bool,
}

fn dependencies() -> Vec<Edge> {
    let metadata: Value = serde_json::from_str(&cargo(&["metadata", "--no-deps", "--format-version=1"])).unwrap();
    let mut edges = Vec::new();
    for package in metadata["packages"].as_array().unwrap() {
        for dependency in package["dependencies"].as_array().unwrap() {
            if dependency["kind"] != "dev" {
                let text = |value: &Value| value.as_str().unwrap().to_owned();
                let optional = dependency["optional"] == true;
                edges.push(Edge { from: text(&package["name"]), to: text(&dependency["name"]), optional });
            }
        }
    }
    edges
}

/// Everything that breaks a rule, as sentences.
fn broken_rules(edges: &[Edge]) -> Vec<String> {
    let is_method = |name: &String| METHOD_CRATES.contains(&name.as_str());
    let mut broken = Vec::new();
    for edge in edges {
        let Edge { from, to, optional } = edge;
        if is_method(from) && is_method(to) {
            broken.push(format!("{from} depends on another method, {to}"));
        }
        if to == "wgpu" && !GPU_CRATES.contains(&from.as_str()) && !(is_method(from) && *optional) {
            broken.push(format!("{from} knows wgpu"));
        }
        if from == "silhouette-core" && to.starts_with("silhouette") {
            broken.push(format!("core depends on {to}"));
        }
        if is_method(from) && matches!(to.as_str(), "silhouette-render" | "silhouette-compare") {
            broken.push(format!("{from} depends on {to}, which is an application of it"));
        }
    }
    broken
}

#[test]
fn dependencies_follow_the_rules() {
    let edges = dependencies();
    assert!(edges.iter().any(|edge| edge.to == "silhouette-core"), "the metadata was read");
    assert_eq!(broken_rules(&edges), Vec::<String>::new());
}

#[test]
fn the_dependency_rules_can_be_broken() {
    let edge = |from: &str, to: &str, optional| Edge { from: from.into(), to: to.into(), optional };
    for (bad, good) in [
        (
            edge("silhouette-extraction", "silhouette-image-precision", true),
            edge("silhouette-compare", "silhouette-extraction", false),
        ),
        (edge("silhouette-core", "wgpu", true), edge("silhouette-image-precision", "wgpu", true)),
        (edge("silhouette-image-precision", "wgpu", false), edge("silhouette-render", "wgpu", false)),
        (edge("silhouette-core", "silhouette-render", false), edge("silhouette-render", "silhouette-core", false)),
        (edge("silhouette-extraction", "silhouette-render", false), edge("silhouettes", "silhouette-render", false)),
    ] {
        assert_eq!(broken_rules(std::slice::from_ref(&bad)).len(), 1, "{bad:?}");
        assert_eq!(broken_rules(std::slice::from_ref(&good)).len(), 0, "{good:?}");
    }
}

/// Names of all crates that building `package` compiles.
fn compiled(package: &str, features: &[&str]) -> BTreeSet<String> {
    let arguments =
        [&["tree", "-p", package, "-e", "normal,build", "--prefix", "none", "--format", "{p}"], features].concat();
    cargo(&arguments).lines().filter_map(|line| line.split(' ').next()).map(str::to_owned).collect()
}

#[test]
fn lean_crates_build_without_wgpu_and_without_a_cpp_compiler() {
    for package in LEAN_CRATES {
        let crates = compiled(package, &["--no-default-features"]);
        assert!(crates.contains("glam"), "{package}: the tree was read");
        for heavy in ["wgpu", "cc", "cmake", "bindgen"] {
            assert!(!crates.contains(heavy), "{package} compiles {heavy}");
        }
    }
    assert!(compiled("silhouette-render", &[]).contains("wgpu"), "the check would see it");
}

/// Source files of the workspace that git knows or would take.
fn sources() -> Vec<PathBuf> {
    let mut folders = vec![root()];
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in folder.read_dir().unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            if path.is_dir() && name != "target" && !name.starts_with('.') {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs" || extension == "wgsl") {
                files.push(path);
            }
        }
    }
    files
}

#[test]
fn files_hold_one_room_each() {
    let files = sources();
    assert!(files.len() > 40, "only {} source files found", files.len());
    let mut broken = Vec::new();
    for path in files {
        let text = std::fs::read_to_string(&path).unwrap();
        let limit =
            if path.extension().is_some_and(|extension| extension == "wgsl") { MAX_WGSL_LINES } else { MAX_RUST_LINES };
        let lines = text.lines().count();
        if lines > limit {
            broken.push(format!("{}: {lines} lines, at most {limit}", path.display()));
        }
        let stem = path.file_stem().unwrap().to_string_lossy().into_owned();
        if ["utils", "util", "helpers", "misc", "common"].contains(&stem.as_str()) {
            broken.push(format!("{}: name it after what it holds", path.display()));
        }
    }
    assert_eq!(broken, Vec::<String>::new());
}

#[test]
fn every_method_stands_in_the_readme() {
    let readme = std::fs::read_to_string(root().join("README.md")).unwrap();
    for entry in silhouette_compare::registry::all() {
        assert!(readme.contains(&format!("`{}`", entry.info.name)), "{} is not in README.md", entry.info.name);
    }
}
