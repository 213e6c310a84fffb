//! The camera, moved by pointer, keys and buttons; the divider.

use crate::stage::{look, picture_rect, settle, window};
use eframe::egui::{Key, Modifiers, Role, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use silhouette_core::Camera;
use silhouette_core::view::{Projection, UpAxis};
use silhouette_viewer::viewer::Viewer;

fn camera(window: &Harness<'_, Viewer>) -> Camera {
    window.state().view().unwrap().camera()
}

/// Drags over the picture.
fn drag(window: &mut Harness<'_, Viewer>, methods: &str, by: [f32; 2]) {
    let from = picture_rect(window, methods).center();
    window.hover_at(from);
    window.drag_at(from);
    window.step();
    window.hover_at(from + vec2(by[0], by[1]) * 0.5);
    window.hover_at(from + vec2(by[0], by[1]));
    window.step();
    window.drop_at(from + vec2(by[0], by[1]));
    window.step();
    settle(window);
}

#[test]
fn a_drag_turns_the_eye_and_the_picture_follows() {
    let Some(mut window) = window("a_drag_turns_the_eye", "builtin:torus", &["brute-force"]) else { return };
    let before = camera(&window);
    drag(&mut window, "brute-force", [120.0, 40.0]);
    let after = camera(&window);
    assert!(after.target() == before.target() && after.eye().distance(before.eye()) > 0.1);
    let shown = window.state().panes()[0].frame().unwrap().camera;
    assert_eq!((shown.eye(), shown.up()), (after.eye(), after.up()), "the latest view is drawn in the end");
}

#[test]
fn keys_turn_move_and_come_closer_once_the_picture_has_the_focus() {
    let Some(mut window) = window("keys_turn_move_and_come_closer", "builtin:torus", &["brute-force"]) else { return };
    let before = camera(&window);
    window.key_press(Key::ArrowLeft);
    window.step();
    assert_eq!(camera(&window), before, "the focus is elsewhere");
    window.get_by_role_and_label(Role::Canvas, "Picture of brute-force").focus();
    window.run_steps(2);
    window.key_press(Key::ArrowLeft);
    window.step();
    let turned = camera(&window);
    assert!(turned.eye() != before.eye() && turned.target() == before.target());
    window.key_press_modifiers(Modifiers::SHIFT, Key::ArrowUp);
    window.step();
    let moved = camera(&window);
    assert!(moved.target() != turned.target());
    window.key_press(Key::Plus);
    window.step();
    let distance = |camera: &Camera| camera.eye().distance(camera.target());
    assert!((distance(&camera(&window)) / distance(&moved) - 0.9).abs() < 1e-4);
}

#[test]
fn named_views_axes_and_projections_are_buttons() {
    let Some(mut window) = window("named_views_axes_and_projections", "builtin:torus", &["brute-force"]) else {
        return;
    };
    let mut press = |role, label: &str| {
        // Pictures that are still to come move controls.
        settle(&mut window);
        window.get_by_role_and_label(role, label).click();
        window.step();
        window.step();
        let view = window.state().view().unwrap();
        (view.camera(), view.up_axis)
    };
    let (front, _) = press(Role::Button, "front");
    assert!(front.eye().x.abs() < 1e-5 && front.eye().z > 1.0);
    let (_, axis) = press(Role::RadioButton, "z");
    assert_eq!(axis, UpAxis::Z);
    let (front, _) = press(Role::Button, "front");
    assert!(front.eye().y < -1.0 && front.eye().z.abs() < 1e-5, "{front:?}");
    let (flat, _) = press(Role::RadioButton, "orthographic");
    assert!(matches!(flat.projection(), Projection::Orthographic { .. }));
    settle(&mut window);
    look(&mut window, "orthographic");
}

#[test]
fn two_methods_share_the_window_and_the_divider_moves() {
    let Some(mut window) = window("two_methods_share_the_window", "builtin:knot", &["brute-force", "inverted-hull"])
    else {
        return;
    };
    let widths = |window: &Harness<'_, Viewer>| {
        let panes = window.state().panes().iter();
        panes.map(|pane| pane.frame().unwrap().camera.size()[0]).collect::<Vec<_>>()
    };
    let before = widths(&window);
    assert!(before.len() == 2 && before[0].abs_diff(before[1]) <= 1, "{before:?}");
    look(&mut window, "two_methods");
    window.get_by_role_and_label(Role::Splitter, "Divider").focus();
    window.run_steps(2);
    (0..5).for_each(|_| window.key_press(Key::ArrowRight));
    settle(&mut window);
    let after = widths(&window);
    assert!(after[0] > before[0] + 40 && after[0] + after[1] == before[0] + before[1], "{after:?}");
    window.get_by_role_and_label(Role::RadioButton, "divided picture").click();
    window.step();
    settle(&mut window);
    assert_eq!(widths(&window), [before[0] + before[1]; 2], "both draw the whole view");
    look(&mut window, "divided");
}
