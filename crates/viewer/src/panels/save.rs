//! The view as a file, and the command that writes it.

use super::progress;
use crate::background::Wake;
use crate::messages::Messages;
use crate::save::{Order, Saving, Shown, for_shell};
use eframe::egui;
use silhouette_compare::registry::Registry;

/// Shows the name of the file, what its ending means, and the command.
pub fn show(
    ui: &mut egui::Ui,
    saving: &mut Saving,
    shown: &Shown<'_>,
    registry: &Registry,
    wake: &Wake,
    messages: &mut Messages,
) {
    ui.horizontal(|ui| {
        let label = ui.label("file");
        ui.add(egui::TextEdit::singleline(&mut saving.file).hint_text("view.svg").desired_width(140.0))
            .labelled_by(label.id)
            .on_hover_text(
                ".svg, .pdf, .dxf, .json: exact visible lines; .png: the first method; .toml: a scene to compare",
            );
        if ui.button("Choose…").clicked() {
            saving.browse(wake);
        }
        if ui.add_enabled(!saving.is_busy(), egui::Button::new("Save")).clicked() {
            saving.begin(wake, registry, shown, messages);
        }
    });
    if let Some((file, stage)) = saving.stage()
        && progress(ui, &format!("writing {file}"), &stage)
    {
        saving.cancel();
    }
    if let Ok(Order::Command(words)) = shown.order(saving.file.trim())
        && !saving.file.trim().is_empty()
    {
        ui.collapsing("the same as a command", |ui| {
            let text = for_shell(&words);
            if ui.button("Copy the command").clicked() {
                ui.copy_text(text.clone());
            }
            ui.label(egui::RichText::new(text).monospace().small());
        });
    }
}
