//! The camera path: play, step, scrub.

use crate::messages::Messages;
use crate::path::Path;
use crate::scenes::ShownScene;
use crate::view::View;
use eframe::egui::{self, Slider};
use silhouette_compare::Profile;
use silhouettes::application::MeshArgument;

/// The meshes of a scene, as buttons. The one that was pressed.
pub fn meshes(ui: &mut egui::Ui, scene: &ShownScene) -> Option<MeshArgument> {
    let mut chosen = None;
    ui.horizontal_wrapped(|ui| {
        ui.label(format!("meshes of {}", scene.scene.name));
        for mesh in scene.meshes() {
            if ui.button(mesh.to_string()).clicked() {
                chosen = Some(mesh);
            }
        }
    });
    chosen
}

/// Shows the controls of the path.
pub fn show(ui: &mut egui::Ui, path: &mut Path, view: &mut View, messages: &mut Messages) {
    ui.horizontal(|ui| {
        ui.label(format!("{} · {} frames", path.name, path.frames()));
        for (name, profile) in Profile::NAMED {
            if ui.button(name).on_hover_text(format!("The path of the profile {name}")).clicked() {
                *path = Path::of(&profile.scene());
            }
        }
    });
    let mut target = None;
    ui.horizontal(|ui| {
        let is_playing = path.is_playing();
        if ui.button("Step back").clicked() {
            target = Some(i64::from(path.frame()) - 1);
        }
        if ui.button(if is_playing { "Pause" } else { "Play" }).clicked() {
            path.play(!is_playing);
        }
        if ui.button("Step").clicked() {
            target = Some(i64::from(path.frame()) + 1);
        }
    });
    let mut frame = path.frame();
    let last = path.frames().saturating_sub(1);
    if ui.add(Slider::new(&mut frame, 0..=last).text("frame")).changed() {
        target = Some(i64::from(frame));
    }
    if let Some(target) = target {
        path.play(false);
        if let Err(error) = path.go_to(target, view) {
            messages.error(error);
        }
    }
}
