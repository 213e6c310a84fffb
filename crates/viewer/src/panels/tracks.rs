//! Loops by their identity: colours over the picture, and what happens to them.

use super::progress;
use crate::tracks::{Loops, Tracked};
use crate::viewport::Room;
use eframe::egui::{self, Color32, Shape, Stroke, ecolor::Hsva};
use silhouette_core::Camera;
use silhouette_tracking::LoopId;

/// Shows the switch, the loops of the view and the events.
pub fn show(ui: &mut egui::Ui, tracked: &mut Tracked) {
    let hover =
        "Follows the loops of the silhouette from view to view, hidden parts too, and gives each a colour of its own";
    ui.checkbox(&mut tracked.is_on, "Track loops").on_hover_text(hover);
    if !tracked.is_on {
        return;
    }
    if let Some(failure) = tracked.failure() {
        ui.colored_label(ui.visuals().error_fg_color, format!("Error: {failure}"));
    }
    let Some(loops) = tracked.loops() else {
        if let Some(stage) = tracked.stage()
            && progress(ui, "preparing tracking-exact", &stage)
        {
            tracked.is_on = false;
        }
        return;
    };
    ui.label(format!("{} loops in this view", loops.loops.len()));
    if ui.button("Clear events").clicked() {
        tracked.events.clear();
    }
    egui::ScrollArea::vertical().id_salt("events").max_height(130.0).stick_to_bottom(true).show(ui, |ui| {
        for event in tracked.events.all() {
            ui.label(event);
        }
    });
}

/// Draws the loops over a picture, as its camera sees them.
pub fn draw(ui: &egui::Ui, room: &Room, place: usize, camera: &Camera, loops: &Loops) {
    let painter = room.painter(ui, place);
    for tracked in &loops.loops {
        let stroke = Stroke::new(2.5, color(tracked.id));
        let seen: Vec<_> = tracked.points.iter().map(|point| camera.project(point.as_dvec3())).collect();
        let next = seen.iter().cycle().skip(1);
        for (from, to) in seen.iter().zip(next) {
            // What reaches behind the eye is left out.
            if let (Some(from), Some(to)) = (from, to) {
                let ends = [from, to].map(|end| room.point(place, end.pixel));
                painter.add(Shape::line_segment(ends, stroke));
            }
        }
    }
}

/// Colours of ids that follow each other are far apart on the circle of hues.
fn color(id: LoopId) -> Color32 {
    const GOLDEN: f64 = 0.618_033_988_749_895;
    let hue = (id.get() as f64 * GOLDEN + 0.02).fract() as f32;
    Hsva::new(hue, 0.85, 0.8, 1.0).into()
}
