//! What `smooth` writes.

use serde_json::Value;
use silhouette_core::glam::Vec3;
use silhouette_core::{TriangleMesh, load, shapes};
use std::path::Path;
use std::process::{Command, Output};

fn silhouettes(arguments: &[&str]) -> Output {
    let output = Command::new(env!("CARGO_BIN_EXE_silhouettes")).args(arguments).output().unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    output
}

/// Writes the OBJ of a built-in shape; yields the line on stderr.
fn smooth(shape: &str, options: &[&str], path: &Path) -> String {
    let mesh = format!("builtin:{shape}");
    let output = silhouettes(&[&["smooth", &mesh, "-o", path.to_str().unwrap()], options].concat());
    assert!(output.stdout.is_empty());
    let line = String::from_utf8(output.stderr).unwrap();
    assert!(line.lines().count() == 1 && line.starts_with(&mesh), "{line}");
    line
}

fn inspected(mesh: &str) -> Value {
    serde_json::from_slice(&silhouettes(&["inspect", mesh, "--json"]).stdout).unwrap()
}

/// Signed volume.
fn volume(mesh: &TriangleMesh) -> f64 {
    let of_face = |&[a, b, c]: &[u32; 3]| {
        let [a, b, c] = [a, b, c].map(|vertex| mesh.positions()[vertex as usize].as_dvec3());
        a.dot(b.cross(c)) / 6.0
    };
    mesh.triangles().iter().map(of_face).sum()
}

#[test]
fn closed_meshes_stay_closed_and_of_their_genus() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.obj");
    for shape in ["icosphere:1", "torus", "cube", "gear", "knot"] {
        for view in [&["--view", "iso"][..], &["--ortho", "fit", "--view", "front"], &["--eye", "0.3,0.2,0.1"]] {
            smooth(shape, view, &path);
            let (before, after) = (inspected(&format!("builtin:{shape}")), inspected(path.to_str().unwrap()));
            for property in ["is_closed", "is_manifold", "is_consistently_wound", "genus"] {
                assert_eq!(before[property], after[property], "{property} of {shape} seen {view:?}");
            }
            assert_eq!(before["components"].as_array().unwrap().len(), after["components"].as_array().unwrap().len());
            assert_eq!(after["defects"]["duplicate_vertices"].as_array().unwrap().len(), 0, "{shape}: each place once");
        }
    }
    // The control: a mesh with a boundary keeps it.
    smooth("grid", &["--view", "iso"], &path);
    assert_eq!(inspected(path.to_str().unwrap())["is_closed"], false);
}

#[test]
fn other_readers_find_the_same_triangles_with_unit_normals_on_their_side() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.obj");
    smooth("icosphere:1", &["--view", "iso", "--ortho", "fit"], &path);
    let ours = load::load(&path).unwrap();
    let (models, _) = tobj::load_obj(&path, &tobj::LoadOptions::default()).unwrap();
    let [model] = &models[..] else { panic!("{} models", models.len()) };
    let (theirs, triangles) = (&model.mesh, ours.triangles().as_flattened());
    assert_eq!(theirs.indices.len(), triangles.len());
    for ((&vertex, &normal), &ours_of) in theirs.indices.iter().zip(&theirs.normal_indices).zip(triangles) {
        let [position, normal] = [(&theirs.positions, vertex), (&theirs.normals, normal)]
            .map(|(values, index)| Vec3::from_slice(&values[3 * index as usize..]));
        assert_eq!(position, ours.positions()[ours_of as usize]);
        assert!((normal.length() - 1.0).abs() < 1e-5);
        assert!(normal.dot(position.normalize()) > 0.95, "normals of a sphere point away from its middle");
    }
    // What was added fills part of the gap to the sphere.
    let coarse = volume(&shapes::by_name("icosphere:1").unwrap());
    let sphere = 4.0 / 3.0 * std::f64::consts::PI;
    assert!(coarse < volume(&ours) && volume(&ours) < sphere, "{coarse}, {}", volume(&ours));
}

/// On a smooth shape a vertex has one normal, on a cube one for each side.
#[test]
fn sharp_edges_keep_a_normal_for_each_side() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.obj");
    let pairs = |shape: &str, options: &[&str]| -> usize {
        smooth(shape, options, &path);
        let text = std::fs::read_to_string(&path).unwrap();
        let corners = text.lines().filter_map(|line| line.strip_prefix("f ")).flat_map(|face| face.split(' '));
        let pairs: std::collections::BTreeSet<_> = corners.collect();
        let vertices: std::collections::BTreeSet<_> = pairs.iter().map(|pair| pair.split('/').next()).collect();
        pairs.len() - vertices.len()
    };
    assert_eq!(pairs("icosphere:1", &[]), 0);
    assert!(pairs("cube", &[]) >= 16, "8 corners with three normals each");
    assert!(pairs("icosphere:1", &["--set", "crease=10"]) > 100, "every edge of it sharp");
}

#[test]
fn the_line_on_stderr_counts_and_a_finer_tolerance_draws_more() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.obj");
    let numbers = |options: &[&str]| -> Vec<usize> {
        let line = smooth("icosphere:1", &[&["--view", "iso"], options].concat(), &path);
        let facts = line.split_once(": ").unwrap().1;
        facts.split(|c: char| !c.is_ascii_digit()).filter_map(|word| word.parse().ok()).collect()
    };
    let [coarse, fine] = ["tolerance=1", "tolerance=0.05"].map(|tolerance| numbers(&["--set", tolerance]));
    // Triangles before, after, those of the silhouette; one silhouette curve.
    assert_eq!((coarse[0], coarse[2], coarse[3]), (80, fine[2], 1), "{coarse:?}");
    assert!(coarse[0] < coarse[1] && coarse[1] < fine[1], "{coarse:?} {fine:?}");
    assert_eq!(load::load(&path).unwrap().face_count(), fine[1]);
}

/// A PNG is what `render` draws, or both say that there is no adapter.
#[test]
fn a_png_is_the_picture_that_render_draws() {
    let folder = tempfile::tempdir().unwrap();
    let [one, other] = ["smooth.png", "render.png"].map(|name| folder.path().join(name));
    let run = |words: &[&str], path: &Path| {
        let camera = ["builtin:icosphere:1", "--view", "iso", "--size", "96x96", "-o", path.to_str().unwrap()];
        let words = [words, &camera].concat();
        Command::new(env!("CARGO_BIN_EXE_silhouettes")).args(words).output().unwrap()
    };
    let drawn = run(&["smooth"], &one);
    let rendered = run(&["render", "--method", "smoothing"], &other);
    if drawn.status.success() {
        assert_eq!(std::fs::read(one).unwrap(), std::fs::read(other).unwrap());
    } else {
        assert!(std::env::var_os("SILHOUETTES_GPU").is_none_or(|value| value != "require"), "{drawn:?}");
        assert_eq!((drawn.status.code(), rendered.status.code()), (Some(1), Some(1)));
    }
}
