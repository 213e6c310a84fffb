//! What the picture on screen scores against the truth.

use super::progress;
use crate::truth::{Measured, Score};
use eframe::egui::{self, Color32};
use silhouette_compare::metrics::METRICS;
use silhouette_compare::metrics::PictureKind;
use silhouette_compare::metrics::table::find;
use silhouette_compare::picture::{MISSED, SPURIOUS};

/// Shows the switch and how far measuring is.
pub fn show(ui: &mut egui::Ui, measured: &mut Measured) {
    let switch = ui.checkbox(&mut measured.is_on, "Measure against the truth");
    if switch.on_hover_text("Finds the exact visible lines of every view on screen, or its true surface").changed() {
        measured.is_over = measured.is_on;
    }
    ui.add_enabled_ui(measured.is_on, |ui| {
        ui.checkbox(&mut measured.is_over, "Show missed and spurious");
        ui.horizontal(|ui| {
            for ([r, g, b, _], word) in [(MISSED, "missed"), (SPURIOUS, "spurious")] {
                ui.label(
                    egui::RichText::new(format!(" {word} "))
                        .color(Color32::WHITE)
                        .background_color(Color32::from_rgb(r, g, b)),
                );
            }
        });
    });
    if let Some(failure) = measured.failure() {
        ui.colored_label(ui.visuals().error_fg_color, format!("Error: {failure}"));
    }
    if let Some(stage) = measured.stage()
        && progress(ui, "measuring", &stage)
    {
        measured.cancel();
    }
}

/// Shows what one picture scored.
pub fn figures(ui: &mut egui::Ui, method: &str, score: Option<&Score>) {
    let Some(score) = score else {
        ui.label(format!("{method}: this view is not measured yet"));
        return;
    };
    let kind = score.metrics.kind();
    let leading: &[&str] = match kind {
        PictureKind::Lines => &["missed_1px", "spurious_1px", "chamfer_px"],
        PictureKind::Fill => &["xor_share", "boundary_chamfer_px"],
    };
    ui.strong(method);
    for spec in leading.iter().filter_map(|name| find(name)) {
        let Some(value) = (spec.value)(&score.metrics) else { continue };
        let length = score.true_length_px.filter(|_| spec.name == "missed_1px");
        let of = length.map(|length| format!(" ({:.0} of {length:.0} px)", value * length)).unwrap_or_default();
        ui.label(format!("{}: {}{of}", spec.title, in_unit(value, spec.unit))).on_hover_text(spec.summary);
    }
    ui.push_id(method, |ui| {
        ui.collapsing("all measures", |ui| {
            for spec in METRICS.iter().filter(|spec| spec.kind == kind) {
                if let Some(value) = (spec.value)(&score.metrics) {
                    ui.label(format!("{}: {}", spec.title, in_unit(value, spec.unit))).on_hover_text(spec.summary);
                }
            }
        });
    });
}

/// A value with its unit; shares as percentages.
fn in_unit(value: f64, unit: &str) -> String {
    if unit == "share" { format!("{:.2} %", 100.0 * value) } else { format!("{value:.3} {unit}") }
}
