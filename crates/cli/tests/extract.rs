//! What `extract`, `inspect` and `doctor` write.

use serde_json::Value;
use std::process::Command;

fn stdout(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_silhouettes")).args(arguments).output().unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    assert!(output.stderr.is_empty(), "silent where stderr is no terminal");
    String::from_utf8(output.stdout).unwrap()
}

fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&stdout(arguments)).unwrap()
}

/// A cube seen along an axis shows one face; seen from a corner, three.
#[test]
fn a_cube_has_the_silhouette_of_a_square_or_a_hexagon() {
    for (eye, sides) in [("0.1,0.2,9", 4), ("7,8,9", 6)] {
        let found = json(&["extract", "builtin:cube", "--eye", eye]);
        assert_eq!(found["method"], "brute-force");
        assert_eq!((found["mesh"]["vertices"].as_u64(), found["mesh"]["triangles"].as_u64()), (Some(8), Some(12)));
        let edges = found["edges"].as_array().unwrap();
        let pairs: Vec<[u64; 2]> = edges.iter().map(|edge| [0, 1].map(|i| edge[i].as_u64().unwrap())).collect();
        assert_eq!(pairs.len(), sides);
        assert!(pairs.is_sorted() && pairs.iter().all(|[a, b]| a < b), "{pairs:?}");
        assert_eq!(found["boundary"].as_array().unwrap().len(), 0);
        assert_eq!(found["loops"].as_array().unwrap().len(), 1);
        assert_eq!(found["loops"][0].as_array().unwrap().len(), sides);
        assert_eq!(found["stats"]["faces_tested"], 12);
    }
}

#[test]
fn boundary_edges_are_listed_in_both_places() {
    let found = json(&["extract", "builtin:grid", "--eye", "0.1,9,0.2"]);
    assert!(!found["boundary"].as_array().unwrap().is_empty());
    assert_eq!(found["boundary"], found["edges"]);
}

#[test]
fn svg_and_obj_hold_a_closed_path_a_loop() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    stdout(&["extract", "builtin:cube", "--view", "iso", "-o", &path("x.svg")]);
    let svg = std::fs::read_to_string(path("x.svg")).unwrap();
    assert_eq!((svg.matches("<path").count(), svg.matches("L").count()), (1, 5), "{svg}");
    assert!(svg.contains("viewBox=\"0 0 1024 1024\""), "{svg}");
    stdout(&["extract", "builtin:cube", "--view", "iso", "-o", &path("x.obj")]);
    let obj = std::fs::read_to_string(path("x.obj")).unwrap();
    assert_eq!(obj.lines().filter(|line| line.starts_with("v ")).count(), 6);
    let line = obj.lines().find(|line| line.starts_with("l ")).unwrap();
    let numbers: Vec<_> = line.split(' ').skip(1).collect();
    assert_eq!((numbers.len(), numbers[0]), (7, numbers[6]), "closed");
}

#[test]
fn orthographic_and_far_views_agree() {
    let ortho = json(&["extract", "builtin:torus", "--ortho", "fit", "--view", "iso"]);
    let far = json(&["extract", "builtin:torus", "--eye", "1e8,1e8,1e8"]);
    assert_eq!(ortho["edges"], far["edges"]);
    assert_ne!(ortho["viewpoint"], far["viewpoint"]);
}

#[test]
fn inspect_counts_and_names_defects() {
    let torus = json(&["inspect", "builtin:torus", "--json"]);
    assert!(torus.to_string().contains("\"genus\""), "{torus}");
    let text = stdout(&["inspect", "builtin:moebius"]);
    assert!(text.contains("boundary loops"), "{text}");
}

/// A sphere's silhouette by `smoothing` is one closed curve; the method has no edges, so that there are no fields for them.
#[test]
fn curves_are_cubics_in_every_format() {
    let sphere = ["extract", "builtin:icosphere:2", "--method", "smoothing", "--ortho", "2.5", "--view", "front"];
    let found = json(&sphere);
    assert!(["edges", "boundary", "loops"].iter().all(|field| found.get(field).is_none()));
    let [curve] = &found["curves"].as_array().unwrap()[..] else { panic!("one curve: {found}") };
    let pieces = curve["pieces"].as_array().unwrap();
    assert!(curve["closed"] == true && pieces.len() > 10);
    for (piece, next) in pieces.iter().zip(pieces.iter().cycle().skip(1)) {
        assert_eq!(piece["control"][3], next["control"][0]);
        assert!(piece["kind"] == "silhouette" && piece["source"]["face"].as_u64().unwrap() < 320);
    }
    let cube = json(&["extract", "builtin:cube", "--method", "smoothing"]);
    let of_edge = &cube["curves"][0]["pieces"][0]["source"]["edge"];
    assert!(of_edge[0].as_u64().unwrap() < of_edge[1].as_u64().unwrap(), "{of_edge}");
    assert!(json(&["extract", "builtin:cube"]).get("curves").is_none());

    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    stdout(&[&sphere[..], &["-o", &path("x.svg")]].concat());
    let svg = std::fs::read_to_string(path("x.svg")).unwrap();
    let data = svg.split(" d=\"M").nth(1).unwrap().split('"').next().unwrap();
    assert_eq!((svg.matches("<path").count(), data.matches('C').count()), (1, pieces.len()), "one cubic a piece");
    assert!(data.ends_with(['z', 'Z']), "closed");
    // On the circle of radius 1, a pixel being 2.5 / 1024.
    let numbers: Vec<f64> = data
        .split([',', ' ', 'C', 'z', 'Z'])
        .filter(|word| !word.is_empty())
        .map(|word| word.parse().unwrap())
        .collect();
    let ends = numbers.chunks(2).step_by(3);
    let radius = |end: &[f64]| (end[0] - 512.0).hypot(end[1] - 512.0) / 1024.0 * 2.5;
    assert!(ends.map(radius).all(|radius| (radius - 1.0).abs() < 0.01));

    stdout(&[&sphere[..], &["-o", &path("x.obj")]].concat());
    let obj = std::fs::read_to_string(path("x.obj")).unwrap();
    let line: Vec<_> = obj.lines().find(|line| line.starts_with("l ")).unwrap().split(' ').skip(1).collect();
    assert_eq!((line[0], line[0]), ("1", line[line.len() - 1]), "closed");
    assert_eq!(obj.lines().filter(|line| line.starts_with("v ")).count(), line.len() - 1);
}

/// The document of a GLB file.
fn document(path: &str) -> Value {
    let bytes = std::fs::read(path).unwrap();
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    serde_json::from_slice(&bytes[20..20 + length]).unwrap()
}

/// The extension's object of a GLB file, and how many normals of silhouettes there are.
fn edges_of(path: &str) -> (Value, u64) {
    let document = document(path);
    let extension = document["meshes"][0]["primitives"][0]["extensions"]["EXT_mesh_primitive_edge_visibility"].clone();
    let normals = extension["silhouetteNormals"].as_u64().map(|accessor| &document["accessors"][accessor as usize]);
    let count = normals.map_or(0, |accessor| accessor["count"].as_u64().unwrap());
    (extension, count)
}

/// A cylinder of 64 sides bends by 5.6 degrees along it, and by 90 at its rims.
#[test]
fn a_glb_holds_the_edges_of_every_view() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    for (creases, silhouettes) in [(None, 64), (Some("91"), 3 * 64), (Some("5"), 0), (Some("180"), 3 * 64)] {
        let options = creases.map(|deg| ["--creases", deg]).into_iter().flatten();
        let command = ["extract", "builtin:cylinder", "-o"].into_iter().map(str::to_owned).chain([path("x.glb")]);
        let command: Vec<_> = command.chain(options.map(str::to_owned)).collect();
        assert_eq!(stdout(&command.iter().map(String::as_str).collect::<Vec<_>>()), "");
        let (extension, normals) = edges_of(&path("x.glb"));
        assert!(extension["visibility"].is_u64(), "{extension}");
        assert_eq!(normals, 2 * silhouettes, "{creases:?}");
    }
    assert_eq!(document(&path("x.glb"))["extensionsUsed"][0], "EXT_mesh_primitive_edge_visibility");
}

/// What was hard when the file was written is sharp when it is read, though nothing bends by 180 degrees.
#[test]
fn a_glb_is_read_back_with_its_hard_edges() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    for mesh in ["builtin:gear", "builtin:moebius"] {
        stdout(&["extract", mesh, "-o", &path("x.glb")]);
        stdout(&["extract", &path("x.glb"), "--creases", "180", "-o", &path("again.glb")]);
        assert_eq!(std::fs::read(path("x.glb")).unwrap(), std::fs::read(path("again.glb")).unwrap());
        let [built_in, read] = [mesh, &path("x.glb")].map(|mesh| json(&["extract", mesh, "--eye", "3,4,5"]));
        assert_eq!(built_in["edges"], read["edges"]);
    }
}

/// Two triangles with a seam between them, declared sharp on one of its sides.
#[test]
fn welding_closes_seams_and_keeps_sharp_edges() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let rows = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0\nv 1 1 0\nv 0 1 0.1\nf 1 2 3\nf 4 5 6\n";
    std::fs::write(path("seam.obj"), rows).unwrap();
    std::fs::write(path("sharp.obj"), format!("{rows}l 1 3\n")).unwrap();
    let normals = |mesh: &str, options: &[&str]| {
        stdout(&[&["extract", &path(mesh), "-o", &path("x.glb")], options].concat());
        edges_of(&path("x.glb")).1
    };
    assert_eq!(normals("seam.obj", &[]), 0, "a seam is a boundary");
    assert_eq!(normals("seam.obj", &["--weld"]), 2);
    assert_eq!(normals("sharp.obj", &["--weld"]), 0, "the edge is hard");
    let [seam, welded] = [&[][..], &["--weld=0.01"]]
        .map(|options: &[&str]| json(&[&["extract", &path("seam.obj"), "--eye", "0.5,0.5,9"], options].concat()));
    assert_eq!([&seam, &welded].map(|found| found["edges"].as_array().unwrap().len()), [6, 4]);
    assert_eq!(welded["mesh"]["vertices"], 4);
}
