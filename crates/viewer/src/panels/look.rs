//! The pen, and what is drawn besides methods.

use crate::pane::Look;
use eframe::egui::{self, Slider};

/// Shows the controls, which hold for all methods on screen.
pub fn show(ui: &mut egui::Ui, look: &mut Look) {
    ui.add(Slider::new(&mut look.pen_width_px, 0.1..=20.0).logarithmic(true).text("pen width").suffix(" px"));
    ui.horizontal(|ui| {
        ui.label("samples per pixel");
        for samples in [1, 4] {
            ui.radio_value(&mut look.samples, samples, samples.to_string());
        }
    });
    let layers = &mut look.layers;
    ui.horizontal(|ui| {
        ui.checkbox(&mut layers.shading, "shading");
        ui.checkbox(&mut layers.hidden, "hidden lines");
        ui.checkbox(&mut layers.creases, "creases");
    })
    .response
    .on_hover_text("Under methods that draw the inside of the mesh themselves shading and hidden lines are not seen");
    if layers.creases {
        ui.add(Slider::new(&mut layers.crease_deg, 1.0..=180.0).text("crease angle").suffix("°"));
    }
}
