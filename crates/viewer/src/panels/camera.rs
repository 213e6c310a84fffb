//! The camera: named views, up axis, projection, in the command line's terms.

use crate::messages::Messages;
use crate::view::{FOV_DEG, View};
use eframe::egui::{self, Slider};
use silhouette_core::view::{UpAxis, ViewPreset};

/// Shows the camera's controls.
pub fn show(ui: &mut egui::Ui, view: &mut View, messages: &mut Messages) {
    ui.horizontal_wrapped(|ui| {
        for (name, preset) in ViewPreset::NAMED {
            if ui.button(name).clicked()
                && let Err(failure) = view.name(preset)
            {
                messages.error(failure);
            }
        }
    });
    ui.horizontal(|ui| {
        ui.label("up axis");
        for (name, axis) in [("y", UpAxis::Y), ("z", UpAxis::Z)] {
            if ui.radio(view.up_axis == axis, name).clicked() && view.up_axis != axis {
                view.up_axis = axis;
                if let Err(failure) = view.name(ViewPreset::default()) {
                    messages.error(failure);
                }
            }
        }
    });
    ui.horizontal_wrapped(|ui| {
        ui.label("projection");
        for (name, is_wanted) in [("perspective", false), ("orthographic", true)] {
            if ui.radio(view.is_orthographic() == is_wanted, name).clicked() {
                view.set_orthographic(is_wanted);
            }
        }
    });
    if !view.is_orthographic() {
        let mut fov_deg = view.fov_deg();
        if ui.add(Slider::new(&mut fov_deg, FOV_DEG).text("fov").suffix("°")).changed() {
            view.set_fov(fov_deg);
        }
    }
}
