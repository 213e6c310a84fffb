//! Frame times and errors of the last frames, as running plots.

use crate::history::History;
use eframe::egui::{self, Color32};
use egui_plot::{Legend, Line, Plot, PlotPoints};

/// Height of a plot in points.
const HEIGHT: f32 = 110.0;

/// Colours of the two panes, which stand out from either ground.
const COLORS: [Color32; 2] = [Color32::from_rgb(230, 145, 30), Color32::from_rgb(70, 150, 220)];

/// Shows both plots of the panes with these names; `error` names what is measured.
pub fn show(ui: &mut egui::Ui, panes: &[(&str, &History)], error: &str) {
    ui.columns(2, |columns| {
        plot(&mut columns[0], "frame time in ms", panes, History::times);
        plot(&mut columns[1], error, panes, History::errors);
    });
}

fn plot(ui: &mut egui::Ui, title: &str, panes: &[(&str, &History)], points: fn(&History) -> Vec<[f64; 2]>) {
    ui.label(title);
    let plot = Plot::new(title).height(HEIGHT).include_y(0.0).allow_scroll(false).allow_drag(false).allow_zoom(false);
    let plot = plot.legend(Legend::default()).show_x(false).y_axis_min_width(36.0);
    plot.show(ui, |plot| {
        for (index, (name, history)) in panes.iter().enumerate() {
            plot.line(Line::new(*name, PlotPoints::from(points(history))).color(COLORS[index]).width(1.5));
        }
    });
}
