//! A pane's method: which, what it is, its options, and how far it is.

use super::{options, progress};
use crate::pane::{Choice, Pane};
use eframe::egui::{self, ComboBox};
use silhouette_compare::drawing::pictures_of;
use silhouette_compare::registry::Registry;

/// Shows the choice of a method under a label, and all that is said of it.
pub fn show(ui: &mut egui::Ui, label: &str, registry: &Registry, pane: &mut Pane) {
    ui.push_id(label, |ui| {
        let chosen = pane.choice.name();
        let choice = ComboBox::new("method", label).selected_text(chosen).width(150.0);
        choice.show_ui(ui, |ui| {
            for entry in registry.entries().iter().filter(|entry| pictures_of(entry.capabilities()).next().is_some()) {
                let info = entry.info();
                let is_chosen = info.name == chosen;
                if ui.selectable_label(is_chosen, info.name).on_hover_text(info.summary).clicked() && !is_chosen {
                    pane.choice = Choice::new(entry);
                }
            }
        });
        let info = pane.choice.entry.info();
        ui.label(info.summary)
            .on_hover_text(format!("{} {}: {}", info.source.authors, info.source.year, info.source.title));
        options::show(ui, info.options, &mut pane.choice.values);
        if let Some(stage) = pane.stage()
            && progress(ui, &format!("preparing {}", pane.choice.name()), &stage)
        {
            pane.cancel();
        }
        if let Some(failure) = pane.failure() {
            ui.colored_label(ui.visuals().error_fg_color, format!("Error: {failure}"));
        }
        if let Some(frame) = pane.frame() {
            let sample = &frame.sample;
            // A line each, so that what is below does not move as numbers get longer.
            ui.label(format!("frame {:.2} ms", sample.frame_ms));
            if let (Some(extraction), Some(edges)) = (&sample.extraction, &frame.edges) {
                ui.label(format!("extraction {:.3} ms, {} edges", extraction.extract_ms, edges.len()));
            }
            if let Some(warning) = &frame.warning {
                ui.colored_label(ui.visuals().warn_fg_color, format!("Note: {warning}"));
            }
        }
    });
}
