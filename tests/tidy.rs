//! What the layout promises: dependency rules, sizes of files, words that do not belong in finished work.

use serde_json::Value;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Crates that may always depend on wgpu. Method crates may behind their `gpu` feature.
const GPU_CRATES: [&str; 2] = ["silhouette-gpu", "silhouette-render"];
/// Crates that must build without wgpu and without a C++ compiler once default features are off, as method crates must.
const LEAN_CRATES: [&str; 2] = ["silhouette-core", "silhouette-visibility"];
/// Crates that only tests may depend on.
const TEST_CRATES: [&str; 2] = ["silhouette-entry-points", "silhouette-testing"];
/// Packages that are tests: they may depend on all of it, as nothing depends on them.
const TESTS: [&str; 2] = ["silhouette-tests", "silhouette-extremes"];

const MAX_RUST_LINES: usize = 600;
const MAX_WGSL_LINES: usize = 150;

pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_owned()
}

pub fn cargo(arguments: &[&str]) -> String {
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

/// The packages of the workspace, as far as the rules ask.
struct Workspace {
    /// Packages that hold published methods: those whose metadata says `[package.metadata.silhouettes] methods = true`.
    methods: BTreeSet<String>,
    edges: Vec<Edge>,
}

fn workspace() -> Workspace {
    let metadata: Value = serde_json::from_str(&cargo(&["metadata", "--no-deps", "--format-version=1"])).unwrap();
    let text = |value: &Value| value.as_str().unwrap().to_owned();
    let (mut methods, mut edges) = (BTreeSet::new(), Vec::new());
    for package in metadata["packages"].as_array().unwrap() {
        if package["metadata"]["silhouettes"]["methods"] == true {
            methods.insert(text(&package["name"]));
        }
        for dependency in package["dependencies"].as_array().unwrap() {
            if dependency["kind"] != "dev" {
                let optional = dependency["optional"] == true;
                edges.push(Edge { from: text(&package["name"]), to: text(&dependency["name"]), optional });
            }
        }
    }
    Workspace { methods, edges }
}

/// Everything that breaks a rule, as sentences.
fn broken_rules(workspace: &Workspace) -> Vec<String> {
    let is_method = |name: &String| workspace.methods.contains(name);
    let mut broken = Vec::new();
    for Edge { from, to, optional } in &workspace.edges {
        if is_method(from) && is_method(to) {
            broken.push(format!("{from} depends on another method, {to}"));
        }
        let may_know_wgpu = GPU_CRATES.contains(&from.as_str()) || TESTS.contains(&from.as_str());
        if to == "wgpu" && !(may_know_wgpu || is_method(from) && *optional) {
            broken.push(format!("{from} knows wgpu"));
        }
        if from == "silhouette-core" && to.starts_with("silhouette") {
            broken.push(format!("core depends on {to}"));
        }
        if is_method(from) && matches!(to.as_str(), "silhouette-render" | "silhouette-compare") {
            broken.push(format!("{from} depends on {to}, which is an application of it"));
        }
        if TEST_CRATES.contains(&to.as_str()) && !TESTS.contains(&from.as_str()) {
            broken.push(format!("{from} depends on {to}, which is for tests"));
        }
        if TESTS.contains(&to.as_str()) {
            broken.push(format!("{from} depends on {to}, which is tests"));
        }
    }
    broken
}

#[test]
fn dependencies_follow_the_rules() {
    let workspace = workspace();
    assert!(workspace.edges.iter().any(|edge| edge.to == "silhouette-core"), "the metadata was read");
    assert!(
        workspace.methods.len() >= 4 && workspace.methods.contains("silhouette-tracking"),
        "{:?}",
        workspace.methods
    );
    assert_eq!(broken_rules(&workspace), Vec::<String>::new());
}

#[test]
fn the_dependency_rules_can_be_broken() {
    let edge = |from: &str, to: &str, optional| Edge { from: from.into(), to: to.into(), optional };
    let broken = |edge: &Edge| {
        let methods = ["silhouette-extraction", "silhouette-image-precision"].map(str::to_owned).into();
        broken_rules(&Workspace { methods, edges: vec![edge.clone()] }).len()
    };
    for (bad, good) in [
        (
            edge("silhouette-extraction", "silhouette-image-precision", true),
            edge("silhouette-compare", "silhouette-extraction", false),
        ),
        (edge("silhouette-core", "wgpu", true), edge("silhouette-image-precision", "wgpu", true)),
        (edge("silhouette-image-precision", "wgpu", false), edge("silhouette-render", "wgpu", false)),
        (edge("silhouette-core", "silhouette-render", false), edge("silhouette-render", "silhouette-core", false)),
        (edge("silhouette-extraction", "silhouette-render", false), edge("silhouettes", "silhouette-render", false)),
        (edge("silhouette-core", "silhouette-testing", false), edge("silhouette-tests", "silhouette-testing", false)),
        (edge("silhouettes", "silhouette-extremes", false), edge("silhouette-extremes", "wgpu", false)),
    ] {
        assert!(broken(&bad) > 0, "{bad:?}");
        assert_eq!(broken(&good), 0, "{good:?}");
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
    let methods = workspace().methods;
    for package in LEAN_CRATES.into_iter().chain(methods.iter().map(String::as_str)) {
        let crates = compiled(package, &["--no-default-features"]);
        assert!(crates.contains("glam"), "{package}: the tree was read");
        for heavy in ["wgpu", "cc", "cmake", "bindgen"] {
            assert!(!crates.contains(heavy), "{package} compiles {heavy}");
        }
    }
    assert!(compiled("silhouette-render", &[]).contains("wgpu"), "the check would see it");
}

/// Source files of the workspace that git knows or would take.
pub fn sources() -> Vec<PathBuf> {
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

/// Where the lint against `unsafe` may not reach: manifests that do not take the workspace's lints.
fn without_lints(manifests: &[(PathBuf, String)]) -> Vec<String> {
    let takes_them = |text: &str| text.contains("[lints]\nworkspace = true");
    let outside = manifests.iter().filter(|(_, text)| text.contains("[package]") && !takes_them(text));
    outside.map(|(path, _)| path.display().to_string()).collect()
}

/// `forbid` cannot be overridden in source; so it holds wherever a manifest takes the lints, and all do.
#[test]
fn unsafe_code_is_forbidden_everywhere() {
    let workspace = std::fs::read_to_string(root().join("Cargo.toml")).unwrap();
    assert!(workspace.contains("[workspace.lints.rust]\n") && workspace.contains("unsafe_code = \"forbid\"\n"));
    let metadata: Value = serde_json::from_str(&cargo(&["metadata", "--no-deps", "--format-version=1"])).unwrap();
    let manifests: Vec<(PathBuf, String)> = metadata["packages"]
        .as_array()
        .unwrap()
        .iter()
        .map(|package| PathBuf::from(package["manifest_path"].as_str().unwrap()))
        .map(|path| (path.clone(), std::fs::read_to_string(path).unwrap()))
        .collect();
    assert!(manifests.len() > 18, "{} packages", manifests.len());
    assert_eq!(without_lints(&manifests), Vec::<String>::new());
    let outside = (PathBuf::from("Cargo.toml"), "[package]\nname = \"x\"\n\n[lints.rust]\n".to_owned());
    assert_eq!(without_lints(&[outside]).len(), 1, "the check can fail");
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
    for entry in silhouette_compare::registry::Registry::builtin().entries() {
        assert!(readme.contains(&format!("`{}`", entry.info().name)), "{} is not in README.md", entry.info().name);
    }
}
