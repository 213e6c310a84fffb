//! The eye that goes round the mesh while speed is measured, and the end of that.

use super::Viewer;
use crate::background::lock;
use crate::measure::Step;
use crate::pane::Pane;
use eframe::egui;
use silhouettes::application::Failure;
use std::time::Instant;

impl Viewer {
    /// Moves the eye as a measurement wants, and ends it.
    pub(super) fn measure(&mut self, context: &egui::Context) {
        let Some(measurement) = &mut self.measurement else { return };
        context.request_repaint();
        let panes = &self.panes[..self.arrangement.panes()];
        let pictures: Vec<u64> = panes.iter().map(Pane::frames).collect();
        let are_prepared = self.opened.stage().is_none() && panes.iter().all(Pane::is_prepared);
        let failure = panes.iter().find_map(|pane| pane.failure().map(str::to_owned));
        let failure = failure.or_else(|| self.messages.first_error().map(str::to_owned));
        let outcome = match measurement.frame(Instant::now(), &pictures, are_prepared) {
            _ if failure.is_some() => failure.map(|failure| Err(Failure::Input(failure))),
            Step::Wait => None,
            Step::Turn { angle_rad } => {
                if let Some(view) = &mut self.view {
                    view.turn(angle_rad);
                }
                None
            }
            Step::End => {
                let rows: Vec<_> = panes.iter().map(|pane| (pane.choice.name(), pane.history().median_ms())).collect();
                let mesh = self.opened.shown().map(|shown| shown.named.clone());
                let of = mesh.map(|mesh| format!("{}, {} faces", mesh.name, mesh.mesh.mesh().face_count()));
                let [width, height] = self.size;
                let adapter = &self.gpu.adapter().name;
                let what = format!("{}, {width} x {height} pixels, {adapter}\n", of.unwrap_or_default());
                Some(Ok(what + &measurement.report(&rows)))
            }
        };
        if outcome.is_some() {
            *lock(&self.outcome) = outcome;
            self.measurement = None;
            context.send_viewport_cmd(egui::ViewportCommand::Close);
        }
    }
}
