//! `score`: what other programs drew, and what is refused of it.

use serde_json::Value;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};
use tempfile::TempDir;

/// Three views of one mesh in small pictures.
const SCENE: &str = r#"
meshes = ["builtin:knot"]

[path]
kind = "orbit"
projection = "perspective"
fov-deg = 40
first-azimuth-deg = 20
elevation-deg = 25
swing-deg = 5
step-deg = 7
warm-up = 1
frames = 9
scored = 3

[picture]
width = 200
height = 160
samples = 1

[pen]
width-px = 3
"#;

struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        fs::write(folder.path("mine.toml"), SCENE).unwrap();
        folder
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn file(&self, name: &str, bytes: impl AsRef<[u8]>) -> String {
        fs::write(self.path(name), bytes).unwrap();
        self.text(name)
    }

    fn text(&self, name: &str) -> String {
        self.path(name).to_str().unwrap().to_owned()
    }

    fn scene(&self) -> String {
        self.text("mine.toml")
    }

    /// Runs a command in the folder.
    fn run(&self, arguments: &[&str]) -> Output {
        Command::new(env!("CARGO_BIN_EXE_silhouettes")).args(arguments).current_dir(&self.0).output().unwrap()
    }

    fn done(&self, arguments: &[&str]) -> String {
        let output = self.run(arguments);
        assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    }

    /// The one line with which a command is refused.
    fn refused(&self, arguments: &[&str]) -> String {
        let output = self.run(arguments);
        let line = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), line.lines().count()), (Some(2), 1), "{arguments:?}: {line}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
        line
    }

    fn cameras(&self) -> Value {
        serde_json::from_str(&self.done(&["score", "--scene", &self.scene(), "--cameras"])).unwrap()
    }

    /// Options by which other commands look through the camera of a view.
    fn options(camera: &Value) -> Vec<String> {
        let vector = |name: &str| {
            let numbers = camera[name].as_array().unwrap().iter().map(ToString::to_string);
            numbers.collect::<Vec<_>>().join(",")
        };
        let size = camera["size"].as_array().unwrap();
        let words = [
            ("--eye", vector("eye")),
            ("--target", vector("target")),
            ("--up", vector("up")),
            ("--fov", camera["fov_y_deg"].to_string()),
            ("--size", format!("{}x{}", size[0], size[1])),
        ];
        words.into_iter().flat_map(|(option, value)| [option.to_owned(), value]).collect()
    }

    /// Writes what a command makes of each view to `NAME-FRAME.ENDING`; yields the pattern.
    fn write_views(&self, command: &[&str], name: &str, ending: &str) -> String {
        for camera in self.cameras()["views"].as_array().unwrap() {
            let file = format!("{name}-{}.{ending}", camera["frame"]);
            let options = Self::options(camera);
            let options: Vec<&str> = options.iter().map(String::as_str).collect();
            self.done(&[command, &options, &["-o", &file]].concat());
        }
        format!("{name}-{{frame}}.{ending}")
    }

    /// Scores files of all views; yields the views' results.
    fn score(&self, pattern: &str) -> Vec<Value> {
        self.done(&["score", "--scene", &self.scene(), "--lines", pattern, "-o", "out"]);
        let cell: Value = serde_json::from_str(&fs::read_to_string(self.path("out/results.jsonl")).unwrap()).unwrap();
        cell["views"].as_array().unwrap().clone()
    }
}

fn metric(view: &Value, name: &str) -> f64 {
    view["metrics"]["lines"][name].as_f64().unwrap()
}

/// Exact lines of ours that another program might have drawn, as JSON and SVG.
#[test]
fn exact_lines_score_perfectly_in_every_form() {
    let folder = Folder::new();
    let edges = folder.write_views(&["extract", "builtin:knot"], "edges", "json");
    let chains = folder.write_views(&["lines", "builtin:knot", "--hidden"], "chains", "json");
    let strokes = folder.write_views(&["lines", "builtin:knot", "--units", "px"], "strokes", "svg");
    for (pattern, within) in [(edges, 0.0), (chains, 0.0), (strokes, 0.02)] {
        let views = folder.score(&pattern);
        assert_eq!(views.iter().map(|view| view["frame"].as_u64().unwrap()).collect::<Vec<_>>(), [1, 4, 7]);
        for view in &views {
            for name in ["missed_0_5px", "spurious_0_5px", "gaps_per_1000px"] {
                assert!(metric(view, name).abs() < 1e-12, "{pattern} {name}: {view}");
            }
            assert!(metric(view, "chamfer_px") <= within, "{pattern}: {view}");
            let is_edges = pattern.starts_with("edges");
            assert_eq!(view["edges"]["recall"].as_f64(), is_edges.then_some(1.0));
            assert_eq!(view["edges"]["precision"].as_f64(), is_edges.then_some(1.0));
        }
    }
}

#[test]
fn drawings_made_worse_score_worse() {
    let folder = Folder::new();
    let chains = folder.write_views(&["lines", "builtin:knot"], "chains", "json");
    let changed = |name: &str, change: &dyn Fn(&mut Value)| {
        for frame in [1, 4, 7] {
            let text = fs::read_to_string(folder.path(&chains.replace("{frame}", &frame.to_string()))).unwrap();
            let mut document: Value = serde_json::from_str(&text).unwrap();
            change(&mut document["chains"]);
            folder.file(&format!("{name}-{frame}.json"), document.to_string());
        }
        folder.score(&format!("{name}-{{frame}}.json"))
    };
    let length = |chain: &Value| chain["pixels"].as_array().unwrap().len();
    let fewer = changed("fewer", &|chains| {
        let chains = chains.as_array_mut().unwrap();
        let longest = (0..chains.len()).max_by_key(|&at| length(&chains[at])).unwrap();
        chains.remove(longest);
    });
    let is_less = |view: &Value| metric(view, "missed_2px") > 0.05 && metric(view, "spurious_0_5px").abs() < 1e-12;
    assert!(fewer.iter().all(is_less), "{fewer:?}");
    let shifted = changed("shifted", &|chains| {
        for point in chains.as_array_mut().unwrap().iter_mut().flat_map(|chain| chain["pixels"].as_array_mut().unwrap())
        {
            point[1] = (point[1].as_f64().unwrap() + 3.0).into();
        }
    });
    assert!(
        shifted.iter().all(|view| metric(view, "missed_0_5px") > 0.3 && metric(view, "chamfer_px") > 0.5),
        "{shifted:?}"
    );
    let mirrored = changed("mirrored", &|chains| {
        for point in chains.as_array_mut().unwrap().iter_mut().flat_map(|chain| chain["pixels"].as_array_mut().unwrap())
        {
            point[0] = (200.0 - point[0].as_f64().unwrap()).into();
        }
    });
    assert!(
        mirrored.iter().all(|view| metric(view, "missed_2px") > 0.1 && metric(view, "spurious_2px") > 0.1),
        "{mirrored:?}"
    );
}

fn png(color: impl Fn(u32, u32) -> [u8; 4]) -> Vec<u8> {
    let picture = image::RgbaImage::from_fn(200, 160, |x, y| image::Rgba(color(x, y)));
    let mut bytes = std::io::Cursor::new(Vec::new());
    picture.write_to(&mut bytes, image::ImageFormat::Png).unwrap();
    bytes.into_inner()
}

#[test]
fn pictures_are_judged_as_they_are() {
    let folder = Folder::new();
    let edges = folder.write_views(&["extract", "builtin:knot"], "edges", "json");
    folder.score(&edges);
    for frame in [1, 4, 7] {
        fs::copy(folder.path(&format!("out/images/{frame:05}-truth.png")), folder.path(&format!("truth-{frame}.png")))
            .unwrap();
        folder.file(&format!("blank-{frame}.png"), png(|_, _| [0; 4]));
    }
    for view in folder.score("truth-{frame}.png") {
        assert!(metric(&view, "missed_0_5px").abs() < 1e-12 && metric(&view, "spurious_0_5px").abs() < 1e-12);
    }
    for view in folder.score("blank-{frame}.png") {
        assert!((metric(&view, "missed_2px") - 1.0).abs() < 1e-12 && metric(&view, "spurious_0_5px").abs() < 1e-12);
    }
}

#[test]
fn a_single_view_needs_no_scene() {
    let folder = Folder::new();
    let view = ["--eye", "2,1.5,3", "--size", "160x120"];
    folder.done(&[&["lines", "builtin:knot", "-o", "mine.json"], &view[..]].concat());
    let table = folder.done(&[&["score", "builtin:knot", "--lines", "mine.json"], &view[..]].concat());
    assert!(
        table.starts_with("mine on builtin:knot, pen of 2 px\nframe  ") && table.ends_with("Misses nothing.\n"),
        "{table}"
    );
    let one_frame = SCENE.replace("frames = 9", "frames = 1").replace("scored = 3", "scored = 1");
    folder.file("one.toml", one_frame);
    let cameras: Value = serde_json::from_str(&folder.done(&["score", "--scene", "one.toml", "--cameras"])).unwrap();
    let options = Folder::options(&cameras["views"][0]);
    let options: Vec<&str> = options.iter().map(String::as_str).collect();
    folder.done(&[&["extract", "builtin:knot", "-o", "one.json"], &options[..]].concat());
    let table = folder.done(&["score", "--scene", "one.toml", "--lines", "one.json", "--name", "theirs"]);
    assert!(table.starts_with("theirs on builtin:knot, pen of 3 px\n"), "{table}");
    assert!(table.lines().nth(2).unwrap().ends_with("  1            1"), "precision and recall: {table}");
}

#[test]
fn results_are_files_that_a_later_score_replaces() {
    let folder = Folder::new();
    let edges = folder.write_views(&["extract", "builtin:knot"], "edges", "json");
    for _ in 0..2 {
        folder.score(&edges);
    }
    let table = fs::read_to_string(folder.path("out/results.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    let value = |name: &str| rows[1][rows[0].iter().position(|column| *column == name).unwrap()];
    assert_eq!((rows.len(), value("method"), value("edge_recall"), value("frame_ms")), (4, "edges", "1", ""));
    folder.file("out/mine.txt", "mine");
    let line = folder.refused(&["score", "--scene", &folder.scene(), "--lines", &edges, "-o", "out"]);
    assert!(line.contains("mine.txt: lies in the score that would be replaced"), "{line}");
}

#[test]
fn what_cannot_be_scored_is_refused_with_file_place_and_mend() {
    let folder = Folder::new();
    let refused = |name: &str, text: &str| {
        folder.file(name, text);
        let line = folder.refused(&["score", "--scene", &folder.scene(), "--lines", name, "--frame", "4"]);
        assert!(line.starts_with(&format!("silhouettes: {name}: ")), "{line}");
        line
    };
    for (name, text, expected) in [
        (
            "a.json",
            r#"{"edges":[[0,1],[5,5760]]}"#,
            "edges[1]: names vertex 5760, but builtin:knot has 5760 vertices, from 0",
        ),
        ("a.json", r#"{"edges":[[0,1000]]}"#, "edges[0]: is [0, 1000], but builtin:knot has no face with such an edge"),
        ("a.json", r#"{"edges":[]}"#, "holds no line; for a drawing without lines give a white picture"),
        ("a.json", r#"{"polylines":[[[NaN,2],[3,4]]]}"#, "NaN is no finite number; leave such points out"),
        ("a.json", r#"{"polylines":[[[900,2],[900,4]]]}"#, "holds no line inside of the picture: all 1 lie beside it"),
        (
            "a.json",
            r#"{"polylines":[],"size":[160,200]}"#,
            "size: is 160 x 200 pixels, but the view is 200 x 160 pixels",
        ),
        ("a.json", r#"{"vertices":[]}"#, "unknown form: it has none of these; give one of \"polylines\""),
        ("a.json", "{\"edges\":\n [[0,1]", "line 2, column 7: EOF while parsing"),
        ("a.svg", "<svg viewBox='0 0 200 200'/>", "is 200 x 200 units, but the view is 200 x 160 pixels"),
        ("a.svg", "<svg>\n<path d='M0 0 L x'/>", "line 1, column 1: the root node was opened but never closed"),
        ("a.svg", "<svg>\n<path stroke='red' d='M0 0 L x'/></svg>", "line 2: d: "),
        ("a.svg", "<svg><path d='M0 0 L 9 9'/></svg>", "holds no line: none of its 1 shapes has a stroke"),
        ("a.png", "no picture", "PNG: no picture of this kind"),
        ("a.obj", "v 0 0 0", "unknown form; lines are read from .json and .svg, pictures from .png"),
    ] {
        let line = refused(name, text);
        assert!(line.contains(expected), "wanted '{expected}' in: {line}");
    }
    folder.file("small.png", {
        let mut bytes = std::io::Cursor::new(Vec::new());
        image::RgbaImage::new(100, 80).write_to(&mut bytes, image::ImageFormat::Png).unwrap();
        bytes.into_inner()
    });
    let scene = folder.scene();
    let of = |arguments: &[&str]| folder.refused(&[&["score"], arguments].concat());
    let line = of(&["--scene", &scene, "--lines", "small.png", "--frame", "1"]);
    assert!(
        line.contains("small.png: is 100 x 80 pixels, but the view is 200 x 160 pixels; draw it at that size"),
        "{line}"
    );
    let line = of(&["--scene", &scene, "--lines", "a.svg"]);
    assert!(line.contains("1 files for 3 scored frames (1, 4, 7); give --frame N"), "{line}");
    let line = of(&["--scene", &scene, "--lines", "a.svg", "--frame", "3"]);
    assert!(line.contains("--frame 3: is no scored frame; there are 1, 4, 7"), "{line}");
    assert!(of(&["--scene", &scene, "--lines", "{frame}.svg"]).contains("1.svg: "));
    assert!(of(&["--scene", &scene, "--lines", "a.svg", "--fov", "30"]).contains("the scene says where the camera is"));
    assert!(of(&["--lines", "a.svg"]).contains("name a mesh"));
    assert!(of(&["--profile", "quick", "--cameras"]).contains("has several meshes (builtin:torus, "));
    assert!(of(&["builtin:knot", "--scene", &scene]).contains("--lines"));
}

/// A file made by another camera is refused rather than found to be wrong everywhere.
#[test]
fn a_file_of_another_view_is_refused() {
    let folder = Folder::new();
    let edges = folder.write_views(&["extract", "builtin:knot"], "edges", "json");
    let other = edges.replace("{frame}", "4");
    let line = folder.refused(&["score", "--scene", &folder.scene(), "--lines", &other, "--frame", "7"]);
    assert!(line.contains("edges-4.json: viewpoint: is from ") && line.contains("but frame 7 has "), "{line}");
    let line =
        folder.refused(&["score", "builtin:gear", "--scene", &folder.scene(), "--lines", &other, "--frame", "4"]);
    assert!(line.contains("edges-4.json: mesh.vertices: was made of 5760 vertices, but builtin:gear has "), "{line}");
}

/// A file that no reader could hold is refused while it is read.
#[test]
fn files_beyond_all_measure_are_refused() {
    let folder = Folder::new();
    let big = fs::File::create(folder.path("big.svg")).unwrap();
    big.set_len(1 << 40).unwrap();
    let line = folder.refused(&["score", "--scene", &folder.scene(), "--lines", "big.svg", "--frame", "4"]);
    assert!(line.contains("big.svg: longer than 67108864 bytes"), "{line}");
    // Noise whose lines cross each other millions of times.
    let point = |at: u32| format!("[{},{}]", at * 7919 % 200, at * 104_729 % 160);
    let noise: Vec<String> = (0..9000).map(point).collect();
    folder.file("noise.json", format!("{{\"polylines\":[[{}]]}}", noise.join(",")));
    let line = folder.refused(&["score", "--scene", &folder.scene(), "--lines", "noise.json", "--frame", "4"]);
    assert!(line.contains("noise.json: its lines cross each other too often"), "{line}");
}

/// Two squares side by side whose common vertices are there twice: a seam to this program, one edge to those that join vertices.
const SEAM: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nf 1 2 3 4\nf 5 6 7 8\n";

#[test]
fn seams_are_no_lines_where_vertices_are_joined() {
    let folder = Folder::new();
    folder.file("seam.obj", SEAM);
    let view = ["--view", "front", "--size", "100x100"];
    let with = |words: &[&str]| folder.done(&[words, &view].concat());
    with(&["lines", "seam.obj", "--weld", "-o", "joined.json"]);
    let joined = with(&["score", "seam.obj", "--weld", "--lines", "joined.json"]);
    let apart = with(&["score", "seam.obj", "--lines", "joined.json"]);
    assert!(joined.ends_with("Misses nothing.\n") && apart.contains("along boundary edges"), "{joined}{apart}");
    with(&["extract", "seam.obj", "--weld", "-o", "edges.json"]);
    let table = with(&["score", "seam.obj", "--weld", "--lines", "edges.json"]);
    assert!(table.lines().nth(2).unwrap().ends_with("  1            1"), "{table}");
    let line = folder.refused(&[&["score", "seam.obj", "--lines", "edges.json"][..], &view].concat());
    assert!(line.contains("mesh.vertices: was made of 6 vertices, but seam.obj has 8"), "{line}");
}
