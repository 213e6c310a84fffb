//! [`Flicker`]: strokes that appeared or vanished stay visible for a moment.

use crate::viewport::Room;
use eframe::egui::{self, Color32, Shape, Stroke};
use silhouette_core::{Camera, EdgeId, SilhouetteEdges};
use std::time::{Duration, Instant};

/// How long a stroke stays visible.
const STAYS: Duration = Duration::from_millis(700);

/// At most so many strokes are shown, the latest.
const MOST: usize = 4000;

/// An edge that appeared or vanished.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// The edge.
    pub edge: EdgeId,
    /// Whether it appeared, or else vanished.
    pub appeared: bool,
    since: Instant,
}

/// Strokes that appeared or vanished a moment ago.
#[derive(Debug, Clone, Default)]
pub struct Flicker {
    last: Option<SilhouetteEdges>,
    changes: Vec<Change>,
}

impl Flicker {
    /// Compares the edges of a frame with those of the last.
    pub fn follow(&mut self, edges: &SilhouetteEdges, now: Instant) {
        if let Some(last) = &self.last {
            let change = |appeared| move |edge| Change { edge, appeared, since: now };
            let appeared = edges.iter().filter(|&edge| !last.contains(edge)).map(change(true));
            let vanished = last.iter().filter(|&edge| !edges.contains(edge)).map(change(false));
            self.changes.extend(appeared.chain(vanished));
        }
        self.changes.retain(|change| now.duration_since(change.since) < STAYS);
        let surplus = self.changes.len().saturating_sub(MOST);
        self.changes.drain(..surplus);
        self.last = Some(edges.clone());
    }

    /// Forgets all, as frames to come are no sequels of those before.
    pub fn clear(&mut self) {
        *self = Self::default();
    }

    /// What is visible at a moment, each with how much of it is left, from 1 down to 0.
    pub fn visible(&self, now: Instant) -> impl Iterator<Item = (Change, f32)> + '_ {
        self.changes.iter().filter_map(move |&change| {
            let left = 1.0 - now.duration_since(change.since).as_secs_f32() / STAYS.as_secs_f32();
            (left > 0.0).then_some((change, left))
        })
    }

    /// Draws it over a picture: what appeared in green, what vanished in orange. `ends` are the end points of an edge.
    pub fn draw(
        &self,
        ui: &egui::Ui,
        room: &Room,
        place: usize,
        camera: &Camera,
        ends: impl Fn(EdgeId) -> [glam::DVec3; 2],
    ) {
        let painter = room.painter(ui, place);
        let mut is_any = false;
        for (change, left) in self.visible(Instant::now()) {
            is_any = true;
            let color = if change.appeared { Color32::from_rgb(20, 150, 60) } else { Color32::from_rgb(235, 120, 0) };
            let [from, to] = ends(change.edge).map(|end| camera.project(end));
            if let (Some(from), Some(to)) = (from, to) {
                let ends = [from, to].map(|end| room.point(place, end.pixel));
                painter.add(Shape::line_segment(ends, Stroke::new(3.0, color.gamma_multiply(left))));
            }
        }
        if is_any {
            ui.ctx().request_repaint();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edges(ids: &[u32]) -> SilhouetteEdges {
        let mut edges = SilhouetteEdges::default();
        edges.refill_ascending(ids.iter().map(|&id| EdgeId::new(id)));
        edges
    }

    #[test]
    fn what_changes_from_frame_to_frame_is_visible_for_a_moment() {
        let (begin, mut flicker) = (Instant::now(), Flicker::default());
        flicker.follow(&edges(&[1, 2, 3]), begin);
        assert_eq!(flicker.visible(begin).count(), 0, "the first frame changes nothing");
        flicker.follow(&edges(&[2, 3, 5]), begin);
        let seen: Vec<_> = flicker.visible(begin).map(|(change, _)| (change.edge.get(), change.appeared)).collect();
        assert_eq!(seen, [(5, true), (1, false)]);
        let later = flicker.visible(begin + STAYS / 2).map(|(_, left)| left).fold(0.0, f32::max);
        assert!((later - 0.5).abs() < 1e-3);
        assert_eq!(flicker.visible(begin + STAYS).count(), 0);
        flicker.follow(&edges(&[2, 3, 5]), begin + STAYS * 2);
        assert_eq!(flicker.visible(begin).count(), 0, "it is forgotten");
    }
}
