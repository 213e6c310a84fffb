//! Files that the window saves, against those that the command line writes.

use crate::stage::{press, settle, window};
use eframe::egui::{Key, Modifiers, Role};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use silhouette_compare::registry::Registry;
use silhouette_compare::scene::Scene;
use silhouette_compare::scene::cells::choices;
use silhouette_viewer::viewer::Viewer;
use silhouettes::execute;
use std::path::Path;

/// Saves the view as a file, by name and button.
fn save(window: &mut Harness<'_, Viewer>, file: &Path) {
    window.state_mut().saving_mut().file = file.to_string_lossy().into_owned();
    press(window, Role::Button, "Save");
    settle(window);
    let messages = window.state().messages().all();
    assert!(messages.iter().all(|message| !message.is_error), "{messages:?}");
    assert!(file.exists(), "{messages:?}");
}

#[test]
fn drawings_and_pictures_are_those_of_the_command_line() {
    let Some(mut window) = window("drawings_and_pictures", "builtin:gear", &["image-precision"]) else { return };
    press(&mut window, Role::Button, "iso");
    press(&mut window, Role::DisclosureTriangle, "Save");
    let folder = tempfile::tempdir().unwrap();
    let [svg, png] = ["view.svg", "view.png"].map(|name| folder.path().join(name));
    // The line that says that a file was written takes room of the picture.
    let mut saved_at = |file: &Path| {
        let [width, height] = window.state().panes()[0].frame().unwrap().camera.size();
        save(&mut window, file);
        format!("{width}x{height}")
    };
    let sizes = [saved_at(&svg), saved_at(&png)];
    let again = |name: &str, size: &str, words: &[&str]| {
        let file = folder.path().join(name);
        let output = ["-o", file.to_str().unwrap()];
        let view = ["--view", "iso", "--size", size];
        execute(words.iter().chain(&["builtin:gear"]).chain(&view).chain(&output).copied(), &Registry::builtin())
            .unwrap();
        std::fs::read(file).unwrap()
    };
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    assert!(text(std::fs::read(&svg).unwrap()) == text(again("lines.svg", &sizes[0], &["lines"])), "byte for byte");
    let saved = image::open(&png).unwrap().to_rgba8();
    let method = ["render", "--method", "image-precision"];
    assert!(
        saved == image::load_from_memory(&again("render.png", &sizes[1], &method)).unwrap().to_rgba8(),
        "pixel for pixel"
    );
    let other = image::load_from_memory(&again("other.png", &sizes[1], &["render"])).unwrap().to_rgba8();
    assert!(saved != other, "another method draws another picture");
}

#[test]
fn a_scene_begins_where_the_eye_is_and_compare_repeats_it() {
    let Some(mut window) = window("a_scene_begins_where_the_eye_is", "builtin:cube", &["brute-force", "tracking"])
    else {
        return;
    };
    press(&mut window, Role::DisclosureTriangle, "Save");
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.toml");
    save(&mut window, &file);
    let scene = Scene::load(&file).unwrap();
    let names: Vec<_> = choices(&scene, &Registry::builtin()).unwrap().iter().map(|c| c.entry.info().name).collect();
    assert_eq!((names, scene.meshes[0].mesh()), (vec!["brute-force", "tracking"], "builtin:cube"));
    let view = window.state().view().unwrap();
    let first = scene.path.orbit(scene.picture.size()).cameras(view.bounds()).unwrap()[0];
    let [seen, begun] = [view.camera(), first].map(|c| (c.eye() - c.target()).normalize());
    assert!(seen.distance(begun) < 1e-4, "{seen} {begun}");
    // A small one, run to its end.
    let text = std::fs::read_to_string(&file).unwrap();
    let mut small = Scene::parse(&text, "small".to_owned()).unwrap();
    (small.picture.width, small.picture.height) = (96, 96);
    (small.path.frames, small.path.scored, small.path.warm_up) = (4, 2, 0);
    std::fs::write(&file, small.to_toml()).unwrap();
    let report = folder.path().join("report");
    let words = ["compare", "--scene", file.to_str().unwrap(), "-o", report.to_str().unwrap()];
    execute(words, &Registry::builtin()).unwrap();
    assert!(report.join("index.html").exists());
}

#[test]
fn a_place_that_cannot_be_written_to_is_said_in_the_command_line_s_words() {
    let Some(mut window) = window("a_place_that_cannot_be_written_to", "builtin:cube", &["brute-force"]) else {
        return;
    };
    press(&mut window, Role::DisclosureTriangle, "Save");
    let folder = tempfile::tempdir().unwrap();
    for name in ["missing/view.svg", "missing/view.toml"] {
        let file = folder.path().join(name).to_string_lossy().into_owned();
        window.state_mut().saving_mut().file = file.clone();
        press(&mut window, Role::Button, "Save");
        let said = window.state().messages().all().last().unwrap().clone();
        assert!(said.is_error && said.text.contains(&file) && said.text.contains("cannot be written"), "{said:?}");
        assert!(window.query_by_label(&format!("Error: {}", said.text)).is_some());
    }
}

/// What was there before stays, and nothing else.
#[test]
fn a_file_that_is_cancelled_is_not_written() {
    let Some(mut window) = window("a_file_that_is_cancelled", "builtin:blob:50000", &["brute-force"]) else { return };
    press(&mut window, Role::DisclosureTriangle, "Save");
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("view.svg");
    std::fs::write(&file, "before").unwrap();
    window.state_mut().saving_mut().file = file.to_string_lossy().into_owned();
    window.get_by_role_and_label(Role::Button, "Save").click();
    window.step();
    assert!(window.state().is_busy());
    window.state_mut().saving_mut().cancel();
    settle(&mut window);
    let messages = window.state().messages().all();
    assert!(messages.iter().any(|message| message.text.ends_with("cancelled, not written")), "{messages:?}");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "before");
    assert_eq!(folder.path().read_dir().unwrap().count(), 1);
}

/// What the command line prints as a note is shown in the window.
#[test]
fn notes_of_commands_are_in_the_window() {
    let Some(mut window) = window("notes_of_commands", "builtin:torus", &["brute-force"]) else { return };
    press(&mut window, Role::DisclosureTriangle, "Save");
    // Moved out of the picture, the mesh leaves no line to draw.
    window.get_by_role_and_label(Role::Canvas, "Picture of brute-force").focus();
    window.run_steps(2);
    (0..200).for_each(|_| window.key_press_modifiers(Modifiers::SHIFT, Key::ArrowLeft));
    settle(&mut window);
    let folder = tempfile::tempdir().unwrap();
    save(&mut window, &folder.path().join("empty.svg"));
    let messages = window.state().messages().all();
    assert!(
        messages.iter().any(|message| message.text.contains("no line lies in the view: all of the mesh lies left")),
        "{messages:?}"
    );
}
