//! Every control has a label and is reached by Tab.

use crate::stage::{press, settle, window_of};
use eframe::egui::{Key, Role, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use silhouette_viewer::viewer::Viewer;
use std::collections::BTreeSet;

/// What is worked by a hand or by keys.
const CONTROLS: [Role; 10] = [
    Role::Button,
    Role::CheckBox,
    Role::RadioButton,
    Role::Slider,
    Role::SpinButton,
    Role::ComboBox,
    Role::TextInput,
    Role::DisclosureTriangle,
    Role::Canvas,
    Role::Splitter,
];

/// A control on screen.
struct Control {
    id: String,
    role: Role,
    label: String,
    is_focused: bool,
}

impl Control {
    /// What a message calls it.
    fn name(&self) -> String {
        format!("{:?} {}", self.role, self.label)
    }
}

/// Every control that is enabled.
fn controls(window: &Harness<'_, Viewer>) -> Vec<Control> {
    let nodes = window.root().children_recursive();
    let nodes = nodes.map(|node| node.accesskit_node()).filter(|node| CONTROLS.contains(&node.role()));
    let enabled = nodes.filter(|node| !node.is_disabled());
    let control = |node: egui_kittest::kittest::AccessKitNode<'_>| Control {
        id: format!("{:?}", node.id()),
        role: node.role(),
        label: node.label().unwrap_or_default(),
        is_focused: node.is_focused_in_tree(),
    };
    enabled.map(control).collect()
}

#[test]
fn every_control_has_a_label_and_is_reached_by_tab() {
    let build = |builder: egui_kittest::HarnessBuilder<Viewer>| builder.with_size(Vec2::new(1100.0, 2000.0));
    let methods = ["image-precision", "tracking"];
    let Some(mut window) = window_of("every_control_has_a_label", "builtin:torus", &methods, build) else { return };
    let folded = ["Pen and layers", "Camera path", "Truth", "Loops and flicker", "Artefacts", "Save"];
    folded.iter().for_each(|title| press(&mut window, Role::DisclosureTriangle, title));
    for label in ["plots", "creases", "Track loops", "Measure against the truth"] {
        press(&mut window, Role::CheckBox, label);
    }
    let all = controls(&window);
    assert!(all.len() > 60, "{}", all.len());
    let unlabelled: Vec<_> = all.iter().filter(|control| control.label.trim().is_empty()).map(Control::name).collect();
    assert!(unlabelled.is_empty(), "{unlabelled:?}");
    // Tab is pressed until the focus is where it was first.
    let mut reached = BTreeSet::new();
    for _ in 0..2 * all.len() {
        window.key_press(Key::Tab);
        window.run_steps(2);
        if let Some(focused) = controls(&window).into_iter().find(|control| control.is_focused) {
            reached.insert(focused.id);
        }
    }
    let missed: Vec<_> = all.iter().filter(|control| !reached.contains(&control.id)).map(Control::name).collect();
    assert!(missed.is_empty(), "not reached by Tab: {missed:?}");
    settle(&mut window);
}

/// What the menus hold, once they are open.
#[test]
fn what_is_in_menus_has_labels() {
    let build = |builder: egui_kittest::HarnessBuilder<Viewer>| builder.with_size(Vec2::new(900.0, 900.0));
    let Some(mut window) = window_of("what_is_in_menus_has_labels", "builtin:torus", &["brute-force"], build) else {
        return;
    };
    let before = controls(&window).len();
    for menu in ["File", "Shapes", "Appearance"] {
        window.get_by_role_and_label(Role::Button, menu).click();
        window.run_steps(3);
        let open = controls(&window);
        assert!(open.len() > before, "{menu} opens");
        let unlabelled: Vec<_> =
            open.iter().filter(|control| control.label.trim().is_empty()).map(Control::name).collect();
        assert!(unlabelled.is_empty(), "{menu}: {unlabelled:?}");
        window.key_press(Key::Escape);
        window.run_steps(3);
    }
}
