//! What `lines` writes.

use serde_json::Value;
use std::process::{Command, Output};

fn silhouettes(arguments: &[&str]) -> Output {
    let output = Command::new(env!("CARGO_BIN_EXE_silhouettes")).args(arguments).output().unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    output
}

fn stdout(arguments: &[&str]) -> String {
    let output = silhouettes(arguments);
    assert!(output.stderr.is_empty(), "silent where stderr is no terminal");
    String::from_utf8(output.stdout).unwrap()
}

/// The first numbers of each path's data, and the names of its layers.
fn layers(svg: &str) -> Vec<(String, usize)> {
    let groups = svg.split("<g ").skip(1);
    let label = |group: &str| group.split("inkscape:label=\"").nth(1).unwrap().split('"').next().unwrap().to_owned();
    groups.map(|group| (label(group), group.matches("<path").count())).collect()
}

fn named(expected: &[(&str, usize)]) -> Vec<(String, usize)> {
    expected.iter().map(|&(name, count)| (name.to_owned(), count)).collect()
}

/// From a corner a cube shows nine edges, six of them silhouette edges, and hides three.
#[test]
fn a_cube_shows_nine_edges_and_hides_three() {
    let found: Value =
        serde_json::from_str(&lines_json(&["builtin:cube", "--view", "iso", "--creases", "30", "--hidden"])).unwrap();
    let chains = found["chains"].as_array().unwrap();
    let edges = |visible: bool| -> usize {
        chains
            .iter()
            .filter(|chain| chain["visible"] == visible)
            .map(|chain| chain["edges"].as_array().unwrap().len())
            .sum()
    };
    assert_eq!((edges(true), edges(false)), (9, 3));
    let svg = stdout(&["lines", "builtin:cube", "--view", "iso", "--creases", "30", "--hidden=solid"]);
    let hidden_and_visible: Vec<_> = layers(&svg).into_iter().map(|(name, _)| name).collect();
    assert_eq!(hidden_and_visible, ["23 ridge hidden", "3 ridge visible", "1 silhouette visible"]);
    assert!(svg.contains("width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\""), "{svg}");
    assert!(svg.contains("<title>Lines of builtin:cube</title>"), "{svg}");
}

fn lines_json(arguments: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.json");
    let words: Vec<_> = ["lines"].iter().chain(arguments).copied().chain(["-o", path.to_str().unwrap()]).collect();
    silhouettes(&words);
    std::fs::read_to_string(&path).unwrap()
}

/// A cube of side 1 at true scale, 30 mm a unit: its front is a square of 30 mm.
#[test]
fn true_scale_is_in_millimetres() {
    let svg = stdout(&["lines", "builtin:cube", "--ortho", "fit", "--view", "front", "--scale", "30"]);
    assert_eq!(layers(&svg), named(&[("1 silhouette visible", 1)]));
    let data = svg.split(" d=\"M").nth(1).unwrap().split('"').next().unwrap();
    let numbers: Vec<f64> =
        data.split(['L', ' ', 'Z']).filter(|word| !word.is_empty()).map(|word| word.parse().unwrap()).collect();
    let cube: Value = serde_json::from_str(&stdout(&["inspect", "builtin:cube", "--json"])).unwrap();
    let side =
        |axis: usize| cube["extent"]["max"][axis].as_f64().unwrap() - cube["extent"]["min"][axis].as_f64().unwrap();
    for axis in 0..2 {
        let coordinates = || numbers.iter().copied().skip(axis).step_by(2);
        let extent = coordinates().fold(f64::MIN, f64::max) - coordinates().fold(f64::MAX, f64::min);
        assert!((extent - 30.0 * side(axis)).abs() < 2e-3, "{extent} along axis {axis}");
    }
    let large = silhouettes(&["lines", "builtin:cube", "--ortho", "fit", "--scale", "3000"]);
    let note = String::from_utf8(large.stderr).unwrap();
    assert!(note.contains("cut off") && note.lines().count() == 1, "{note}");
}

#[test]
fn runs_and_thread_counts_write_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["x.svg", "x.json", "x.gltf", "x.glb"] {
        let write = |threads: Option<&str>| {
            let path = folder.path().join(name);
            let mut command = Command::new(env!("CARGO_BIN_EXE_silhouettes"));
            command.args(["lines", "builtin:knot", "--view", "iso", "--all-edges", "--hidden", "-o"]).arg(&path);
            if let Some(threads) = threads {
                command.env("RAYON_NUM_THREADS", threads);
            }
            assert!(command.status().unwrap().success());
            std::fs::read(&path).unwrap()
        };
        let bytes = write(None);
        assert!(bytes.len() > 10_000, "{name}: {}", bytes.len());
        assert_eq!(write(None), bytes, "{name}");
        assert_eq!(write(Some("1")), bytes, "{name}");
    }
}

/// Objects keep their numbers and their own vertices.
#[test]
fn several_meshes_are_several_objects() {
    let found: Value = serde_json::from_str(&lines_json(&["builtin:cube", "builtin:torus", "--hidden"])).unwrap();
    for object in [0, 1] {
        let chains = found["chains"].as_array().unwrap().iter().filter(|chain| chain["object"] == object);
        let vertices: Vec<u64> = chains
            .flat_map(|chain| chain["edges"].as_array().unwrap().clone())
            .flat_map(|edge| [edge[0].as_u64().unwrap(), edge[1].as_u64().unwrap()])
            .collect();
        let limit = if object == 0 { 8 } else { 1 << 20 };
        assert!(!vertices.is_empty() && vertices.iter().all(|&vertex| vertex < limit), "{object}: {vertices:?}");
    }
    let alone: Value = serde_json::from_str(&lines_json(&["builtin:torus"])).unwrap();
    assert!(alone["chains"].as_array().unwrap().iter().all(|chain| chain["object"] == 0));
}

#[test]
fn stats_tell_times_and_travel() {
    let output = silhouettes(&["lines", "builtin:gear", "--creases", "20", "--stats"]);
    let text = String::from_utf8(output.stderr).unwrap();
    for word in ["extract", "decide", "paths", "pen-up travel", "bytes"] {
        assert!(text.contains(word), "{text}");
    }
    let unsorted = silhouettes(&["lines", "builtin:gear", "--creases", "20", "--stats", "--no-sort"]);
    let row = |text: &str| text.lines().find(|line| line.starts_with("pen-up")).unwrap().to_owned();
    let numbers =
        |row: &str| -> Vec<f64> { row.split(' ').filter_map(|word| word.strip_suffix("mm")?.parse().ok()).collect() };
    let sorted = numbers(&row(&text));
    let unsorted = numbers(&row(std::str::from_utf8(&unsorted.stderr).unwrap()));
    assert!(sorted[1] < sorted[0] && (unsorted[0], unsorted[1]) == (sorted[0], sorted[0]), "{sorted:?} {unsorted:?}");
}

#[test]
fn an_eye_inside_of_a_mesh_is_no_failure() {
    let svg = stdout(&["lines", "builtin:cube", "--eye", "0,0,0", "--all-edges"]);
    assert!(svg.ends_with("</svg>\n"));
}

/// On a cube nothing is finer than a pixel: the same six silhouette edges, or a line that says that there is no adapter.
#[test]
fn the_quick_mode_finds_a_cubes_outline() {
    let run = |options: &[&str]| Command::new(env!("CARGO_BIN_EXE_silhouettes")).args(options).output().unwrap();
    let output = run(&["lines", "builtin:cube", "--quick"]);
    if output.status.success() {
        let svg = String::from_utf8(output.stdout).unwrap();
        assert_eq!(layers(&svg).len(), layers(&stdout(&["lines", "builtin:cube"])).len());
    } else {
        assert!(std::env::var_os("SILHOUETTES_GPU").is_none_or(|value| value != "require"), "{output:?}");
        assert_eq!(output.status.code(), Some(1));
    }
    let refused = run(&["lines", "builtin:cube", "--quick", "--hidden"]);
    assert_eq!(refused.status.code(), Some(2));
}

/// A strip of two squares in one plane, of two materials, its vertices given for each square anew.
#[test]
fn borders_of_materials_are_drawn_where_seams_are_welded() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("strip.obj");
    let rows = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\n";
    std::fs::write(&path, format!("{rows}usemtl red\nf 1 2 3 4\nusemtl blue\nf 5 6 7 8\n")).unwrap();
    let path = path.to_str().unwrap();
    let kinds = |arguments: &[&str]| {
        let words = [&[path, "--view", "front"], arguments].concat();
        let found: Value = serde_json::from_str(&lines_json(&words)).unwrap();
        let chains = found["chains"].as_array().unwrap();
        let length = |kind: &str| -> usize {
            let of_kind = chains.iter().filter(|chain| chain["kind"] == kind);
            of_kind.map(|chain| chain["edges"].as_array().unwrap().len()).sum()
        };
        (length("boundary"), length("material"))
    };
    assert_eq!(kinds(&[]), (8, 0), "the seam is a boundary of both squares");
    assert_eq!(kinds(&["--weld"]), (6, 0));
    assert_eq!(kinds(&["--weld", "--materials"]), (6, 1));
    assert_eq!(kinds(&["--weld=0.001", "--materials"]), (6, 1));
    let output = silhouettes(&["lines", "builtin:cube", "--materials"]);
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(told.contains("builtin:cube: all faces are of one material and group"), "{told}");
}

/// A square beside two rectangles of half its height: a vertex that both rectangles share divides its edge in the middle.
#[test]
fn t_junctions_are_boundaries_until_they_are_healed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("t.obj");
    let left = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n";
    let right = "v 3 0 0\nv 3 1 0\nv 2 1 0\nv 3 2 0\nf 2 5 6 7\nf 7 6 8 3\n";
    std::fs::write(&path, format!("{left}{right}")).unwrap();
    let path = path.to_str().unwrap();
    let drawn = |arguments: &[&str]| {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("x.json");
        let words = [&["lines", path, "--view", "front", "-o", file.to_str().unwrap()], arguments].concat();
        let output = silhouettes(&words);
        let found: Value = serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap();
        let chains = found["chains"].as_array().unwrap().clone();
        let edges: usize = chains.iter().map(|chain| chain["edges"].as_array().unwrap().len()).sum();
        (edges, String::from_utf8(output.stderr).unwrap())
    };
    let (edges, notes) = drawn(&[]);
    assert_eq!((edges, notes.as_str()), (10, ""), "three edges run along the junction");
    let (edges, notes) = drawn(&["--heal"]);
    assert!(edges == 7 && notes.contains("divided at T-junctions: 1"), "{edges}: {notes}");
    assert_eq!(drawn(&["--heal=0.5"]).0, 7);
    assert_eq!(drawn(&["--no-boundaries"]).0, 0);
}

/// Straight chords of the cubic paths of an SVG in its own units, eight a curve, path by path; and whether each path is closed.
fn cubics(svg: &str) -> Vec<(Vec<[f64; 2]>, bool)> {
    let path = |data: &str| {
        let data = data.split('"').next().unwrap();
        let words = data.trim_end_matches('Z').split(['C', ' ']).filter(|word| !word.is_empty());
        let numbers: Vec<f64> = words.map(|word| word.parse().unwrap()).collect();
        let points: Vec<[f64; 2]> = numbers.chunks(2).map(|pair| [pair[0], pair[1]]).collect();
        assert_eq!(points.len() % 3, 1, "cubics only");
        let curves = points.windows(4).step_by(3).flat_map(|control| {
            (0..8).map(|i| {
                let t = f64::from(i) / 8.0;
                let s = 1.0 - t;
                let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
                [0, 1].map(|axis| control.iter().zip(weights).map(|(point, weight)| point[axis] * weight).sum())
            })
        });
        (curves.chain(points.last().copied()).collect(), data.ends_with('Z'))
    };
    svg.split(" d=\"M").skip(1).map(path).collect()
}

fn length(path: &[[f64; 2]]) -> f64 {
    path.windows(2).map(|pair| (pair[0][0] - pair[1][0]).hypot(pair[0][1] - pair[1][1])).sum()
}

fn smooth(mesh: &str, options: &[&str]) -> String {
    stdout(&[&["lines", mesh, "--smooth", "--units", "px"], options].concat())
}

/// Of a sphere of radius 1 seen in a window of height 2.5, the silhouette is a circle of 1024 / 2.5 pixels.
#[test]
fn a_coarse_sphere_has_one_smooth_outline() {
    let view = ["--view", "front", "--ortho", "2.5"];
    let error = |paths: &[(Vec<[f64; 2]>, bool)]| {
        let radius = |point: &[f64; 2]| (point[0] - 512.0).hypot(point[1] - 512.0) / 1024.0 * 2.5;
        paths.iter().flat_map(|(points, _)| points).map(|point| (radius(point) - 1.0).abs()).fold(0.0, f64::max)
    };
    for (level, most) in [(1, 0.02), (2, 0.004), (3, 0.001)] {
        let mesh = format!("builtin:icosphere:{level}");
        let paths = cubics(&smooth(&mesh, &view));
        assert!(paths.len() == 1 && paths[0].1, "one closed curve of {mesh}, {} paths", paths.len());
        assert!(error(&paths) < most, "{mesh}: {}", error(&paths));
        let hidden = smooth(&mesh, &[&view[..], &["--hidden=solid"]].concat());
        assert_eq!(layers(&hidden), named(&[("1 silhouette visible", 1)]), "nothing of it is hidden");
    }
    // Seen in perspective, from every side.
    for view in ["front", "right", "top", "iso", "three-quarter"] {
        let paths = cubics(&smooth("builtin:icosphere:1", &["--view", view]));
        assert!(paths.len() == 1 && paths[0].1, "{view}");
    }
}

#[test]
fn a_torus_along_its_axis_shows_two_circles_and_from_above_hides_the_ends_of_one() {
    let along = cubics(&smooth("builtin:torus:24,12", &["--view", "top", "--ortho", "fit"]));
    assert!(along.len() == 2 && along.iter().all(|(_, closed)| *closed));
    let radii = along.iter().map(|(points, _)| (points[0][0] - 512.0).hypot(points[0][1] - 512.0));
    let [one, other] = radii.collect::<Vec<_>>()[..] else { unreachable!() };
    let [small, large] = [one.min(other), one.max(other)];
    let torus: Value = serde_json::from_str(&stdout(&["inspect", "builtin:torus:24,12", "--json"])).unwrap();
    let [reach, height] = [0, 1].map(|axis| torus["extent"]["max"][axis].as_f64().unwrap());
    // Of a tube of radius r about a circle of radius R the circles have radii R - r and R + r = reach.
    let expected = (reach - 2.0 * height) / reach;
    assert!((small / large - expected).abs() < 0.01, "{} instead of {expected}", small / large);
    let paths = cubics(&smooth("builtin:torus", &[]));
    assert_eq!(paths.iter().filter(|(_, closed)| *closed).count(), 1, "the outer one");
    assert_eq!(paths.len(), 2, "and the visible part of the inner one");
}

/// Coarse and fine meshes of one knot show the same length, where edges of the coarse one zigzag.
#[test]
fn hidden_parts_of_a_knot_are_left_out_whatever_its_mesh() {
    for view in ["three-quarter", "front", "iso"] {
        let total = |mesh: &str, more: &[&str]| -> f64 {
            let options = [&["--view", view], more].concat();
            cubics(&smooth(mesh, &options)).iter().map(|(points, _)| length(points)).sum()
        };
        let [coarse, fine] = ["builtin:knot:2,3,80,8", "builtin:knot:2,3,720,32"].map(|mesh| total(mesh, &[]));
        assert!((coarse / fine - 1.0).abs() < 0.01, "{view}: {coarse} and {fine}");
        // The control: with what is hidden, it is more by much more than that.
        let all = total("builtin:knot:2,3,80,8", &["--hidden=solid"]);
        assert!(all > 1.1 * coarse, "{view}: {all} and {coarse}");
    }
}

#[test]
fn smooth_lines_keep_their_kinds_layers_and_files() {
    let names = |svg: &str| layers(svg).into_iter().map(|(name, _)| name).collect::<Vec<_>>();
    let cube = smooth("builtin:cube", &["--view", "iso", "--creases", "30", "--hidden", "--dash", "ridge=3px,1px"]);
    assert_eq!(names(&cube), ["23 ridge hidden", "3 ridge visible", "1 silhouette visible"]);
    assert_eq!(names(&smooth("builtin:grid", &["--view", "iso"])), ["2 boundary visible"]);
    let from_behind = smooth("builtin:grid", &["--eye", "0.1,-5,0.2"]);
    assert_eq!(names(&from_behind), ["2 boundary visible"], "a sheet has the same rim from behind");
    let none = silhouettes(&["lines", "builtin:grid", "--smooth", "--view", "iso", "--no-boundaries"]);
    assert!(layers(std::str::from_utf8(&none.stdout).unwrap()).is_empty() && !none.stderr.is_empty());
    assert_eq!(names(&smooth("builtin:torus", &["--outline=only"])), ["40 outline"]);

    let both = ["builtin:icosphere:1", "builtin:torus", "--smooth"];
    let found: Value = serde_json::from_str(&lines_json(&both)).unwrap();
    let chains = found["chains"].as_array().unwrap();
    assert!([0, 1].iter().all(|object| chains.iter().any(|chain| chain["object"] == *object)));
    for chain in chains {
        let count = |field: &str| chain[field].as_array().unwrap().len();
        assert_eq!(
            (count("edges"), count("curves"), chain["kind"].as_str()),
            (0, count("handles"), Some("silhouette"))
        );
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.gltf");
    silhouettes(&["lines", "builtin:torus", "--smooth", "-o", path.to_str().unwrap()]);
    assert!(std::fs::read_to_string(path).unwrap().contains("silhouette"));
}
