//! Meshes, methods and options, from the controls to the picture.

use crate::stage::{choose, look, picture_rect, press, settle, window};
use eframe::egui::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use silhouette_compare::drawing::{FrameStyle, Ground, render_method};
use silhouette_core::{NoProgress, PreparedMesh, shapes};
use silhouette_testing::gpu_or_skip;
use silhouette_viewer::viewer::Viewer;
use std::sync::Arc;

/// Height of the caption over a picture, in pixels.
const CAPTION: u32 = 30;

/// How many pixels of the picture on screen differ from what the method draws of the same view by itself, and how many are inked.
fn unlike_the_method(window: &mut Harness<'_, Viewer>, shape: &str, name: &str) -> [usize; 2] {
    let gpu = gpu_or_skip("picture").unwrap();
    let pane = &window.state().panes()[0];
    let (method, camera, choice) = (pane.choice.name(), pane.frame().unwrap().camera, pane.choice.clone());
    let mesh = Arc::new(PreparedMesh::new(shapes::by_name(shape).unwrap()));
    let style = FrameStyle { size: camera.size(), pen_width_px: 1.5, samples: 4, ground: Ground::Paper };
    let alone = render_method(gpu, &choice.entry, &choice.values, &mesh, &camera, style, &NoProgress).unwrap().image;
    let rect = picture_rect(window, method);
    let screen = look(window, name);
    let [left, top] = [rect.min.x, rect.min.y].map(|side| side.ceil() as u32);
    assert_eq!(camera.size(), [rect.width() as u32, rect.height() as u32]);
    let pixels = (CAPTION..alone.height).flat_map(|y| (0..alone.width).map(move |x| (x, y)));
    let (mut unlike, mut inked) = (0, 0);
    for (x, y) in pixels {
        let (shown, drawn) = (screen.get_pixel(left + x, top + y).0, alone.pixel(x, y));
        unlike += usize::from(shown != drawn);
        inked += usize::from(drawn[0] < 128);
    }
    [unlike, inked]
}

#[test]
fn the_picture_is_what_the_method_draws_pixel_for_pixel() {
    let Some(mut window) = window("the_picture_is_what_the_method_draws", "builtin:torus", &["brute-force"]) else {
        return;
    };
    let [unlike, inked] = unlike_the_method(&mut window, "torus", "one_method");
    assert!(unlike == 0 && inked > 500, "{unlike} {inked}");
    // The comparison sees another mesh.
    assert!(unlike_the_method(&mut window, "cube", "one_method")[0] > 500);
}

#[test]
fn another_method_is_chosen_by_its_name_and_draws() {
    let Some(mut window) = window("another_method_is_chosen", "builtin:torus", &["brute-force"]) else { return };
    for method in ["tracking", "image-precision", "inverted-hull"] {
        choose(&mut window, "method", method);
        assert_eq!(window.state().panes()[0].choice.name(), method);
        let [unlike, inked] = unlike_the_method(&mut window, "torus", method);
        assert!(unlike == 0 && inked > 300, "{method}: {unlike} {inked}");
    }
}

#[test]
fn options_are_those_of_the_specs_and_change_the_picture() {
    let Some(mut window) = window("options_are_those_of_the_specs", "builtin:torus", &["image-precision"]) else {
        return;
    };
    let specs = window.state().panes()[0].choice.entry.info().options;
    for spec in specs {
        assert!(window.query_all_by_label(spec.name).next().is_some(), "no control for {}", spec.name);
    }
    choose(&mut window, "variant", "scale");
    let values = window.state().panes()[0].choice.values.to_string();
    assert!(values.contains("variant=scale"), "{values}");
    assert_eq!(unlike_the_method(&mut window, "torus", "variant")[0], 0);
    press(&mut window, Role::Button, "Default options");
    assert!(!window.state().panes()[0].choice.values.to_string().contains("variant=scale"));
}

#[test]
fn shapes_are_opened_from_the_menu() {
    let Some(mut window) = window("shapes_are_opened_from_the_menu", "builtin:torus", &["brute-force"]) else { return };
    window.get_by_role_and_label(Role::Button, "Shapes").click();
    window.step();
    window.step();
    window.get_by_label("gear").click();
    window.step();
    settle(&mut window);
    let [unlike, inked] = unlike_the_method(&mut window, "gear", "gear");
    assert!(unlike == 0 && inked > 500, "{unlike} {inked}");
}

#[test]
fn failures_are_in_the_command_line_s_words() {
    let Some(mut window) = window("failures_are_in_the_command_line_s_words", "missing.obj", &["brute-force"]) else {
        return;
    };
    let load = silhouettes::application::load(&"missing.obj".into(), &NoProgress).unwrap_err().to_string();
    assert!(window.query_by_label(&format!("Error: {load}")).is_some(), "{:?}", window.state().messages());
    look(&mut window, "failure");
    window.get_by_label("Dismiss").click();
    window.step();
    window.step();
    assert!(window.state().messages().all().is_empty());
}

/// A mesh that a method is not defined for: the message names mesh, method and mend, and another method draws it.
#[test]
fn a_method_that_cannot_be_prepared_says_so_and_gives_way() {
    let Some(mut window) = window("a_method_that_cannot_be_prepared", "builtin:moebius", &["tracking"]) else { return };
    let failure = window.state().panes()[0].failure().expect("a strip with one side").to_owned();
    assert!(failure.starts_with("builtin:moebius: not defined for tracking: "), "{failure}");
    assert!(window.query_by_label(&format!("Error: {failure}")).is_some());
    choose(&mut window, "method", "brute-force");
    assert!(window.state().panes()[0].failure().is_none() && window.state().panes()[0].frame().is_some());
}
