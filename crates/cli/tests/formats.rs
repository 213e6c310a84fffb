//! The formats of `lines`, fills and section planes.

use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_silhouettes")).args(arguments).output().unwrap()
}

/// What a command wrote to standard output, and its notes.
fn done(arguments: &[&str]) -> (String, String) {
    let output = run(arguments);
    let notes = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments:?}: {notes}");
    (String::from_utf8(output.stdout).unwrap(), notes)
}

fn refused(arguments: &[&str]) -> String {
    let output = run(arguments);
    let line = String::from_utf8(output.stderr).unwrap();
    assert_eq!((output.status.code(), line.lines().count()), (Some(2), 1), "{arguments:?}: {line}");
    line
}

/// Length of each layer of an SVG of straight paths.
fn svg_lengths(svg: &str) -> BTreeMap<String, f64> {
    let quoted = |text: &str, key: &str| text.split(key).nth(1).unwrap().split('"').next().unwrap().to_owned();
    let length = |ring: &str| {
        let is_closed = ring.ends_with('Z');
        let numbers: Vec<f64> =
            ring.split(['L', 'Z', ' ']).filter(|n| !n.is_empty()).map(|n| n.parse().unwrap()).collect();
        let mut points: Vec<[f64; 2]> = numbers.chunks(2).map(|pair| [pair[0], pair[1]]).collect();
        points.extend(is_closed.then(|| points[0]));
        points.windows(2).map(|pair| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1])).sum::<f64>()
    };
    let layer = |group: &str| {
        let paths = group.split(" d=\"").skip(1).map(|rest| rest.split('"').next().unwrap());
        (quoted(group, "id=\""), paths.flat_map(|data| data.split('M').skip(1)).map(length).sum())
    };
    svg.split("<g ").skip(1).map(layer).collect()
}

/// Length of each layer of a DXF of straight paths.
fn dxf_lengths(dxf: &str) -> BTreeMap<String, f64> {
    let lines: Vec<&str> = dxf.lines().collect();
    let mut lengths = BTreeMap::new();
    let mut points: Vec<[f64; 2]> = Vec::new();
    let (mut layer, mut is_closed, mut is_polyline) = (String::new(), false, false);
    for pair in lines.chunks(2) {
        match (pair[0], pair[1]) {
            ("0", kind) => {
                if is_polyline {
                    points.extend(is_closed.then(|| points[0]));
                    let pairs = points.windows(2);
                    let length: f64 = pairs.map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1])).sum();
                    *lengths.entry(layer.clone()).or_insert(0.0) += length;
                }
                points.clear();
                is_polyline = kind == "LWPOLYLINE";
            }
            ("8", name) => layer = name.to_owned(),
            ("70", flags) => is_closed = flags == "1",
            ("10", x) => points.push([x.parse().unwrap(), 0.0]),
            ("20", y) if is_polyline => points.last_mut().unwrap()[1] = y.parse().unwrap(),
            _ => {}
        }
    }
    lengths
}

#[test]
fn every_format_of_a_page_is_written_and_svg_and_dxf_agree() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let words = ["lines", "builtin:gear", "--view", "iso", "--creases", "30", "--hidden", "--outline", "-o"];
    let mut files = BTreeMap::new();
    for name in ["x.svg", "x.PDF", "x.dxf", "x.hpgl", "x.plt"] {
        assert_eq!(done(&[&words[..], &[&file(name)]].concat()), (String::new(), String::new()), "{name}");
        files.insert(name, std::fs::read(file(name)).unwrap());
    }
    assert!(files["x.PDF"].starts_with(b"%PDF-1.7") && files["x.hpgl"].starts_with(b"IN;\n"));
    assert_eq!(files["x.hpgl"], files["x.plt"]);
    let text = |name: &str| String::from_utf8(files[name].clone()).unwrap();
    let (svg, dxf) = (svg_lengths(&text("x.svg")), dxf_lengths(&text("x.dxf")));
    assert_eq!(svg.keys().collect::<Vec<_>>(), dxf.keys().collect::<Vec<_>>());
    assert!(svg.len() >= 4, "{svg:?}");
    for (layer, length) in &svg {
        assert!((length - dxf[layer]).abs() < 1e-3 * length.max(1.0), "{layer}: {length} and {}", dxf[layer]);
    }
    let line = refused(&["lines", "builtin:cube", "-o", &file("x.dwg")]);
    assert!([".svg", ".pdf", ".dxf", ".hpgl", ".plt", ".json"].iter().all(|end| line.contains(end)), "{line}");
    assert!(!Path::new(&file("x.dwg")).exists());
}

#[test]
fn fills_lie_beneath_the_lines_of_any_colour() {
    let svg = |words: &[&str]| done(&[&["lines", "builtin:torus", "--view", "iso"], words].concat());
    let (plain, _) = svg(&[]);
    for (words, colour) in
        [(&["--fill"][..], "#ffffff"), (&["--fill", "red"], "#ff0000"), (&["--fill=#0a0b0c"], "#0a0b0c")]
    {
        let (filled, notes) = svg(words);
        assert!(notes.is_empty() && filled.contains(&format!("fill=\"{colour}\" stroke=\"none\"")), "{filled}");
        let (mut layers, lines) = (svg_lengths(&filled), svg_lengths(&plain));
        assert!(layers.remove("fill").is_some() && layers == lines, "{layers:?} for {lines:?}");
    }
    let (both, _) = svg(&["--fill", "--outline"]);
    let lengths = svg_lengths(&both);
    assert!((lengths["fill"] - lengths["outline"]).abs() < 1e-9);
    assert!(refused(&["lines", "builtin:torus", "--fill=rgba(0,0,0,0.5)"]).contains("opaque colour"));
    let folder = tempfile::tempdir().unwrap();
    let plt = folder.path().join("x.plt");
    let (_, note) = done(&["lines", "builtin:torus", "--fill", "-o", plt.to_str().unwrap()]);
    assert!(note.contains("note") && note.contains("--fill"), "{note}");
}

fn sections(words: &[&str]) -> (Vec<Value>, String) {
    let folder = tempfile::tempdir().unwrap();
    let json = folder.path().join("x.json");
    let (_, notes) = done(&[&["lines"], words, &["-o", json.to_str().unwrap()]].concat());
    let document: Value = serde_json::from_slice(&std::fs::read(json).unwrap()).unwrap();
    let chains = document["chains"].as_array().unwrap().clone();
    (chains.into_iter().filter(|chain| chain["kind"] == "section").collect(), notes)
}

#[test]
fn a_cube_is_cut_in_a_hexagon() {
    let (found, notes) = sections(&["builtin:cube", "--view", "iso", "--section", "0,0,0,1,1,1"]);
    assert!(notes.is_empty(), "{notes}");
    assert_eq!(found.len(), 1);
    // The diagonals of the faces are cut as well.
    assert!(found[0]["closed"] == true && found[0]["points"].as_array().unwrap().len() == 12);
    // Vertices of the file keep their numbers; those of the section follow.
    let edges = found[0]["edges"].as_array().unwrap();
    assert!(edges.iter().flat_map(|edge| edge.as_array().unwrap()).all(|end| end.as_u64().unwrap() >= 8));

    let two = ["--section", "0,0,0,1,0,0", "--section", "0,0,0,0,0,1"];
    let (found, _) = sections(&[&["builtin:cube", "builtin:torus", "--view", "iso"], &two[..]].concat());
    let objects: Vec<_> = found.iter().map(|chain| chain["object"].as_u64().unwrap()).collect();
    assert!(objects.contains(&0), "{objects:?}");
    let (svg, _) =
        done(&["lines", "builtin:cube", "--view", "iso", "--section", "0,0,0,1,1,1", "--width", "section=1mm"]);
    assert!(svg.contains("section visible\"") && svg.contains("stroke-width=\"1\""), "{svg}");
}

#[test]
fn planes_that_miss_are_noted_and_those_that_leave_nothing_refused() {
    let (found, note) = sections(&["builtin:cube", "--section", "0,9,0,0,1,0"]);
    assert!(found.is_empty() && note.contains("takes nothing away") && note.contains("0,9,0,0,1,0"), "{note}");
    let line = refused(&["lines", "builtin:cube", "--section", "0,9,0,0,-1,0"]);
    assert!(line.contains("leaves nothing") && line.contains("normal"), "{line}");
    for bad in ["0,0,0,0,0,0", "1,2,3", "0,0,0,0,0,x", "nan,0,0,1,0,0"] {
        assert!(refused(&["lines", "builtin:cube", "--section", bad]).contains("--section"), "{bad}");
    }
    refused(&["lines", "builtin:cube", "--smooth", "--section", "0,0,0,1,0,0"]);
}
