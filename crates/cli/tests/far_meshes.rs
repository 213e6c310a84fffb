//! Meshes in the coordinates of a survey: drawn as near zero, and written as they were read.

use serde_json::Value;
use std::process::{Command, Output};

/// A house of 10 x 6 m with a chimney of 0.6 m, about a corner.
const HOUSE: [[f64; 3]; 10] = [
    [0.0, 0.0, 0.0],
    [10.0, 0.0, 0.0],
    [10.0, 6.0, 0.0],
    [0.0, 6.0, 0.0],
    [0.0, 0.0, 3.0],
    [10.0, 0.0, 3.0],
    [10.0, 6.0, 3.0],
    [0.0, 6.0, 3.0],
    [0.0, 3.0, 5.5],
    [10.0, 3.0, 5.5],
];
const WALLS: [&[usize]; 7] =
    [&[4, 3, 2, 1], &[1, 2, 6, 5], &[3, 4, 8, 7], &[2, 3, 7, 10, 6], &[4, 1, 5, 9, 8], &[5, 6, 10, 9], &[7, 8, 9, 10]];
const BOX: [[usize; 4]; 6] = [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]];
const CHIMNEY: [f64; 3] = [2.0, 2.7, 4.5];
const WIDTH: f64 = 0.6;

const FAR: [f64; 3] = [440_123.35, 5_412_345.72, 312.4];

/// To the tenth of a millimetre, as surveyors write it.
fn house(at: [f64; 3]) -> String {
    let mut text = String::new();
    let mut vertex = |p: [f64; 3]| {
        let [x, y, z] = [0, 1, 2].map(|axis| at[axis] + p[axis]);
        text += &format!("v {x:.4} {y:.4} {z:.4}\n");
    };
    HOUSE.into_iter().for_each(&mut vertex);
    for corner in 0..8 {
        let side = [corner & 1, corner >> 1 & 1, corner >> 2].map(f64::from);
        vertex([0, 1, 2].map(|axis| CHIMNEY[axis] + side[axis] * [WIDTH, WIDTH, 2.0][axis]));
    }
    for wall in WALLS {
        text += &format!("f {}\n", wall.iter().map(ToString::to_string).collect::<Vec<_>>().join(" "));
    }
    for quad in BOX {
        text += &format!("f {}\n", quad.map(|corner| (corner + 10).to_string()).join(" "));
    }
    text
}

fn run(arguments: &[&str]) -> Output {
    let output = Command::new(env!("CARGO_BIN_EXE_silhouettes")).args(arguments).output().unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    output
}

fn json(arguments: &[&str]) -> Value {
    serde_json::from_slice(&run(arguments).stdout).unwrap()
}

/// All numbers of a document that are in arrays of so many, in order.
fn tuples(value: &Value, length: usize) -> Vec<Vec<f64>> {
    match value {
        Value::Array(items) if items.len() == length && items.iter().all(Value::is_number) => {
            vec![items.iter().map(|item| item.as_f64().unwrap()).collect()]
        }
        Value::Array(items) => items.iter().flat_map(|item| tuples(item, length)).collect(),
        Value::Object(members) => members.values().flat_map(|item| tuples(item, length)).collect(),
        _ => Vec::new(),
    }
}

fn point(at: [f64; 3], offset: [f64; 3]) -> String {
    [0, 1, 2].map(|axis| (at[axis] + offset[axis]).to_string()).join(",")
}

struct Houses {
    _folder: tempfile::TempDir,
    near: String,
    far: String,
}

impl Houses {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, at: [f64; 3]| {
            let path = folder.path().join(name).to_str().unwrap().to_owned();
            std::fs::write(&path, house(at)).unwrap();
            path
        };
        let (near, far) = (write("near.obj", [0.0; 3]), write("far.obj", FAR));
        Self { near, far, _folder: folder }
    }

    fn path(&self, name: &str) -> String {
        self._folder.path().join(name).to_str().unwrap().to_owned()
    }
}

/// Lines with the camera in the file's coordinates are the same, up to where they are.
#[test]
fn lines_are_those_near_zero() {
    let houses = Houses::new();
    let lines = |mesh: &str, at: [f64; 3]| {
        let (eye, target) = (point(at, [-20.0, -25.0, 14.0]), point(at, [5.0, 3.0, 2.5]));
        let out = houses.path("lines.json");
        let camera = ["--eye", &eye, "--target", &target, "--up", "0,0,1"];
        run(&[&["lines", mesh, "--creases", "30", "-o", &out][..], &camera].concat());
        serde_json::from_slice::<Value>(&std::fs::read(&out).unwrap()).unwrap()
    };
    let (near, far) = (lines(&houses.near, [0.0; 3]), lines(&houses.far, FAR));
    let member = |document: &Value, key: &str, length: usize| {
        let chains = document["chains"].as_array().unwrap().iter();
        chains.flat_map(|chain| tuples(&chain[key], length)).collect::<Vec<_>>()
    };
    for (key, length, offset) in [("pixels", 2, [0.0; 3]), ("points", 3, FAR)] {
        let (near, far) = (member(&near, key, length), member(&far, key, length));
        assert!(!near.is_empty());
        assert_eq!(near.len(), far.len(), "{key}");
        for (near, far) in near.iter().zip(&far) {
            let apart = (0..length).map(|axis| (near[axis] + offset[axis] - far[axis]).abs()).fold(0.0, f64::max);
            assert!(apart < if length == 2 { 0.02 } else { 1e-4 }, "{key}: {near:?} and {far:?}");
        }
    }
    let eye = tuples(&far["camera"]["eye"], 3).remove(0);
    assert!((eye[1] - (FAR[1] - 25.0)).abs() < 1e-6, "{eye:?}");
}

#[test]
fn named_views_are_those_near_zero() {
    let houses = Houses::new();
    let numbers = |mesh: &str| -> Vec<f64> {
        let view = ["--view", "front", "--up-axis", "z", "--ortho", "fit", "--creases", "30", "--hidden"];
        let svg = String::from_utf8(run(&[&["lines", mesh][..], &view].concat()).stdout).unwrap();
        let paths = svg.split(" d=\"").skip(1).map(|path| path.split('"').next().unwrap());
        let words = paths.flat_map(|path| path.split(|c: char| c.is_ascii_alphabetic() || c == ' ' || c == ','));
        words.filter_map(|word| word.parse().ok()).collect()
    };
    let (near, far) = (numbers(&houses.near), numbers(&houses.far));
    assert!(near.len() > 20 && near.len() == far.len(), "{} and {}", near.len(), far.len());
    assert!(near.iter().zip(&far).all(|(near, far)| (near - far).abs() < 0.02), "{near:?} and {far:?}");
}

#[test]
fn extracts_are_in_the_coordinates_of_the_file() {
    let houses = Houses::new();
    let eye = point(FAR, [-20.0, -25.0, 14.0]);
    let found = json(&["extract", &houses.far, "--eye", &eye]);
    let expected: Vec<f64> = eye.split(',').map(|number| number.parse().unwrap()).collect();
    assert_eq!(tuples(&found["viewpoint"], 3), [expected]);
    assert_eq!(found["edges"], json(&["extract", &houses.near, "--eye", "-20,-25,14"])["edges"]);

    let rows: Vec<String> = std::fs::read_to_string(&houses.far).unwrap().lines().map(str::to_owned).collect();
    let digits = |row: &str| -> Vec<f64> { row.split(' ').filter_map(|word| word.parse().ok()).collect() };
    let known: Vec<Vec<f64>> = rows.iter().filter(|row| row.starts_with("v ")).map(|row| digits(row)).collect();
    let obj = houses.path("loops.obj");
    run(&["extract", &houses.far, "--eye", &eye, "-o", &obj]);
    let text = std::fs::read_to_string(&obj).unwrap();
    let written: Vec<Vec<f64>> = text.lines().filter(|row| row.starts_with("v ")).map(digits).collect();
    assert!(written.len() > 5 && written.iter().all(|vertex| known.contains(vertex)), "{written:?}");

    let extent = |mesh: &str| tuples(&json(&["inspect", mesh, "--json"])["extent"], 3);
    let smooth = houses.path("smooth.obj");
    run(&["smooth", &houses.far, "--eye", &eye, "-o", &smooth]);
    let of_far = extent(&smooth);
    run(&["smooth", &houses.near, "--eye", "-20,-25,14", "-o", &smooth]);
    for (far, near) in of_far.iter().zip(extent(&smooth)) {
        assert!((0..3).all(|axis| (far[axis] - FAR[axis] - near[axis]).abs() < 1e-3), "{far:?} and {near:?}");
    }
    let glb = houses.path("edges.glb");
    run(&["extract", &houses.far, "-o", &glb]);
    for (ours, theirs) in extent(&glb).concat().iter().zip(extent(&houses.far).concat()) {
        assert!((ours - theirs).abs() < 1e-4, "{ours} and {theirs}");
    }
}

#[test]
fn inspect_shows_the_origin_and_the_file_s_own_digits() {
    let houses = Houses::new();
    let text = String::from_utf8(run(&["inspect", &houses.far]).stdout).unwrap();
    assert!(text.contains("[440123.35, 5412345.72, 312.4] to [440133.35, 5412351.72, 318.9]"), "{text}");
    assert!(text.contains("origin           [440128, 5412352, 0]"), "{text}");
    assert!(!String::from_utf8(run(&["inspect", &houses.near]).stdout).unwrap().contains("origin"));
    assert_eq!(tuples(&json(&["inspect", &houses.near, "--json"])["origin"], 3), [[0.0; 3]]);
}

/// Two houses whose origins differ are as far from each other as their files say, whichever is named first.
#[test]
fn meshes_of_one_drawing_share_their_space() {
    let houses = Houses::new();
    let beside = houses.path("beside.obj");
    std::fs::write(&beside, house([FAR[0] + 900.3, FAR[1], FAR[2]])).unwrap();
    for order in [[&houses.far, &beside], [&beside, &houses.far]] {
        let out = houses.path("both.json");
        let view = ["--view", "front", "--up-axis", "z", "--ortho", "fit", "-o", &out];
        run(&[&["lines", order[0], order[1]][..], &view].concat());
        let both: Value = serde_json::from_slice(&std::fs::read(&out).unwrap()).unwrap();
        let chains = both["chains"].as_array().unwrap().iter();
        let x = chains.flat_map(|chain| tuples(&chain["points"], 3)).map(|point| point[0]);
        let (min, max) = x.fold((f64::MAX, f64::MIN), |(min, max), x| (min.min(x), max.max(x)));
        assert!((min - FAR[0]).abs() < 1e-4 && (max - FAR[0] - 910.3).abs() < 1e-4, "{min} to {max}");
    }
}

/// Parts that are left out, or only hide others, leave the rest where it is.
#[test]
fn parts_of_far_meshes_stay_where_they_are() {
    let houses = Houses::new();
    let text = std::fs::read_to_string(&houses.far).unwrap();
    let chimney = format!("f {}", BOX[0].map(|corner| (corner + 10).to_string()).join(" "));
    let named = text.replacen("\nf ", "\no walls\nf ", 1).replacen(&chimney, &format!("o chimney\n{chimney}"), 1);
    let (mesh, out) = (houses.path("parts.obj"), houses.path("part.json"));
    std::fs::write(&mesh, named).unwrap();
    for which in [["--only", "chimney"], ["--mask", "walls"]] {
        run(&[&["lines", &mesh, "--view", "front", "--up-axis", "z", "-o", &out][..], &which].concat());
        let found: Value = serde_json::from_slice(&std::fs::read(&out).unwrap()).unwrap();
        let points: Vec<_> =
            found["chains"].as_array().unwrap().iter().flat_map(|chain| tuples(&chain["points"], 3)).collect();
        let low = points.iter().map(|point| point[0]).fold(f64::MAX, f64::min);
        assert!((low - FAR[0] - CHIMNEY[0]).abs() < 1e-4, "{which:?}: {low}");
    }
}

/// A cube of side 2 about a place.
fn cube(folder: &std::path::Path, name: &str, [x, y, z]: [f64; 3]) -> String {
    let mut text = String::new();
    for corner in 0..8 {
        let side = [corner & 1, corner >> 1 & 1, corner >> 2].map(|side| f64::from(2 * side - 1));
        text += &format!("v {} {} {}\n", x + side[0], y + side[1], z + side[2]);
    }
    for quad in BOX {
        text += &format!("f {}\n", quad.map(|corner| corner.to_string()).join(" "));
    }
    let path = folder.join(name);
    std::fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Places of all chains in the coordinates of the file.
fn places(document: &Value) -> Vec<[f64; 3]> {
    let chains = document["chains"].as_array().unwrap();
    let points = chains.iter().flat_map(|chain| chain["points"].as_array().unwrap());
    points.map(|point| [0, 1, 2].map(|axis| point[axis].as_f64().unwrap())).collect()
}

#[test]
fn a_mesh_that_is_cut_open_stays_where_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (one, other) = (
        cube(folder.path(), "one.obj", [500_000.0, 0.0, 5_400_000.0]),
        cube(folder.path(), "other.obj", [500_006.0, 0.0, 5_400_000.0]),
    );
    let view = ["--view", "front", "--ortho", "fit"];
    run(&[&["lines", &one, &other, "--section", "500000,0,5400000,0,0,1", "-o", &at("cut.json")], &view[..]].concat());
    let cut: Value = serde_json::from_slice(&std::fs::read(at("cut.json")).unwrap()).unwrap();
    let places = places(&cut);
    assert!(places.iter().any(|place| place[0] > 500_005.5), "the other one is drawn: {places:?}");
    assert!(places.iter().all(|place| (place[0] - 500_003.0).abs() < 4.5 && place[2] <= 5_400_001.0), "{places:?}");
    assert!(places.iter().any(|place| (place[2] - 5_400_000.0).abs() < 1e-3), "the section");

    // What remains may be small and far from where the whole was: the camera stays.
    let (near, far) = (cube(folder.path(), "near.obj", [0.0; 3]), cube(folder.path(), "far.obj", [1000.0, 0.0, 0.0]));
    let target = |options: &[&str]| {
        run(&[&["lines", &near, &far, "-o", &at("page.json")], options, &view[..]].concat());
        let page: Value = serde_json::from_slice(&std::fs::read(at("page.json")).unwrap()).unwrap();
        page["camera"]["target"].clone()
    };
    assert_eq!(target(&["--section", "950,0,0,-1,0,0"]), target(&[]));
    assert_eq!(target(&["--section", "50,0,0,1,0,0"]), target(&[]));
}

#[test]
fn meshes_too_far_from_each_other_are_noted() {
    let folder = tempfile::tempdir().unwrap();
    let (near, far) = (cube(folder.path(), "near.obj", [0.0; 3]), cube(folder.path(), "far.obj", [5e6, 0.0, 0.0]));
    let noted = |meshes: &[&str]| String::from_utf8(run(&[&["lines"], meshes].concat()).stderr).unwrap();
    assert!(noted(&[&near, &far]).contains("far.obj: is rounded by up to"), "{}", noted(&[&near, &far]));
    assert!(!noted(&[&far]).contains("rounded"));
    let beside = cube(folder.path(), "beside.obj", [5e6 + 100.0, 0.0, 0.0]);
    assert!(!noted(&[&far, &beside]).contains("rounded"));
}
