//! The menu bar: meshes from files and built-in shapes, how the window looks.

use crate::arrangement::Arrangement;
use eframe::egui::{self, MenuBar};
use silhouette_core::shapes;
use silhouettes::application::MeshArgument;

/// What was chosen.
pub enum Chosen {
    /// A mesh is to be opened.
    Open(MeshArgument),
    /// A file is to be asked for.
    Browse,
}

/// Shows the bar.
pub fn show(ui: &mut egui::Ui, arrangement: &mut Arrangement, shows_plots: &mut bool) -> Option<Chosen> {
    let mut chosen = None;
    MenuBar::new().ui(ui, |ui| {
        ui.menu_button("File", |ui| {
            if ui.button("Open…").clicked() {
                chosen = Some(Chosen::Browse);
            }
        });
        ui.menu_button("Shapes", |ui| {
            for shape in shapes::BUILTINS {
                if ui.button(shape.name).on_hover_text(shape.summary).clicked() {
                    chosen = Some(Chosen::Open(MeshArgument::Builtin(shape.name.to_owned())));
                }
            }
        });
        ui.menu_button("Appearance", egui::widgets::global_theme_preference_buttons);
        ui.separator();
        for (name, arranged) in Arrangement::NAMED {
            ui.radio_value(arrangement, arranged, name);
        }
        ui.separator();
        ui.checkbox(shows_plots, "plots");
    });
    chosen
}
