//! Scenes, silhouette textures and turned meshes on screen.

use crate::stage::{choose, press, settle, window};
use clap::Parser;
use eframe::egui::{self, Role};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use silhouette_compare::registry::Registry;
use silhouette_compare::scene::Scene;
use silhouette_testing::shared_gpu_or_skip;
use silhouette_viewer::arguments::Arguments;
use silhouette_viewer::viewer::Viewer;
use silhouettes::execute;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A file that is dropped on the window, as the system names it.
#[derive(Debug)]
struct Dropped(PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|error| error.to_string())
    }
}

/// Drops a file on the window.
fn drop_file(window: &mut Harness<'_, Viewer>, file: &Path) {
    window.input_mut().dropped_files.push(Arc::new(Dropped(file.to_owned())));
    window.step();
    settle(window);
}

fn says(window: &Harness<'_, Viewer>, text: &str) -> bool {
    window.state().messages().all().iter().any(|message| message.text.contains(text))
}

const SCENE: &str = r#"
meshes = [{ mesh = "builtin:gear", simplify = 100 }, "part.obj"]
[path]
kind = "orbit"
projection = "orthographic"
first-azimuth-deg = 30
elevation-deg = 20
swing-deg = 5
step-deg = 3
warm-up = 0
frames = 7
scored = 2
[picture]
width = 128
height = 96
samples = 1
[pen]
width-px = 3
[[methods]]
name = "image-precision"
options = { variant = "scale" }
[[methods]]
name = "tracking"
"#;

#[test]
fn a_scene_brings_its_meshes_methods_pen_and_path() {
    let Some(mut window) = window("a_scene_brings_its_meshes", "builtin:torus", &["brute-force"]) else { return };
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.toml");
    std::fs::write(&file, SCENE).unwrap();
    std::fs::write(
        folder.path().join("part.obj"),
        "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
    )
    .unwrap();
    drop_file(&mut window, &file);
    let scene = Scene::load(&file).unwrap();
    let names: Vec<_> = window.state().panes().iter().map(|pane| pane.choice.name()).collect();
    assert_eq!(names, ["image-precision", "tracking"]);
    assert!(window.state().panes()[0].choice.values.to_string().contains("variant=scale"));
    let pen = window.state().panes()[0].frame().unwrap().pen;
    assert!((pen.width_px - 3.0).abs() < 1e-9, "{pen:?}");
    assert_eq!((window.state().path().name.as_str(), window.state().path().frames()), ("mine", 7));
    assert!(
        says(&window, "builtin:gear: is shown whole, not simplified to 100 faces"),
        "{:?}",
        window.state().messages()
    );
    // The view is that of the first frame, and steps are those of the comparison.
    let is_at = |window: &Harness<'_, Viewer>, frame: usize| {
        let view = window.state().view().unwrap();
        view.camera() == scene.path.orbit(view.camera().size()).cameras(view.bounds()).unwrap()[frame]
    };
    assert!(is_at(&window, 0) && !is_at(&window, 1));
    press(&mut window, Role::DisclosureTriangle, "Camera path");
    press(&mut window, Role::Button, "Step");
    assert!(is_at(&window, 1));
    let part = folder.path().join("part.obj").to_string_lossy().into_owned();
    press(&mut window, Role::Button, &part);
    assert!(window.query_by_label_contains("part.obj").is_some() && is_at(&window, 0));
    // One that cannot be read leaves all as it is.
    std::fs::write(&file, SCENE.replace("frames = 7", "frames = \"seven\"")).unwrap();
    drop_file(&mut window, &file);
    let error = Scene::load(&file).unwrap_err().to_string();
    assert!(says(&window, &error) && window.state().path().frames() == 7, "{:?}", window.state().messages());
}

/// A scene of the program's arguments is what a scene that is dropped is, and a method that is named beside it is shown instead.
#[test]
fn a_scene_named_at_the_start_brings_what_is_not_named_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.toml");
    std::fs::write(&file, SCENE.replace(", \"part.obj\"", "")).unwrap();
    let scene = file.to_str().unwrap();
    for (more, methods) in
        [(&[][..], &["image-precision", "tracking"][..]), (&["--method", "brute-force"], &["brute-force"])]
    {
        let words = [&["silhouettes-viewer", "--scene", scene], more].concat();
        let Some(gpu) = shared_gpu_or_skip("a_scene_named_at_the_start") else { return };
        let registry = Registry::builtin();
        let start = Arguments::try_parse_from(words).unwrap().start(&registry).unwrap();
        let builder = Harness::builder().wgpu_setup(silhouette_viewer::setup(gpu));
        let mut window =
            builder.build_eframe(|context| Viewer::new(context, Arc::clone(gpu), registry, start).unwrap());
        settle(&mut window);
        let shown: Vec<_> = window.state().panes().iter().map(|pane| pane.choice.name()).collect();
        assert_eq!(shown[..methods.len()], *methods);
        assert!(says(&window, "builtin:gear: is shown whole"), "{:?}", window.state().messages());
        let (path, view) = (window.state().path(), window.state().view().unwrap());
        assert_eq!((path.name.as_str(), path.frames(), path.is_on(view)), ("mine", 7, true));
    }
}

#[test]
fn a_silhouette_texture_is_drawn_by_methods_that_take_one() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("ball.siltex");
    let Some(mut window) = window("a_silhouette_texture_is_drawn", "builtin:torus", &["brute-force"]) else { return };
    let words = [
        "bake",
        "builtin:icosphere:2",
        "--set",
        "size=64",
        "--set",
        "azimuths=16",
        "--set",
        "hull-vertices=60",
        "-o",
        file.to_str().unwrap(),
    ];
    execute(words, &Registry::builtin()).unwrap();
    drop_file(&mut window, &file);
    let failure = window.state().panes()[0].failure().unwrap_or_default().to_owned();
    assert!(failure.contains("--method brute-force draws no silhouette textures"), "{failure}");
    choose(&mut window, "method", "texture");
    let pane = &window.state().panes()[0];
    assert!(pane.failure().is_none() && pane.frame().is_some(), "{:?}", pane.failure());
    // Saved, it is what the command line draws of the file.
    press(&mut window, Role::DisclosureTriangle, "Save");
    let [saved, again] = ["saved.png", "again.png"].map(|name| folder.path().join(name));
    window.state_mut().saving_mut().file = saved.to_string_lossy().into_owned();
    let size = window.state().panes()[0].frame().unwrap().camera.size();
    press(&mut window, Role::Button, "Save");
    let size = format!("{}x{}", size[0], size[1]);
    let words =
        ["render", file.to_str().unwrap(), "--method", "texture", "--size", &size, "-o", again.to_str().unwrap()];
    execute(words, &Registry::builtin()).unwrap();
    let [saved, again] = [saved, again].map(|path| image::open(path).unwrap().to_rgba8());
    assert!(saved == again, "pixel for pixel");
    press(&mut window, Role::DisclosureTriangle, "Truth");
    press(&mut window, Role::CheckBox, "Measure against the truth");
    assert!(says(&window, "holds no mesh to measure against"), "{:?}", window.state().messages());
}

/// A tetrahedron whose faces point inwards: noted as `render` notes it, turned where that is chosen, and saved so.
#[test]
fn parts_that_are_inside_out_are_noted_and_turned() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("inside_out.obj");
    std::fs::write(&file, "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n").unwrap();
    let Some(mut window) = window("parts_that_are_inside_out", file.to_str().unwrap(), &["brute-force"]) else {
        return;
    };
    assert!(says(&window, "4 of 4 faces are in parts that are wound inside out"), "{:?}", window.state().messages());
    window.get_by_role_and_label(Role::Button, "File").click();
    window.run_steps(2);
    window.get_by_role_and_label(Role::CheckBox, "Turn parts that are inside out").click();
    window.step();
    settle(&mut window);
    assert!(says(&window, "4 of 4 faces were turned, so that they point outwards"), "{:?}", window.state().messages());
    window.key_press(egui::Key::Escape);
    window.run_steps(2);
    press(&mut window, Role::DisclosureTriangle, "Save");
    let svg = folder.path().join("view.svg");
    window.state_mut().saving_mut().file = svg.to_string_lossy().into_owned();
    window.step();
    press(&mut window, Role::DisclosureTriangle, "the same as a command");
    assert!(window.query_all_by_label_contains("--orient").next().is_some());
    press(&mut window, Role::Button, "Save");
    // What the command would have printed as a note is in the window.
    assert!(svg.exists() && says(&window, "faces were turned"), "{:?}", window.state().messages());
}
