//! What `render` draws: several meshes as one picture, and transparent grounds by every method.

use silhouette_testing::skipped;
use std::path::Path;
use std::process::{Command, Output};
use tempfile::TempDir;

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_silhouettes")).args(arguments).output().unwrap()
}

/// A picture by `render`, if there is an adapter.
fn picture(folder: &TempDir, arguments: &[&str]) -> Option<image::RgbaImage> {
    let file = folder.path().join("x.png");
    let output = run(&[&["render"], arguments, &["-o", file.to_str().unwrap()]].concat());
    let message = String::from_utf8_lossy(&output.stderr);
    if output.status.code() == Some(1) && message.contains("adapter") && std::env::var("SILHOUETTES_GPU").is_err() {
        skipped("render", &message);
        return None;
    }
    assert!(output.status.success(), "{arguments:?}: {message}");
    Some(image::open(file).unwrap().into_rgba8())
}

/// Every method that draws leaves the ground transparent; those that draw lines alone the inside of outlines, too.
#[test]
fn grounds_are_transparent_by_every_method() {
    let folder = tempfile::tempdir().unwrap();
    let doctor = String::from_utf8(run(&["doctor"]).stdout).unwrap();
    let rows = doctor.lines().skip_while(|line| !line.starts_with("method")).skip(1);
    let mut drawn = 0;
    for row in rows {
        let name = row.split_whitespace().next().unwrap();
        let yields = |what: &str| row.split_whitespace().any(|word| word.trim_end_matches(',') == what);
        if !["edges", "lines", "fill"].into_iter().any(yields) {
            let output =
                run(&["render", "builtin:cube", "--method", name, "-o", folder.path().join("x.png").to_str().unwrap()]);
            let line = String::from_utf8(output.stderr).unwrap();
            assert!(output.status.code() == Some(2) && line.contains(name) && line.contains("extract"), "{line}");
            continue;
        }
        let options: &[&str] = match name {
            "texture" | "texture-lines" | "normal-map-hull" => &["--set", "size=64", "--set", "hull-vertices=60"],
            // With fewer, it may find no loop at all.
            "randomized" => &["--set", "probes=1"],
            _ => &[],
        };
        let words = ["builtin:icosphere:3", "--method", name, "--size", "64x64", "--view", "front", "--transparent"];
        let Some(image) = picture(&folder, &[&words[..], options].concat()) else { return };
        let alpha = |x: u32, y: u32| image.get_pixel(x, y).0[3];
        assert!([alpha(0, 0), alpha(63, 0), alpha(0, 63), alpha(63, 63)] == [0; 4], "{name}: the ground");
        assert_eq!(alpha(32, 32) > 0, yields("fill"), "{name}: the middle");
        assert!(image.pixels().any(|pixel| pixel.0[3] == u8::MAX), "{name}: nothing is drawn");
        drawn += 1;
    }
    assert!(drawn >= 15, "{drawn} methods in: {doctor}");
}

/// Two boxes, a large one with a small one in front of it, in files of their own.
fn boxes(folder: &TempDir) -> [String; 2] {
    const FACES: &str = "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    let write = |name: &str, side: f64, z: f64| {
        let square = [[-side, -side], [side, -side], [side, side], [-side, side]];
        let corners = [z, z + 0.2].map(|z| square.map(|[x, y]| format!("v {x} {y} {z}\n")).concat());
        let path = folder.path().join(name);
        std::fs::write(&path, corners.concat() + FACES).unwrap();
        path.to_str().unwrap().to_owned()
    };
    [write("far.obj", 1.0, 0.0), write("near.obj", 0.5, 1.0)]
}

#[test]
fn several_meshes_hide_each_other_and_keep_their_own_edges() {
    let folder = tempfile::tempdir().unwrap();
    let [far, near] = boxes(&folder);
    let view = ["--view", "front", "--ortho", "2.4", "--size", "120x120", "--width", "3"];
    for method in ["brute-force", "image-precision", "edge-mesh"] {
        let ink = |meshes: &[&str]| {
            let image = picture(&folder, &[meshes, &["--method", method], &view].concat())?;
            // Along a line from the middle to the right, past both borders at 25 and 50 pixels.
            Some((60..120).filter(|&x| image.get_pixel(x, 62).0[0] < 128).collect::<Vec<_>>())
        };
        let (Some(both), Some(one)) = (ink(&[&far, &near]), ink(&[&far])) else { return };
        assert!(
            both.iter().any(|x| x.abs_diff(85) <= 2) && both.iter().any(|x| x.abs_diff(110) <= 2),
            "{method}: {both:?}"
        );
        assert!(one.iter().all(|x| x.abs_diff(110) <= 2) && !one.is_empty(), "{method}: {one:?}");
    }
    // Seen from behind, the small box is hidden by the large one.
    let back = ["--method", "brute-force", "--view", "back", "--ortho", "2.4", "--size", "120x120", "--width", "3"];
    let Some(image) = picture(&folder, &[&[&far[..], &near], &back[..]].concat()) else { return };
    assert!((75..95).all(|x| image.get_pixel(x, 62).0[0] > 200));
}

#[test]
fn a_texture_is_drawn_alone_and_an_input_is_never_written_to() {
    let folder = tempfile::tempdir().unwrap();
    let [far, near] = boxes(&folder);
    let output =
        run(&["render", &far, "a.siltex", "--method", "texture", "-o", folder.path().join("x.png").to_str().unwrap()]);
    let line = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(2) && line.contains("a.siltex") && line.contains("alone"), "{line}");
    let png = folder.path().join("mesh.png");
    std::fs::copy(&near, &png).unwrap();
    let before = std::fs::read(&png).unwrap();
    let output = run(&["render", &far, png.to_str().unwrap(), "-o", png.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(std::fs::read(Path::new(&png)).unwrap(), before);
}
