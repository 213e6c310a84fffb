//! Pens, layers, parts and views of `lines`.

use std::path::Path;
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_silhouettes")).args(arguments).output().unwrap()
}

fn svg(arguments: &[&str]) -> String {
    let output = run(&[&["lines"], arguments].concat());
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn refused(arguments: &[&str]) -> String {
    let output = run(&[&["lines"], arguments].concat());
    let line = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(2) && line.lines().count() == 1, "{arguments:?}: {line}");
    line
}

/// The value of an attribute in each tag of a kind that has it.
fn attributes<'a>(svg: &'a str, tag: &str, name: &str) -> Vec<&'a str> {
    let (tag, name) = (format!("<{tag} "), format!("{name}=\""));
    let tags = svg.split(tag.as_str()).skip(1).map(|rest| rest.split('>').next().unwrap());
    tags.filter_map(|tag| tag.split(name.as_str()).nth(1)).map(|rest| rest.split('"').next().unwrap()).collect()
}

fn labels(svg: &str) -> Vec<&str> {
    attributes(svg, "g", "inkscape:label")
}

/// A box with its least corner at a place, as rows whose vertices follow others.
fn cuboid(first: usize, [x, y, z]: [f32; 3], side: f32) -> String {
    let corner = |i: usize, axis: usize, low: f32| if i >> axis & 1 == 0 { low } else { low + side };
    let rows: String =
        (0..8).map(|i| format!("v {} {} {}\n", corner(i, 0, x), corner(i, 1, y), corner(i, 2, z))).collect();
    let faces = ["1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"];
    let shifted = |face: &&str| {
        let corners = face.split(' ').map(|corner| (corner.parse::<usize>().unwrap() + first).to_string());
        format!("f {}\n", corners.collect::<Vec<_>>().join(" "))
    };
    rows + &faces.iter().map(shifted).collect::<String>()
}

/// A small box in front of a large one, in an object each, with a group each.
fn scene(folder: &Path) -> String {
    let path = folder.join("scene.obj");
    let (large, small) = (cuboid(0, [0.0, 0.0, 0.0], 4.0), cuboid(8, [1.0, 1.0, 6.0], 2.0));
    std::fs::write(&path, format!("o house\ng wall\n{large}o tree\ng \"crown\n{small}")).unwrap();
    path.to_str().unwrap().to_owned()
}

const FRONT: [&str; 4] = ["--view", "front", "--ortho", "fit"];

/// Corners of all paths of a drawing in units of the large box, from its lower left corner on.
fn corners(svg: &str) -> Vec<[i64; 2]> {
    let data = attributes(svg, "path", "d");
    let numbers = data.iter().flat_map(|data| data.split(['M', 'L', 'Z', ' ']).filter(|word| !word.is_empty()));
    let numbers: Vec<f64> = numbers.map(|word| word.parse().unwrap()).collect();
    let mut corners: Vec<[i64; 2]> = numbers.chunks(2).map(|at| [at[0], at[1]].map(|x| x.round() as i64)).collect();
    corners.sort_unstable();
    corners.dedup();
    corners
}

#[test]
fn hidden_lines_have_their_own_pens() {
    let cube = ["builtin:cube", "--view", "iso", "--creases", "30", "--hidden"];
    let pens = ["--width", "hidden=0.18mm", "--colour", "hidden=grey", "--width", "ridge=0.3"];
    let drawing = svg(&[&cube[..], &pens].concat());
    assert_eq!(labels(&drawing), ["23 ridge hidden", "3 ridge visible", "1 silhouette visible"]);
    assert_eq!(attributes(&drawing, "g", "stroke-width"), ["0.18", "0.3", "0.5"]);
    assert_eq!(attributes(&drawing, "g", "stroke"), ["#808080", "#000000", "#000000"]);
    let one = svg(&[&cube[..], &pens, &["--width", "hidden-ridge=0.13mm"]].concat());
    assert_eq!(attributes(&one, "g", "stroke-width"), ["0.13", "0.3", "0.5"]);
}

#[test]
fn a_kind_is_the_same_layer_in_every_file() {
    let number = |arguments: &[&str], kind: &str| {
        let drawing = svg(arguments);
        let label = labels(&drawing).into_iter().find(|label| label.ends_with(kind)).unwrap().to_owned();
        label.split(' ').next().unwrap().parse::<u32>().unwrap()
    };
    for kind in ["silhouette visible", "ridge visible"] {
        let plain = number(&["builtin:cube", "--creases", "30"], kind);
        let more = ["builtin:cube", "--creases", "30", "--hidden", "--all-edges", "--view", "iso", "--outline"];
        assert_eq!(plain, number(&more, kind));
    }
}

#[test]
fn layers_may_be_parts() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene(folder.path());
    let by = |by: &str, more: &[&str]| {
        let words = [&[scene.as_str(), "--layers", by, "--creases", "30", "--view", "three-quarter"], more].concat();
        svg(&words)
    };
    let object = by("object", &[]);
    assert_eq!(labels(&object), ["1 wall", "2 &quot;crown"]);
    assert_eq!(
        attributes(&object, "g", "id"),
        [
            "layer-1",
            "layer-1-ridge-visible",
            "layer-1-silhouette-visible",
            "layer-2",
            "layer-2-ridge-visible",
            "layer-2-silhouette-visible",
        ]
    );
    assert_eq!(labels(&by("object", &["--only", "tree"])), ["2 &quot;crown"], "a part keeps its number");
    let both = by("both", &["--hidden"]);
    assert_eq!(
        labels(&both),
        [
            "123 wall ridge hidden",
            "121 wall silhouette hidden",
            "103 wall ridge visible",
            "101 wall silhouette visible",
            "223 &quot;crown ridge hidden",
            "203 &quot;crown ridge visible",
            "201 &quot;crown silhouette visible"
        ]
    );
    let files = svg(&[&scene, "builtin:torus", "--layers", "object", "--only", "builtin:torus"]);
    assert_eq!(labels(&files), ["3 builtin:torus"]);
}

#[test]
fn parts_are_drawn_left_out_or_masks() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene(folder.path());
    let drawn = |more: &[&str]| corners(&svg(&[&[scene.as_str(), "--scale", "30"], &FRONT[..], more].concat()));
    let square = |low: i64, high: i64| vec![[low, low], [low, high], [high, low], [high, high]];
    // On a page of 210 by 297 mm, moved to a common place.
    let at = |points: &[[i64; 2]]| -> Vec<[i64; 2]> {
        let low = [0, 1].map(|axis| points.iter().map(|point| point[axis]).min().unwrap());
        points.iter().map(|point| [point[0] - low[0], point[1] - low[1]]).collect()
    };
    assert_eq!(at(&drawn(&["--only", "wall"])), square(0, 120));
    assert_eq!(at(&drawn(&["--without", "house"])), square(0, 60));
    assert_eq!(drawn(&["--only", "house", "--only", "tree"]), drawn(&[]));
    // The small box hides nothing of the large one's outline, so that only creases show what a mask does.
    let top = |more: &[&str]| {
        let words =
            [&[scene.as_str(), "--view", "right", "--ortho", "fit", "--scale", "20", "--all-edges"], more].concat();
        corners(&svg(&words)).len()
    };
    assert!(top(&["--mask", "tree"]) <= top(&[]));

    let wall = folder.path().join("wall.obj");
    std::fs::write(&wall, "v -9 2 9\nv 9 2 9\nv 9 9 9\nv -9 9 9\nf 1 2 3 4\n").unwrap();
    let half = drawn(&["--only", "wall", "--mask", wall.to_str().unwrap()]);
    assert_eq!(
        at(&half),
        vec![[0, 0], [0, 60], [120, 0], [120, 60]],
        "what the wall hides is not drawn, nor is the wall"
    );
    let outline = svg(&[&[scene.as_str(), "--mask", wall.to_str().unwrap(), "--outline=only"], &FRONT[..]].concat());
    assert_eq!(attributes(&outline, "path", "d").len(), 1);
    let smooth = ["builtin:icosphere:2", "--smooth", "--mask", "builtin:torus", "--layers", "object"];
    assert_eq!(labels(&svg(&smooth)), ["1 builtin:icosphere:2"]);
}

#[test]
fn unknown_names_are_refused_with_those_that_exist() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene(folder.path());
    for option in ["--only", "--without", "--mask"] {
        let line = refused(&[&scene, option, "hut"]);
        assert!(line.contains(&format!("{option} hut")) && line.contains("house, scene.obj, tree, wall"), "{line}");
    }
    assert!(refused(&[&scene, "--without", "scene.obj"]).contains("nothing to draw"));
    assert!(refused(&[&scene, "--only", "house", "--without", "wall"]).contains("nothing to draw"));
}

#[test]
fn views_are_groups_of_one_page() {
    let gear = ["builtin:gear", "--creases", "20", "--views", "front,top,right,iso"];
    let drawing = svg(&gear);
    assert_eq!(labels(&drawing), ["4 valley visible", "3 ridge visible", "1 silhouette visible"]);
    let ids = attributes(&drawing, "g", "id");
    for view in ["front", "top", "right", "iso"] {
        assert!(ids.contains(&format!("silhouette-visible-{view}").as_str()), "{ids:?}");
    }
    assert!(drawing.contains("width=\"210mm\""));
    assert!(refused(&[&gear[..], &["-o", "x.json"]].concat()).contains("--views"));
    assert!(refused(&["builtin:cube", "--views", "front,front"]).contains("twice"));
    assert!(refused(&["builtin:cube", "--views", "front,above"]).contains("expected some of"));
    assert!(refused(&["builtin:cube", "--views", "front", "--view", "top"]).contains("--view"));
    assert!(refused(&["builtin:cube", "--views", "front", "--units", "px"]).contains("page"));
}

#[test]
fn edges_of_parts_are_numbered_as_in_their_file() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene(folder.path());
    let edges = |by: &str| {
        let path = folder.path().join(format!("{by}.json"));
        svg(&[&[scene.as_str(), "--layers", by, "-o", path.to_str().unwrap()], &FRONT[..]].concat());
        let document: serde_json::Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
        let chains = document["chains"].as_array().unwrap();
        let mut edges: Vec<String> =
            chains.iter().flat_map(|chain| chain["edges"].as_array().unwrap()).map(ToString::to_string).collect();
        edges.sort_unstable();
        edges
    };
    let of_kinds = edges("kind");
    assert!(!of_kinds.is_empty());
    assert_eq!((edges("object"), edges("both")), (of_kinds.clone(), of_kinds));
}

#[test]
fn a_mask_is_no_place_for_the_output() {
    let folder = tempfile::tempdir().unwrap();
    let (scene, mask) = (scene(folder.path()), folder.path().join("mask.gltf"));
    svg(&["builtin:cube", "-o", mask.to_str().unwrap()]);
    let before = std::fs::read(&mask).unwrap();
    let mask_name = mask.to_str().unwrap();
    assert!(refused(&[&scene, "--mask", mask_name, "-o", mask_name]).contains("is the input"));
    assert_eq!(std::fs::read(&mask).unwrap(), before);
    assert!(refused(&[&scene, "--mask", "scene.obj"]).contains("--mask hides all"));
}

#[test]
fn a_page_has_one_outline_however_layers_are_parted() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene(folder.path());
    let views = ["--views", "front,top", "--outline", "--layers", "object", "--bridge", "0"];
    let page = svg(&[&[scene.as_str()], &views[..]].concat());
    assert_eq!(attributes(&page, "g", "id").iter().filter(|id| **id == "outline").count(), 1);
    assert!(labels(&page).last().unwrap().ends_with("outline"), "{:?}", labels(&page));
    assert!(refused(&[&scene, "--views", "front,top", "--fit", "view"]).contains("--views"));
}
