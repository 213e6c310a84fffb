//! The menu bar: meshes from files and built-in shapes, how the window looks.

use crate::arrangement::Arrangement;
use eframe::egui::{self, MenuBar, ThemePreference};
use silhouette_core::shapes;
use silhouettes::application::MeshArgument;

/// What was chosen.
pub enum Chosen {
    /// A mesh is to be opened.
    Open(MeshArgument),
    /// A file is to be asked for.
    Browse,
    /// The mesh on screen is to be read again, with parts that are wound inside out turned or as they are.
    Orient(bool),
}

/// How the window looks, by name.
const THEMES: [(&str, ThemePreference); 3] =
    [("as the system", ThemePreference::System), ("light", ThemePreference::Light), ("dark", ThemePreference::Dark)];

/// Shows the bar.
pub fn show(
    ui: &mut egui::Ui,
    arrangement: &mut Arrangement,
    shows_plots: &mut bool,
    mut is_oriented: bool,
) -> Option<Chosen> {
    let mut chosen = None;
    MenuBar::new().ui(ui, |ui| {
        ui.menu_button("File", |ui| {
            if ui.button("Open…").clicked() {
                chosen = Some(Chosen::Browse);
            }
            let orient = ui.checkbox(&mut is_oriented, "Turn parts that are inside out");
            if orient.on_hover_text("--orient: exact for closed parts, a guess for open ones").changed() {
                chosen = Some(Chosen::Orient(is_oriented));
            }
        });
        ui.menu_button("Shapes", |ui| {
            for shape in shapes::BUILTINS {
                if ui.button(shape.name).on_hover_text(shape.summary).clicked() {
                    chosen = Some(Chosen::Open(MeshArgument::Builtin(shape.name.to_owned())));
                }
            }
        });
        ui.menu_button("Appearance", |ui| {
            let mut preference = ui.ctx().options(|options| options.theme_preference);
            for (name, theme) in THEMES {
                if ui.radio_value(&mut preference, theme, name).clicked() {
                    ui.ctx().set_theme(theme);
                }
            }
        });
        ui.separator();
        for (name, arranged) in Arrangement::NAMED {
            ui.radio_value(arrangement, arranged, name);
        }
        ui.separator();
        ui.checkbox(shows_plots, "plots");
    });
    chosen
}
