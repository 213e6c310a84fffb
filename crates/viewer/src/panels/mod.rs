//! What stands around the picture, one file each.

pub mod artefacts;
pub mod camera;
pub mod look;
pub mod menu;
pub mod method;
pub mod options;
pub mod path;
pub mod plots;
pub mod save;
pub mod tracks;
pub mod truth;

use crate::background::Stage;
use eframe::egui;

/// How far something is, with a button that cancels it. `true` where that was pressed.
pub fn progress(ui: &mut egui::Ui, what: &str, stage: &Stage) -> bool {
    let text = if stage.name.is_empty() { what.to_owned() } else { format!("{what}: {}", stage.name) };
    ui.label(&text);
    ui.horizontal(|ui| {
        let is_cancelled = ui.button("Cancel").on_hover_text(format!("Cancel {what}")).clicked();
        match stage.share() {
            Some(share) => drop(ui.add(egui::ProgressBar::new(share).show_percentage())),
            None => drop(ui.spinner()),
        }
        is_cancelled
    })
    .inner
}
